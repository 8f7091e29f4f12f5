#include "Core/imaging/Isosurface.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "Core/base/Error.h"
#include "Core/imaging/LatticeSurfaceTable.h"

namespace authalic {

namespace {

class Extraction {
 public:
  explicit Extraction(const ScalarVolume& field)
      : field_(field),
        nx_(field.dimensions[0]),
        ny_(field.dimensions[1]),
        slice_(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_)),
        mirrored_(field.voxelToWorld.topLeftCorner<3, 3>().determinant() < 0) {
    for (auto& ids : edgeVertex_) ids.assign(slice_, -1);
  }

  TriangleMesh run(const Execution& execution) {
    const int nz = field_.dimensions[2];
    requireClosed();
    crossSlice(0);
    for (int k = 0; k + 1 < nz; ++k) {
      execution.throwIfCancelled();
      execution.report(static_cast<double>(k) / nz, "isosurface");
      crossBetween(k);
      std::swap(edgeVertex_[0], edgeVertex_[2]);
      std::swap(edgeVertex_[1], edgeVertex_[3]);
      crossSlice(k + 1);
      for (int j = 0; j + 1 < ny_; ++j) {
        for (int i = 0; i + 1 < nx_; ++i) triangulateCube(i, j, k);
      }
    }
    if (faces_.empty()) {
      throw InvalidArgument(
          "A field with a positive voxel is required to extract a surface, but none of the " +
          std::to_string(field_.size()) + " voxels is positive; lower the threshold.");
    }
    return mesh();
  }

 private:
  [[nodiscard]] bool inside(std::size_t v) const { return field_.values[v] > 0; }

  void requireClosed() const {
    const auto& n = field_.dimensions;
    for (int k = 0; k < n[2]; ++k) {
      for (int j = 0; j < n[1]; ++j) {
        const bool edge = k == 0 || j == 0 || k + 1 == n[2] || j + 1 == n[1];
        for (int i = 0; i < n[0]; i += edge ? 1 : std::max(1, n[0] - 1)) {
          if (!inside(field_.index(i, j, k))) continue;
          throw InvalidArgument(
              "An object inside the outermost layer of the volume is required, but voxel (" +
              std::to_string(i) + ", " + std::to_string(j) + ", " + std::to_string(k) +
              ") of that layer is positive; pad the volume by one voxel.");
        }
      }
    }
  }

  int addVertex(const Eigen::Vector3d& voxel) {
    points_.push_back(voxel);
    return static_cast<int>(points_.size()) - 1;
  }

  // Vertex on the lattice edge from (i, j, k) along an axis, or -1.
  int crossing(int i, int j, int k, int axis, std::size_t step) {
    const std::size_t v = field_.index(i, j, k);
    if (inside(v) == inside(v + step)) return -1;
    const double a = field_.values[v], b = field_.values[v + step];
    const double t = a - b != 0 ? a / (a - b) : 0.5;
    Eigen::Vector3d p(i, j, k);
    p[axis] += t > 0.01 ? std::min(t, 0.99) : 0.01;
    return addVertex(p);
  }

  // x and y edges of slice k, into the upper pair of tables.
  void crossSlice(int k) {
    for (int j = 0; j < ny_; ++j) {
      for (int i = 0; i < nx_; ++i) {
        const std::size_t at =
            static_cast<std::size_t>(j) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(i);
        edgeVertex_[2][at] = i + 1 < nx_ ? crossing(i, j, k, 0, 1) : -1;
        edgeVertex_[3][at] = j + 1 < ny_ ? crossing(i, j, k, 1, static_cast<std::size_t>(nx_)) : -1;
      }
    }
  }

  // z edges between slices k and k + 1.
  void crossBetween(int k) {
    for (int j = 0; j < ny_; ++j) {
      for (int i = 0; i < nx_; ++i) {
        const std::size_t at =
            static_cast<std::size_t>(j) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(i);
        edgeVertex_[4][at] = crossing(i, j, k, 2, slice_);
      }
    }
  }

  void triangulateCube(int i, int j, int k) {
    const std::size_t base = field_.index(i, j, k);
    int signs = 0;
    for (int c = 0; c < 8; ++c) {
      signs |= static_cast<int>(inside(base + cornerStep(c))) << c;
    }
    if (signs == 0 || signs == 255) return;
    const LatticeSurfaceCell& cell = latticeSurfaceCell(signs);
    std::vector<int> centres;
    for (const auto& around : cell.centres) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const int e : around) sum += points_[static_cast<std::size_t>(vertexOf(e, i, j))];
      centres.push_back(addVertex(sum / static_cast<double>(around.size())));
    }
    for (const auto& triangle : cell.triangles) {
      std::array<int, 3> f{};
      for (std::size_t c = 0; c < 3; ++c) {
        f[c] = triangle[c] < 12 ? vertexOf(triangle[c], i, j)
                                : centres[static_cast<std::size_t>(triangle[c] - 12)];
      }
      if (mirrored_) std::swap(f[1], f[2]);
      faces_.push_back(f);
    }
  }

  [[nodiscard]] std::size_t cornerStep(int c) const {
    return static_cast<std::size_t>(c & 1) + (c & 2 ? static_cast<std::size_t>(nx_) : 0) +
           (c & 4 ? slice_ : 0);
  }

  // Tables 0 and 1 hold the x and y edges of the lower slice, 2 and 3 of the upper, 4 the z edges.
  [[nodiscard]] int vertexOf(int cubeEdge, int i, int j) const {
    const int c = kCubeEdges[static_cast<std::size_t>(cubeEdge)][0];
    const std::size_t at = static_cast<std::size_t>(j + (c >> 1 & 1)) * static_cast<std::size_t>(nx_) +
                           static_cast<std::size_t>(i + (c & 1));
    const std::size_t table = cubeEdge >= 8 ? 4 : static_cast<std::size_t>(cubeEdge / 4 + (c & 4 ? 2 : 0));
    return edgeVertex_[table][at];
  }

  [[nodiscard]] TriangleMesh mesh() const {
    Points3 points(static_cast<Eigen::Index>(points_.size()), 3);
    for (std::size_t v = 0; v < points_.size(); ++v) {
      points.row(static_cast<Eigen::Index>(v)) =
          field_.world(points_[v][0], points_[v][1], points_[v][2]).transpose();
    }
    Faces faces(static_cast<Eigen::Index>(faces_.size()), 3);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      faces.row(static_cast<Eigen::Index>(f)) << faces_[f][0], faces_[f][1], faces_[f][2];
    }
    return TriangleMesh(std::move(points), std::move(faces));
  }

  const ScalarVolume& field_;
  int nx_, ny_;
  std::size_t slice_;
  bool mirrored_;
  std::array<std::vector<int>, 5> edgeVertex_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<std::array<int, 3>> faces_;
};

}  // namespace

TriangleMesh extractIsosurface(const ScalarVolume& field, const Execution& execution) {
  for (const int n : field.dimensions) {
    if (n < 3) {
      throw InvalidArgument(
          "A volume of at least 3 voxels along every axis is required to extract a surface, but one axis "
          "has " +
          std::to_string(n) + "; give a larger volume.");
    }
  }
  return Extraction(field).run(execution);
}

}  // namespace authalic
