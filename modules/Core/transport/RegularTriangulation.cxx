#include "Core/transport/RegularTriangulation.h"

#include "Core/base/Error.h"

#ifdef AUTHALIC_HAVE_CGAL

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/spatial_sort.h>

#include <numeric>

namespace authalic {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_2<int, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_2<Kernel>>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel, CGAL::Regular_triangulation_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Regular_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

class CgalTriangulation final : public RegularTriangulation {
 public:
  explicit CgalTriangulation(const Points2& sites) : order_(static_cast<std::size_t>(sites.rows())) {
    for (Eigen::Index i = 0; i < sites.rows(); ++i) points_.emplace_back(sites(i, 0), sites(i, 1));
    std::iota(order_.begin(), order_.end(), 0);
    const auto place = CGAL::make_property_map(points_);
    CGAL::spatial_sort(order_.begin(), order_.end(),
                       CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(place)>(place));
  }

  RegularConnectivity triangulate(const Eigen::VectorXd& heights) const override {
    Triangulation found;
    Triangulation::Face_handle hint;
    for (const std::size_t i : order_) {
      const Kernel::Point_2& p = points_[i];
      const double weight = p.x() * p.x() + p.y() * p.y() + 2 * heights[static_cast<Eigen::Index>(i)];
      const auto vertex = found.insert(Kernel::Weighted_point_2(p, weight), hint);
      vertex->info() = static_cast<int>(i);
      hint = vertex->face();
    }
    return connectivity(found);
  }

 private:
  [[nodiscard]] RegularConnectivity connectivity(const Triangulation& found) const {
    RegularConnectivity result;
    result.dimension = std::max(found.dimension(), 0);
    result.faceOf.assign(points_.size(), -1);
    if (result.dimension < 2) {
      for (auto v = found.finite_vertices_begin(); v != found.finite_vertices_end(); ++v) {
        result.line.push_back(v->info());
        result.faceOf[static_cast<std::size_t>(v->info())] = 0;
      }
      sortAlongLine(result.line);
      return result;
    }
    int count = 0;
    for (auto f = found.all_faces_begin(); f != found.all_faces_end(); ++f) f->info() = count++;
    result.corners.reserve(static_cast<std::size_t>(count));
    result.neighbours.reserve(static_cast<std::size_t>(count));
    for (auto f = found.all_faces_begin(); f != found.all_faces_end(); ++f) {
      std::array<int, 3> corner{}, neighbour{};
      for (int k = 0; k < 3; ++k) {
        const auto position = static_cast<std::size_t>(k);
        corner[position] = found.is_infinite(f->vertex(k)) ? -1 : f->vertex(k)->info();
        neighbour[position] = f->neighbor(k)->info();
        if (corner[position] >= 0) result.faceOf[static_cast<std::size_t>(corner[position])] = f->info();
      }
      result.corners.push_back(corner);
      result.neighbours.push_back(neighbour);
    }
    return result;
  }

  void sortAlongLine(std::vector<int>& line) const {
    std::sort(line.begin(), line.end(), [this](int a, int b) {
      return points_[static_cast<std::size_t>(a)] < points_[static_cast<std::size_t>(b)];
    });
  }

  std::vector<Kernel::Point_2> points_;
  std::vector<std::size_t> order_;
};

}  // namespace

bool regularTriangulationAvailable() noexcept { return true; }

std::unique_ptr<RegularTriangulation> makeRegularTriangulation(const Points2& sites) {
  return std::make_unique<CgalTriangulation>(sites);
}

}  // namespace authalic

#else

namespace authalic {

bool regularTriangulationAvailable() noexcept { return false; }

std::unique_ptr<RegularTriangulation> makeRegularTriangulation(const Points2&) {
  throw InvalidArgument("A build with CGAL is required for power diagrams, but this one is without; configure with "
                        "-DAUTHALIC_CGAL=ON.");
}

}  // namespace authalic

#endif
