#include "Core/imaging/CerebralPrior.h"

#include <array>
#include <cmath>

namespace authalic {

namespace {

// Even-odd rule on the sagittal outline (y, z) below the corpus callosum: splenium, body, genu, rostrum,
// chiasm, midbrain.
bool inSagittalOutline(double y, double z) {
  static constexpr std::array<std::array<double, 2>, 13> outline{{{-37, 13},
                                                                  {-33, 20},
                                                                  {-20, 26},
                                                                  {0, 28},
                                                                  {20, 24},
                                                                  {31, 14},
                                                                  {32, 4},
                                                                  {24, -2},
                                                                  {8, -4},
                                                                  {2, -9},
                                                                  {-10, -11},
                                                                  {-22, -11},
                                                                  {-33, -6}}};
  bool inside = false;
  for (std::size_t a = 0, b = outline.size() - 1; a < outline.size(); b = a++) {
    const auto &p = outline[a], &q = outline[b];
    if ((p[1] > z) != (q[1] > z) && y < p[0] + (z - p[1]) / (q[1] - p[1]) * (q[0] - p[0])) inside = !inside;
  }
  return inside;
}

bool inEllipsoid(const Eigen::Vector3d& p, const Eigen::Vector3d& centre, const Eigen::Vector3d& axes) {
  return (p - centre).cwiseQuotient(axes).squaredNorm() < 1;
}

double midbrainPlane(double y) {
  return -10.0 - 0.08 * (y + 16.0);
}

}  // namespace

bool inDeepFill(const Eigen::Vector3d& frame) {
  const Eigen::Vector3d p(std::abs(frame[0]), frame[1], frame[2]);
  return (p[0] < 14 && inSagittalOutline(p[1], p[2])) || inEllipsoid(p, {24, 3, 2}, {10, 18, 12}) ||
         inEllipsoid(p, {12, -17, 8}, {12, 15, 11}) || inEllipsoid(p, {13, 14, 10}, {7, 14, 13});
}

bool inLateralFill(const Eigen::Vector3d& frame) {
  return inEllipsoid({std::abs(frame[0]), frame[1], frame[2]}, {28, 3, 2}, {13, 24, 18});
}

bool inHindbrainCore(const Eigen::Vector3d& frame) {
  const Eigen::Vector3d p(std::abs(frame[0]), frame[1], frame[2]);
  const bool midbrain = p[0] < 16 && p[1] > -40 && p[1] < 0 && p[2] < midbrainPlane(p[1]) && p[2] > -20;
  const bool pons = p[0] < 12 && p[1] > -45 && p[1] < -8 && p[2] <= -20;
  const bool chiasm = p[0] < 10 && p[1] > -9 && p[1] < 9 && p[2] > -26 && p[2] < -11.5;
  return midbrain || pons || chiasm || inEllipsoid(p, {0, -58, -38}, {34, 20, 14});
}

bool inCerebrumCore(const Eigen::Vector3d& frame) {
  const Eigen::Vector3d p(std::abs(frame[0]), frame[1], frame[2]);
  const bool above = p[2] > 8 || (p[2] > midbrainPlane(p[1]) + 1 && p[1] > -38);
  const bool temporal = (p[0] > 26 && p[1] > -18) || (p[0] > 45 && p[2] > -16);
  const bool front = p[1] > 16 || (p[1] > 6 && (p[0] > 14 || p[2] > -11));
  return above || temporal || front || (p[1] < -60 && p[2] > -4);
}

}  // namespace authalic
