#include "Core/distortion/Distortion.h"

#include <string>

#include "Core/base/Error.h"
#include "Core/distortion/MeasuredImage.h"
#include "Core/geometry/Areas.h"

namespace authalic {

Distortion measureDistortion(const TriangleMesh& surface, const Points2& image, const Eigen::VectorXd& target) {
  return measureDistortion(surface, {}, image, target);
}

Distortion measureDistortion(const TriangleMesh& opened, const std::vector<int>& originals, const Points2& image,
                             const Eigen::VectorXd& target) {
  requireImagePerVertex(opened, image.rows());
  MeasuredImage measured{Points3::Zero(image.rows(), 3), signedFaceAreas(image, opened.faces()), {}, originals};
  measured.points.leftCols<2>() = image;
  measured.flatAreas = measured.areas;
  Distortion result = measureImage(opened, measured, target);
  measureSpreads(result);
  return result;
}

double transportCost(const Points2& from, const Points2& to, const Eigen::VectorXd& masses) {
  if (from.rows() != to.rows() || from.rows() != masses.size()) {
    throw GeometryError("Two images and masses of one length are required, but they have " +
                        std::to_string(from.rows()) + ", " + std::to_string(to.rows()) + " and " +
                        std::to_string(masses.size()) + " entries.");
  }
  return masses.dot((from - to).rowwise().squaredNorm());
}

}  // namespace authalic
