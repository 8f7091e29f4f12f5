#include "Core/authalic/EarsOnCircle.h"

#include <cmath>

#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr double kFullCircle = 6.283185307179586;
constexpr int kRounds = 2;  // the whole area depends on the ears, a little

// From p counter-clockwise to q, in [0, 2π).
double arc(const Points2& image, int p, int q) {
  const double turn = std::atan2(image(p, 0) * image(q, 1) - image(p, 1) * image(q, 0), image.row(p).dot(image.row(q)));
  return turn < 0 ? turn + kFullCircle : turn;
}

void placeTip(Points2& image, const EarOnCircle& ear, double fromBase) {
  const double c = std::cos(fromBase), s = std::sin(fromBase), x = image(ear.from, 0), y = image(ear.from, 1);
  image.row(ear.tip) << c * x - s * y, s * x + c * y;
}

}  // namespace

EarsOnCircle::EarsOnCircle(const Faces& faces, const std::vector<char>& onCircle) {
  const auto at = [](int v) { return static_cast<std::size_t>(v); };
  std::vector<int> valence(onCircle.size(), 0);
  for (Eigen::Index c = 0; c < faces.size(); ++c) ++valence[at(faces.data()[c])];
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const EarOnCircle ear{faces(f, k), faces(f, (k + 2) % 3), faces(f, (k + 1) % 3)};
      const bool inscribed = onCircle[at(ear.tip)] && onCircle[at(ear.from)] && onCircle[at(ear.to)];
      if (inscribed && valence[at(ear.tip)] == 1) ears_.push_back(ear);
    }
  }
}

void EarsOnCircle::centreTips(Points2& image) const {
  for (const EarOnCircle& ear : ears_) placeTip(image, ear, 0.5 * arc(image, ear.from, ear.to));
}

void EarsOnCircle::easeTips(Points2& image, const Faces& faces, const Eigen::VectorXd& vertexShares) const {
  for (int round = 0; round < kRounds && !ears_.empty(); ++round) {
    const double whole = signedFaceAreas(image, faces).sum();
    for (const EarOnCircle& ear : ears_) {
      const double half = 0.5 * arc(image, ear.from, ear.to), area = 3 * vertexShares[ear.tip] * whole;
      const double side = arc(image, ear.from, ear.tip) > half ? 1 : -1;
      const double cosine = std::cos(half) + area / std::sin(half);  // of the arc from the middle to the tip
      placeTip(image, ear, cosine < 1 ? half + side * std::acos(cosine) : half);
    }
  }
}

}  // namespace authalic
