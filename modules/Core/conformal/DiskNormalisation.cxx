#include "Core/conformal/DiskNormalisation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

Mobius centring(const TriangleMesh& mesh, const Points2& image, const DiskNormalisation& normalisation) {
  if (normalisation.centre == DiskCentre::AreaCentroid) {
    const Eigen::VectorXd areas = vertexStars(faceAreas(mesh), mesh.faces(), mesh.vertexCount());
    return centreOfMassToOrigin(image, areas).map;
  }
  Eigen::RowVector2d place = Eigen::RowVector2d::Zero();
  if (normalisation.centre == DiskCentre::Vertex) {
    place = image.row(normalisation.centreId);
  } else {
    for (int k = 0; k < 3; ++k) place += image.row(mesh.faces()(normalisation.centreId, k)) / 3;
  }
  return Mobius::diskToOrigin({place[0], place[1]});
}

}  // namespace

const char* diskCentreName(DiskCentre centre) noexcept {
  switch (centre) {
    case DiskCentre::AreaCentroid:
      return "area-centroid";
    case DiskCentre::Vertex:
      return "vertex";
    case DiskCentre::Face:
      return "face";
  }
  return "area-centroid";
}

void DiskNormalisation::validate(const TriangleMesh& mesh, const std::vector<int>& outerLoop,
                                 const std::vector<char>& onBoundary) const {
  const int n = mesh.vertexCount(), m = mesh.faceCount();
  if (startVertex != -1 && std::find(outerLoop.begin(), outerLoop.end(), startVertex) == outerLoop.end()) {
    throw InvalidArgument("A vertex of the outer loop is required at angle 0, but vertex " +
                          std::to_string(startVertex) + " is none.");
  }
  if (centre == DiskCentre::Vertex &&
      (centreId < 0 || centreId >= n || onBoundary[static_cast<std::size_t>(centreId)])) {
    throw InvalidArgument("An inner vertex is required at the centre, but vertex " +
                          std::to_string(centreId) + " is none.");
  }
  if (centre == DiskCentre::Face && (centreId < 0 || centreId >= m)) {
    throw InvalidArgument("A face is required at the centre, but there is no face " +
                          std::to_string(centreId) + ".");
  }
}

Mobius normalisingMap(const TriangleMesh& mesh, const SurfaceTopology& topology,
                      const std::vector<int>& outerLoop, const Points2& image,
                      const DiskNormalisation& normalisation) {
  normalisation.validate(mesh, outerLoop, topology.onBoundary());
  const Mobius centred = centring(mesh, image, normalisation);
  const int start = normalisation.startVertex >= 0 ? normalisation.startVertex : outerLoop.front();
  const Mobius::Complex at = centred(Mobius::Complex(image(start, 0), image(start, 1)));
  return Mobius::rotation(-std::arg(at)) * centred;
}

Points2 normaliseDisk(const TriangleMesh& mesh, const SurfaceTopology& topology,
                      const std::vector<int>& outerLoop, const Points2& image,
                      const DiskNormalisation& normalisation) {
  Points2 normal = normalisingMap(mesh, topology, outerLoop, image, normalisation)(image);
  for (const int v : outerLoop) normal.row(v).normalize();
  return normal;
}

}  // namespace authalic
