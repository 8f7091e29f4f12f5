#include "Core/distortion/MeasuredImage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <string>

#include "Core/base/Error.h"

namespace authalic {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A triangle laid into the plane: corners (0, 0), (x1, 0), (x2, y2).
struct FlatTriangle {
  double x1, x2, y2;
};

Eigen::Vector3d pointOf(const Points3& points, int vertex) { return points.row(vertex).transpose(); }

FlatTriangle flatten(const Points3& points, const Faces& faces, int face) {
  const Eigen::Vector3d origin = pointOf(points, faces(face, 0));
  const Eigen::Vector3d e1 = pointOf(points, faces(face, 1)) - origin, e2 = pointOf(points, faces(face, 2)) - origin;
  const double length = e1.norm();
  return length > 0 ? FlatTriangle{length, e1.dot(e2) / length, e1.cross(e2).norm() / length}
                    : FlatTriangle{0, e2.norm(), 0};
}

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

struct Shares {
  Eigen::VectorXd surface, target, image;  ///< total 1 each; image signed, its absolute values have total 1
  double scale;  ///< of the flat image triangles, so that their total area is that of the surface; 0 when
                 ///< they have none
  double sign;   ///< orientation of the majority of image faces
};

void requireTarget(const TriangleMesh& surface, const Eigen::VectorXd& target) {
  if (target.size() == 0) return;
  if (target.size() != surface.faceCount()) {
    throw GeometryError("One target measure per face is required: the surface has " +
                        std::to_string(surface.faceCount()) + " faces, the target " +
                        std::to_string(target.size()) + " values.");
  }
  if (!target.allFinite() || target.minCoeff() < 0 || !(target.sum() > 0)) {
    throw GeometryError("Finite target measures, none negative and not all zero, are required.");
  }
}

Shares computeShares(const TriangleMesh& surface, const MeasuredImage& image, const Eigen::VectorXd& target) {
  const int m = surface.faceCount();
  Shares shares{Eigen::VectorXd(m), target, image.areas, 0, majoritySign(image.areas)};
  for (int f = 0; f < m; ++f) {
    const FlatTriangle t = flatten(surface.points(), surface.faces(), f);
    shares.surface[f] = 0.5 * t.x1 * t.y2;
  }
  const double surfaceArea = shares.surface.sum(), imageArea = image.areas.cwiseAbs().sum();
  const double flatArea = image.flatAreas.cwiseAbs().sum();
  if (!(surfaceArea > 0)) throw GeometryError("A surface with positive area is required, but it has none.");
  shares.scale = flatArea > 0 ? std::sqrt(surfaceArea / flatArea) : 0.0;
  shares.surface /= surfaceArea;
  shares.image *= imageArea > 0 ? shares.sign / imageArea : 0.0;
  if (target.size() == 0) {
    shares.target = shares.surface;
  } else {
    shares.target /= target.sum();
  }
  return shares;
}

/// σ1, σ2 and μ from f_z and f_z̄ of the affine face map: σ = |f_z| ± |f_z̄|. A mirrored image is mirrored back
/// first, so that only folded faces have |μ| > 1.
void measureJacobian(const TriangleMesh& surface, const MeasuredImage& image, const Shares& shares, int f,
                     DistortionArrays& arrays) {
  arrays.sigmaMax[f] = arrays.sigmaMin[f] = arrays.angleDistortion[f] = kNaN;
  arrays.beltrami[f] = {kNaN, kNaN};
  const FlatTriangle t = flatten(surface.points(), surface.faces(), f);
  if (!(t.x1 * t.y2 > 0) || !(shares.scale > 0)) return;
  const FlatTriangle u = flatten(image.points, surface.faces(), f);
  const double height = u.x1 > 0 ? 2 * shares.sign * image.flatAreas[f] / u.x1 : 0;
  const std::complex<double> e1(shares.scale * u.x1, 0), e2(shares.scale * u.x2, shares.scale * height);
  const std::complex<double> i(0, 1), byX = e1 / t.x1, byY = (e2 - byX * t.x2) / t.y2;
  const std::complex<double> fz = 0.5 * (byX - i * byY), fzBar = 0.5 * (byX + i * byY);
  const double larger = std::abs(fz) + std::abs(fzBar), smaller = std::abs(fz) - std::abs(fzBar);
  arrays.sigmaMax[f] = larger;
  arrays.sigmaMin[f] = smaller;
  if (smaller != 0) arrays.angleDistortion[f] = larger / std::abs(smaller) + std::abs(smaller) / larger;
  if (std::abs(fz) > 0) arrays.beltrami[f] = fzBar / fz;
}

/// Sum over the corners of |image angle − surface angle| in radians.
double measureCorners(const TriangleMesh& surface, const MeasuredImage& image, int f, DistortionArrays& arrays) {
  double error = 0;
  for (int k = 0; k < 3; ++k) {
    const int a = surface.faces()(f, k), b = surface.faces()(f, (k + 1) % 3), c = surface.faces()(f, (k + 2) % 3);
    const double before = angleBetween(surface.point(b) - surface.point(a), surface.point(c) - surface.point(a));
    const Eigen::Vector3d corner = pointOf(image.points, a);
    const double after = angleBetween(pointOf(image.points, b) - corner, pointOf(image.points, c) - corner);
    arrays.cornerLogAngleRatio(f, k) = before > 0 && after > 0 ? std::log(after / before) : kNaN;
    arrays.cornerAngleError(f, k) = (after - before) * 180 / M_PI;
    error += std::abs(after - before);
  }
  return error;
}

void measureVertices(const TriangleMesh& surface, const MeasuredImage& measured, const Shares& shares,
                     Distortion& result) {
  const int n = surface.vertexCount();
  const auto original = [&](int v) { return measured.originals.empty() ? v : measured.originals[std::size_t(v)]; };
  Eigen::VectorXd image = Eigen::VectorXd::Zero(n), target = Eigen::VectorXd::Zero(n);
  for (int f = 0; f < surface.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      image[original(surface.faces()(f, k))] += std::abs(shares.image[f]) / 3;
      target[original(surface.faces()(f, k))] += shares.target[f] / 3;
    }
  }
  int counted = 0;
  Eigen::VectorXd ratios = Eigen::VectorXd::Constant(n, kNaN);
  for (int i = 0; i < n; ++i) {
    if (!(image[i] > 0) || !(target[i] > 0)) continue;
    const double p = std::log(image[i] / target[i]);
    ratios[i] = p;
    result.summary.vertexMeanAbsLog += std::abs(p);
    result.summary.vertexMaxAbsLog = std::max(result.summary.vertexMaxAbsLog, std::abs(p));
    ++counted;
  }
  if (counted > 0) result.summary.vertexMeanAbsLog /= counted;
  result.arrays.vertexLogAreaRatio.resize(n);
  for (int v = 0; v < n; ++v) result.arrays.vertexLogAreaRatio[v] = ratios[original(v)];
}

/// Returns whether the face has an area ratio that can enter the sums.
bool addAreas(const Shares& shares, int f, Distortion& result) {
  DistortionSummary& s = result.summary;
  const double rho = shares.target[f], q = shares.image[f], r = rho > 0 ? q / rho : kNaN;
  result.arrays.areaRatio[f] = r;
  result.arrays.logAreaRatio[f] = rho > 0 && q != 0 ? std::log2(std::abs(r)) : kNaN;
  result.arrays.flipped[f] = !(q > 0);
  s.flippedFaces += result.arrays.flipped[f];
  s.areaErrorL2 += (q - rho) * (q - rho);
  if (!(rho > 0) || q == 0) return false;
  const double size = std::abs(r), log = std::abs(std::log(size));
  s.areaDistortion += rho * (size + 1 / size);
  s.faceMeanAbsLog += log;
  s.faceMaxAbsLog = std::max(s.faceMaxAbsLog, log);
  s.faceStandardDeviation += rho * (size - 1) * (size - 1);
  return true;
}

/// Returns whether the face has singular values that can enter the sums.
bool addAngles(const Shares& shares, int f, Distortion& result) {
  const double s1 = result.arrays.sigmaMax[f], s2 = std::abs(result.arrays.sigmaMin[f]), share = shares.surface[f];
  if (!(s2 > 0)) return false;
  DistortionSummary& s = result.summary;
  s.angleDistortion += share * (s1 / s2 + s2 / s1);
  s.symmetricDirichlet += share * (s1 * s1 + 1 / (s1 * s1) + s2 * s2 + 1 / (s2 * s2));
  s.asRigidAsPossible += share * ((s1 - 1) * (s1 - 1) + (s2 - 1) * (s2 - 1));
  s.meanQuasiConformal += s1 / s2;
  s.meanBeltrami += (s1 - s2) / (s1 + s2);
  return true;
}

void resize(DistortionArrays& arrays, int m) {
  for (Eigen::VectorXd* column : {&arrays.areaRatio, &arrays.logAreaRatio, &arrays.sigmaMax, &arrays.sigmaMin,
                                  &arrays.angleDistortion}) {
    column->resize(m);
  }
  arrays.beltrami.resize(m);
  arrays.cornerLogAngleRatio.resize(m, 3);
  arrays.cornerAngleError.resize(m, 3);
  arrays.flipped.resize(m);
}

}  // namespace

void requireImagePerVertex(const TriangleMesh& surface, Eigen::Index imagePoints) {
  if (imagePoints == surface.vertexCount()) return;
  throw GeometryError("One image point per vertex is required: the surface has " +
                      std::to_string(surface.vertexCount()) + " vertices, the image " + std::to_string(imagePoints) +
                      " points.");
}

double majoritySign(const Eigen::VectorXd& signedAreas) {
  return 2 * (signedAreas.array() < 0).count() > signedAreas.size() ? -1.0 : 1.0;
}

Distortion measureImage(const TriangleMesh& surface, const MeasuredImage& image, const Eigen::VectorXd& target) {
  requireTarget(surface, target);
  const Shares shares = computeShares(surface, image, target);
  const int m = surface.faceCount();
  Distortion result;
  resize(result.arrays, m);
  DistortionSummary& s = result.summary;
  int withArea = 0, withAngles = 0;
  for (int f = 0; f < m; ++f) {
    s.degenerateFaces += !(shares.surface[f] > 0);
    withArea += addAreas(shares, f, result);
    measureJacobian(surface, image, shares, f, result.arrays);
    withAngles += addAngles(shares, f, result);
    s.meanAngleError += measureCorners(surface, image, f, result.arrays);
  }
  s.areaErrorL2 = std::sqrt(s.areaErrorL2);
  s.faceStandardDeviation = std::sqrt(s.faceStandardDeviation);
  s.faceMeanAbsLog /= std::max(withArea, 1);
  s.meanQuasiConformal /= std::max(withAngles, 1);
  s.meanBeltrami /= std::max(withAngles, 1);
  s.meanAngleError *= 180 / (M_PI * 3.0 * m);
  s.finite = image.points.allFinite();
  measureVertices(surface, image, shares, result);
  return result;
}

void measureSpreads(Distortion& distortion) {
  const DistortionArrays& arrays = distortion.arrays;
  Eigen::VectorXd dilatation(arrays.sigmaMax.size());
  for (Eigen::Index f = 0; f < dilatation.size(); ++f) {
    const double smaller = std::abs(arrays.sigmaMin[f]);
    dilatation[f] = smaller > 0 ? arrays.sigmaMax[f] / smaller : kNaN;
  }
  const Eigen::VectorXd errors = arrays.cornerAngleError.reshaped().cwiseAbs();
  distortion.summary.angleError = spreadOf(errors);
  distortion.summary.quasiConformal = spreadOf(dilatation);
  distortion.summary.beltrami = spreadOf(((dilatation.array() - 1) / (dilatation.array() + 1)).matrix());
}

}  // namespace authalic
