#include <algorithm>
#include <cmath>

#include "Core/sampling/ElementGrid.h"

namespace authalic {

namespace {

/// A point of a face on a grid line.
struct LinePoint {
  double along = 0.0;  ///< the coordinate that runs along the line
  std::array<double, 3> b{0, 0, 0};
};

LinePoint between(const LinePoint& p, const LinePoint& q, double along) {
  const double t = (along - p.along) / (q.along - p.along);
  LinePoint result{along, {}};
  for (std::size_t k = 0; k < 3; ++k) result.b[k] = p.b[k] + t * (q.b[k] - p.b[k]);
  return result;
}

class OutlineBuilder {
 public:
  OutlineBuilder(const TriangleMesh& surface, const Points2& image, const ElementGrid& grid)
      : surface_(surface), image_(image), grid_(grid) {}

  ElementOutline build() {
    for (int f = 0; f < surface_.faceCount(); ++f) {
      cut(f, 0);
      cut(f, 1);
    }
    result_.points.resize(static_cast<Eigen::Index>(points_.size()), 3);
    result_.image.resize(static_cast<Eigen::Index>(points_.size()), 2);
    for (std::size_t p = 0; p < points_.size(); ++p) {
      result_.points.row(static_cast<Eigen::Index>(p)) = points_[p].transpose();
      result_.image.row(static_cast<Eigen::Index>(p)) = imagePoints_[p].transpose();
    }
    return std::move(result_);
  }

 private:
  /// The lines of one axis that cross the face.
  void cut(int face, int axis) {
    double low = image_(surface_.faces()(face, 0), axis), high = low;
    for (int k = 1; k < 3; ++k) {
      low = std::min(low, image_(surface_.faces()(face, k), axis));
      high = std::max(high, image_(surface_.faces()(face, k), axis));
    }
    const int last = grid_.lines.locate(axis, high);
    for (int line = grid_.lines.locate(axis, low) + 1; line <= last; ++line) crossLine(face, axis, line);
  }

  /// Half-open sides (≥ is above), so that an edge on a line is drawn by exactly one of its two faces.
  void crossLine(int face, int axis, int line) {
    const double x = grid_.lines.line(axis, line);
    std::array<LinePoint, 2> ends;
    std::size_t found = 0;
    for (int k = 0; k < 3 && found < 2; ++k) {
      const int next = (k + 1) % 3, v = surface_.faces()(face, k), w = surface_.faces()(face, next);
      const double a = image_(v, axis) - x, b = image_(w, axis) - x;
      if ((a >= 0.0) == (b >= 0.0)) continue;
      const double t = a / (a - b);
      LinePoint& end = ends[found++];
      end.b[static_cast<std::size_t>(k)] = 1.0 - t;
      end.b[static_cast<std::size_t>(next)] = t;
      end.along = image_(v, 1 - axis) + t * (image_(w, 1 - axis) - image_(v, 1 - axis));
    }
    if (found < 2) return;
    if (ends[0].along > ends[1].along) std::swap(ends[0], ends[1]);
    splitByOtherLines(face, axis, line, ends[0], ends[1]);
  }

  void splitByOtherLines(int face, int axis, int line, LinePoint from, const LinePoint& to) {
    const int other = 1 - axis, last = grid_.lines.locate(other, to.along);
    for (int k = grid_.lines.locate(other, from.along); k <= last; ++k) {
      const LinePoint end = k == last ? to : between(from, to, grid_.lines.line(other, k + 1));
      if (end.along > from.along) add(face, axis, line, k, from, end);
      from = end;
    }
  }

  void add(int face, int axis, int line, int along, const LinePoint& from, const LinePoint& to) {
    const int below = elementAt(axis, line - 1, along), above = elementAt(axis, line, along);
    if (below == above || below < 0 || above < 0) return;
    const double x = grid_.lines.line(axis, line);
    for (const LinePoint& end : {from, to}) {
      Eigen::Vector3d p = Eigen::Vector3d::Zero();
      for (int k = 0; k < 3; ++k) p += end.b[static_cast<std::size_t>(k)] * surface_.corner(face, k);
      points_.push_back(p);
      imagePoints_.emplace_back(axis == 0 ? x : end.along, axis == 0 ? end.along : x);
    }
    result_.face.push_back(face);
    result_.elements.push_back({below, above});
  }

  [[nodiscard]] int elementAt(int axis, int across, int along) const {
    const int i = axis == 0 ? across : along, j = axis == 0 ? along : across;
    return grid_.cellElement[static_cast<std::size_t>(i) +
                             static_cast<std::size_t>(grid_.lines.columns) * static_cast<std::size_t>(j)];
  }

  const TriangleMesh& surface_;
  const Points2& image_;
  const ElementGrid& grid_;
  ElementOutline result_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Eigen::Vector2d> imagePoints_;
};

}  // namespace

ElementOutline elementOutline(const TriangleMesh& surface, const Points2& image, const ElementGrid& grid) {
  return OutlineBuilder(surface, image, grid).build();
}

}  // namespace authalic
