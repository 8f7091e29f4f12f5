#include "Core/sampling/GridClipping.h"

#include <algorithm>

namespace authalic {

namespace {

/// A point of the face: where it maps to, and its barycentric coordinates.
struct Corner {
  std::array<double, 2> uv;
  std::array<double, 3> b;
};

/// A convex polygon. A triangle cut by four lines has at most seven corners; splitting adds one more at most.
struct Polygon {
  std::array<Corner, 12> corners;
  std::size_t size = 0;
  void add(const Corner& corner) {
    if (size < corners.size()) corners[size++] = corner;
  }
};

Corner crossing(const Corner& from, const Corner& to, std::size_t axis, double line) {
  const double t = (line - from.uv[axis]) / (to.uv[axis] - from.uv[axis]);
  Corner result;
  for (std::size_t k = 0; k < 2; ++k) result.uv[k] = from.uv[k] + t * (to.uv[k] - from.uv[k]);
  for (std::size_t k = 0; k < 3; ++k) result.b[k] = from.b[k] + t * (to.b[k] - from.b[k]);
  result.uv[axis] = line;
  return result;
}

/// Splits at uv[axis] = line; corners on the line belong to both sides.
void split(const Polygon& whole, std::size_t axis, double line, Polygon& below, Polygon& above) {
  below.size = above.size = 0;
  for (std::size_t k = 0; k < whole.size; ++k) {
    const Corner& here = whole.corners[k];
    const Corner& next = whole.corners[(k + 1) % whole.size];
    const double a = here.uv[axis] - line, b = next.uv[axis] - line;
    if (a <= 0.0) below.add(here);
    if (a >= 0.0) above.add(here);
    if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0)) {
      const Corner cut = crossing(here, next, axis, line);
      below.add(cut);
      above.add(cut);
    }
  }
}

/// Fraction of the face (twice the area in the (b1, b2) plane, where the face has area ½) and centroid.
FacePart measure(const Polygon& polygon) {
  FacePart part;
  const Corner& origin = polygon.corners[0];
  for (std::size_t k = 1; k + 1 < polygon.size; ++k) {
    const Corner& p = polygon.corners[k];
    const Corner& q = polygon.corners[k + 1];
    const double area =
        (p.b[1] - origin.b[1]) * (q.b[2] - origin.b[2]) - (p.b[2] - origin.b[2]) * (q.b[1] - origin.b[1]);
    part.fraction += area;
    for (std::size_t c = 0; c < 3; ++c) part.corner[c] += area / 3.0 * (origin.b[c] + p.b[c] + q.b[c]);
  }
  if (part.fraction > 0.0) {
    for (double& c : part.corner) c /= part.fraction;
  }
  return part;
}

void addPart(const Polygon& polygon, int cell, std::vector<FacePart>& parts) {
  if (polygon.size < 3) return;
  FacePart part = measure(polygon);
  if (!(part.fraction > 1e-15)) return;
  part.cell = cell;
  parts.push_back(part);
}

/// The first and last cell along an axis that the polygon reaches.
std::array<int, 2> range(const Polygon& polygon, std::size_t axis, const GridLines& lines) {
  double low = polygon.corners[0].uv[axis], high = low;
  for (std::size_t k = 1; k < polygon.size; ++k) {
    low = std::min(low, polygon.corners[k].uv[axis]);
    high = std::max(high, polygon.corners[k].uv[axis]);
  }
  return {lines.locate(static_cast<int>(axis), low), lines.locate(static_cast<int>(axis), high)};
}

void cutColumn(Polygon column, int i, const GridLines& lines, std::vector<FacePart>& parts) {
  if (column.size < 3) return;
  const std::array<int, 2> rows = range(column, 1, lines);
  Polygon below, above;
  for (int j = rows[0]; j < rows[1]; ++j) {
    split(column, 1, lines.line(1, j + 1), below, above);
    addPart(below, i + lines.columns * j, parts);
    column = above;
  }
  addPart(column, i + lines.columns * rows[1], parts);
}

}  // namespace

void cutFace(const Faces& faces, const Points2& image, int face, const GridLines& lines,
             std::vector<FacePart>& parts) {
  parts.clear();
  Polygon rest;
  for (int k = 0; k < 3; ++k) {
    Corner corner{{image(faces(face, k), 0), image(faces(face, k), 1)}, {0, 0, 0}};
    corner.b[static_cast<std::size_t>(k)] = 1.0;
    rest.add(corner);
  }
  const std::array<int, 2> columns = range(rest, 0, lines), rows = range(rest, 1, lines);
  if (columns[0] == columns[1] && rows[0] == rows[1]) {
    parts.push_back({columns[0] + lines.columns * rows[0], 1.0, {1.0 / 3, 1.0 / 3, 1.0 / 3}});
    return;
  }
  Polygon left, right;
  for (int i = columns[0]; i < columns[1]; ++i) {
    split(rest, 0, lines.line(0, i + 1), left, right);
    cutColumn(left, i, lines, parts);
    rest = right;
  }
  cutColumn(rest, columns[1], lines, parts);
}

}  // namespace authalic
