#include "Core/conformal/WeldedDisks.h"

#include <functional>
#include <map>
#include <string>
#include <utility>

#include "Core/base/Error.h"

namespace authalic {
namespace {

std::string at(const DiskMesh& disk, int vertex) {
  const Eigen::Vector3d p = disk.mesh().point(vertex);
  return "vertex " + std::to_string(vertex) + " at (" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " +
         std::to_string(p[2]) + ") mm";
}

void requireEqualLoops(const DiskMesh& first, const DiskMesh& second) {
  const std::size_t here = first.boundary().size(), there = second.boundary().size();
  if (here == there) return;
  throw GeometryError("Boundaries with the same number of vertices are required for a welding, but they have " +
                      std::to_string(here) + " and " + std::to_string(there) +
                      "; take both halves of one cut, or resample one boundary.");
}

/// Pairs by a key of each vertex; `what` says what the key is.
template <class Key>
SeamPairs matchBy(const DiskMesh& first, const DiskMesh& second, const std::string& what, const Key& firstKey,
                  const Key& secondKey) {
  requireEqualLoops(first, second);
  std::map<decltype(secondKey(0)), int> partners;
  for (const int vertex : second.boundary()) {
    if (partners.emplace(secondKey(vertex), vertex).second) continue;
    throw GeometryError("Boundary vertices with different " + what + "s are required for a welding, but that of " +
                        at(second, vertex) + " of the second disk stands twice.");
  }
  SeamPairs pairs;
  for (const int vertex : first.boundary()) {
    const auto partner = partners.find(firstKey(vertex));
    if (partner == partners.end()) {
      throw GeometryError("A boundary vertex of the second disk with the same " + what +
                          " is required for every one of the first, but " + at(first, vertex) +
                          " has none that is still free; take both halves of one cut, or name an array of numbers "
                          "that match.");
    }
    pairs.push_back({vertex, partner->second});
    partners.erase(partner);
  }
  return pairs;
}

void requireImages(const DiskMesh& disk, const Points2& image, const char* name) {
  if (image.rows() == disk.mesh().vertexCount()) return;
  throw InvalidArgument("One image per vertex of the " + std::string(name) + " disk is required: it has " +
                        std::to_string(disk.mesh().vertexCount()) + " vertices, but there are " +
                        std::to_string(image.rows()) + " images.");
}

/// Sees that the seam walks the first boundary forwards and the second one backwards, each vertex once.
void requireOppositeWalk(const DiskMesh& first, const DiskMesh& second, const SeamPairs& seam) {
  requireEqualLoops(first, second);
  const std::vector<int>& here = first.boundary();
  const std::vector<int>& there = second.boundary();
  const std::size_t n = here.size();
  std::size_t start = 0;
  while (start < n && (seam.empty() || there[start] != seam[0][1])) ++start;
  bool same = seam.size() == n && start < n;
  for (std::size_t k = 0; same && k < n; ++k) same = seam[k][0] == here[k] && seam[k][1] == there[(start + n - k) % n];
  if (same) return;
  throw GeometryError("A seam that runs along the first boundary and backwards along the second is required, but the " +
                      std::to_string(seam.size()) + " pairs from " + at(first, here.front()) +
                      " on do not; reverse the orientation of one surface, or correct the numbers.");
}

Points2 rowsOf(const Points2& image, const SeamPairs& seam, std::size_t side) {
  Points2 rows(static_cast<Eigen::Index>(seam.size()), 2);
  for (std::size_t k = 0; k < seam.size(); ++k) rows.row(static_cast<Eigen::Index>(k)) = image.row(seam[k][side]);
  return rows;
}

/// The glued surface; fills the vertices that those of the second disk become.
SphereMesh glue(const DiskMesh& first, const DiskMesh& second, const SeamPairs& seam, std::vector<int>& vertices) {
  vertices.assign(static_cast<std::size_t>(second.mesh().vertexCount()), -1);
  for (const auto& [here, there] : seam) vertices[static_cast<std::size_t>(there)] = here;
  int count = first.mesh().vertexCount();
  for (int& vertex : vertices) {
    if (vertex < 0) vertex = count++;
  }
  Points3 points(count, 3);
  for (Eigen::Index i = 0; i < second.mesh().points().rows(); ++i) {
    points.row(vertices[static_cast<std::size_t>(i)]) = second.mesh().points().row(i);
  }
  points.topRows(first.mesh().vertexCount()) = first.mesh().points();
  const Faces& added = second.mesh().faces();
  Faces faces(first.mesh().faceCount() + added.rows(), 3);
  faces.topRows(first.mesh().faceCount()) = first.mesh().faces();
  for (Eigen::Index f = 0; f < added.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      faces(first.mesh().faceCount() + f, k) = vertices[static_cast<std::size_t>(added(f, k))];
    }
  }
  return SphereMesh(TriangleMesh(std::move(points), std::move(faces)));
}

}  // namespace

SeamPairs matchByPlace(const DiskMesh& first, const DiskMesh& second) {
  const auto placeOn = [](const DiskMesh& disk) {
    return std::function<std::array<double, 3>(int)>([&disk](int vertex) {
      const Eigen::Vector3d p = disk.mesh().point(vertex);
      return std::array<double, 3>{p[0], p[1], p[2]};
    });
  };
  return matchBy(first, second, "place", placeOn(first), placeOn(second));
}

SeamPairs matchByNumber(const DiskMesh& first, const std::vector<int>& firstNumbers, const DiskMesh& second,
                        const std::vector<int>& secondNumbers) {
  if (firstNumbers.size() != static_cast<std::size_t>(first.mesh().vertexCount()) ||
      secondNumbers.size() != static_cast<std::size_t>(second.mesh().vertexCount())) {
    throw InvalidArgument("One number per vertex of both disks is required for a welding signature, but there are " +
                          std::to_string(firstNumbers.size()) + " and " + std::to_string(secondNumbers.size()) + ".");
  }
  const auto numberIn = [](const std::vector<int>& numbers) {
    return std::function<int(int)>([&numbers](int vertex) { return numbers[static_cast<std::size_t>(vertex)]; });
  };
  return matchBy(first, second, "number", numberIn(firstNumbers), numberIn(secondNumbers));
}

WeldedDisks weldDisks(const DiskMesh& first, const Points2& firstImage, const DiskMesh& second,
                      const Points2& secondImage, const SeamPairs& seam, const Execution& execution) {
  requireImages(first, firstImage, "first");
  requireImages(second, secondImage, "second");
  requireOppositeWalk(first, second, seam);
  std::vector<int> vertices;
  SphereMesh surface = glue(first, second, seam, vertices);
  ConformalWelding welding(WeldingSignature::fromPoints(rowsOf(firstImage, seam, 0), rowsOf(secondImage, seam, 1)),
                           execution.part(0, 0.3));
  Points3 image(surface.mesh().vertexCount(), 3);
  const Points3 curve = welding.curveOnSphere();
  const Points3 outer = welding.mapSecondToSphere(secondImage, execution);
  for (Eigen::Index i = 0; i < outer.rows(); ++i) image.row(vertices[static_cast<std::size_t>(i)]) = outer.row(i);
  image.topRows(firstImage.rows()) = welding.mapFirstToSphere(firstImage, execution);
  for (std::size_t k = 0; k < seam.size(); ++k) image.row(seam[k][0]) = curve.row(static_cast<Eigen::Index>(k));
  execution.report(1, "welding");
  return {std::move(surface), std::move(image), std::move(vertices), std::move(welding)};
}

}  // namespace authalic
