#include "Core/sampling/ElementGrid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "Core/base/Error.h"
#include "Core/mesh/SurfaceTopology.h"
#include "Core/sampling/GridClipping.h"

namespace authalic {

namespace {

using Box = std::array<std::array<double, 2>, 2>;  // lower, upper

constexpr double kWholeCell = 1e-9;
constexpr double kMostCells = 4e6;

double faceArea(const TriangleMesh& surface, int f) {
  return 0.5 * (surface.corner(f, 1) - surface.corner(f, 0))
                   .cross(surface.corner(f, 2) - surface.corner(f, 0))
                   .norm();
}

/// Signed.
double imageFaceArea(const Faces& faces, const Points2& image, int f) {
  const Eigen::RowVector2d a = image.row(faces(f, 1)) - image.row(faces(f, 0));
  const Eigen::RowVector2d b = image.row(faces(f, 2)) - image.row(faces(f, 0));
  return 0.5 * (a[0] * b[1] - a[1] * b[0]);
}

void requireImage(const TriangleMesh& surface, const Points2& image) {
  if (image.rows() != surface.points().rows()) {
    throw GeometryError("One image point per vertex is required, but there are " +
                        std::to_string(image.rows()) + " for " + std::to_string(surface.vertexCount()) +
                        " vertices; use the map of this very surface.");
  }
  for (Eigen::Index v = 0; v < image.rows(); ++v) {
    if (!image.row(v).allFinite()) {
      throw GeometryError("Finite image coordinates are required, but those of vertex " + std::to_string(v) +
                          " are not; leave that vertex out of the map.");
    }
  }
}

/// Bounding box of the points that faces use.
Box boundingBox(const Faces& faces, const Points2& image) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}}};
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 2; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const double x = image(faces(f, k), axis);
        box[0][a] = std::min(box[0][a], x);
        box[1][a] = std::max(box[1][a], x);
      }
    }
  }
  return box;
}

/// Moves each side of the box to the straight line nearby that at least half a side of the boundary runs
/// along: the sides of a rectangle, when small parts of the boundary (ear triangles) bulge out of them.
void snapToStraightSides(Box& box, const SurfaceTopology& topology, const Points2& image) {
  constexpr double kOnLine = 1e-9, kNearby = 0.05;
  const Box whole = box;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double extent = whole[1][a] - whole[0][a], across = whole[1][1 - a] - whole[0][1 - a];
    std::vector<std::array<double, 2>> runs;  // place of the line, length along it
    for (int h = 0; h < 3 * static_cast<int>(topology.faces().rows()); ++h) {
      if (topology.opposite(h) >= 0) continue;
      const Eigen::RowVector2d from = image.row(topology.tail(h)), to = image.row(topology.head(h));
      if (std::abs(to[axis] - from[axis]) > kOnLine * extent) continue;
      runs.push_back({from[axis], std::abs(to[1 - axis] - from[1 - axis])});
    }
    std::sort(runs.begin(), runs.end());
    double length = 0.0;
    bool lowerFound = false;
    for (std::size_t k = 0; k < runs.size(); ++k) {
      length = k > 0 && runs[k][0] - runs[k - 1][0] <= kOnLine * extent ? length + runs[k][1] : runs[k][1];
      if (length < 0.5 * across) continue;
      if (!lowerFound && runs[k][0] - whole[0][a] <= kNearby * extent) box[0][a] = runs[k][0];
      lowerFound = true;
      if (whole[1][a] - runs[k][0] <= kNearby * extent) box[1][a] = runs[k][0];
    }
  }
}

bool fillsUnitDisk(const TriangleMesh& surface, const SurfaceTopology& topology, const Points2& image) {
  constexpr double kTolerance = 1e-6;
  bool anyBoundary = false;
  for (int v = 0; v < surface.vertexCount(); ++v) {
    const double radius = image.row(v).norm();
    const bool boundary = topology.onBoundary()[static_cast<std::size_t>(v)] != 0;
    anyBoundary = anyBoundary || boundary;
    if (radius > 1.0 + kTolerance || (boundary && radius < 1.0 - kTolerance)) return false;
  }
  return anyBoundary;
}

Box gridFrame(const TriangleMesh& surface, const Points2& image, GridFrame frame) {
  Box box = boundingBox(surface.faces(), image);
  if (frame == GridFrame::BoundingBox) return box;
  if (frame == GridFrame::Automatic) {
    const SurfaceTopology topology(surface.faces(), surface.vertexCount());
    if (!fillsUnitDisk(surface, topology, image)) {
      snapToStraightSides(box, topology, image);
      return box;
    }
  }
  if (std::min(box[0][0], box[0][1]) < -1.01 || std::max(box[1][0], box[1][1]) > 1.01) {
    throw GeometryError(
        "An image inside the unit disk is required for the disk's grid, but it reaches from (" +
        std::to_string(box[0][0]) + ", " + std::to_string(box[0][1]) + ") to (" + std::to_string(box[1][0]) +
        ", " + std::to_string(box[1][1]) + "); choose the bounding box as frame or normalise the map.");
  }
  return {{{-1.0, -1.0}, {1.0, 1.0}}};
}

/// Columns and rows that tile the frame with nearly square cells of about `cellArea`.
GridLines tile(const Box& frame, double cellArea) {
  GridLines lines{frame[0], frame[1], 1, 1};
  const double width = frame[1][0] - frame[0][0], height = frame[1][1] - frame[0][1],
               side = std::sqrt(cellArea);
  if (!(width > 0.0 && height > 0.0)) {
    throw GeometryError("An image with positive area is required, but it is " + std::to_string(width) +
                        " wide and " + std::to_string(height) + " high; the map has collapsed.");
  }
  if ((width / side + 1) * (height / side + 1) > kMostCells) {
    throw InvalidArgument("At most 4,000,000 cells are allowed, but cells of side " + std::to_string(side) +
                          " on " + std::to_string(width) + " x " + std::to_string(height) +
                          " are more; ask for fewer or larger elements.");
  }
  // A frame thinner than half a cell gets one row of the wanted number of cells, not of square ones.
  const double wanted = width * height / cellArea;
  const auto atLeastOne = [](double cells) { return std::max(1, static_cast<int>(std::lround(cells))); };
  lines.columns = atLeastOne(height < 0.5 * side ? wanted : width / side);
  lines.rows = atLeastOne(width < 0.5 * side ? wanted : height * lines.columns / width);
  return lines;
}

/// Cell by cell, before slivers are merged: elements are cells that something maps to.
struct Cells {
  std::vector<ElementOverlap> overlaps;  ///< element = cell index
  std::vector<double> covered;           ///< image area per cell, signed by the majority's orientation
};

Cells cutFaces(const TriangleMesh& surface, const Points2& image, const std::vector<double>& imageAreas,
               const GridLines& lines, const Execution& execution) {
  Cells cells;
  cells.covered.assign(static_cast<std::size_t>(lines.columns) * static_cast<std::size_t>(lines.rows), 0.0);
  std::vector<FacePart> parts;
  for (int f = 0; f < surface.faceCount(); ++f) {
    if (f % 65536 == 0) {
      execution.throwIfCancelled();
      execution.report(static_cast<double>(f) / surface.faceCount(), "cutting faces by the grid");
    }
    cutFace(surface.faces(), image, f, lines, parts);
    for (const FacePart& part : parts) {
      cells.overlaps.push_back({part.cell, f, part.fraction, part.corner});
      cells.covered[static_cast<std::size_t>(part.cell)] +=
          part.fraction * imageAreas[static_cast<std::size_t>(f)];
    }
  }
  return cells;
}

/// The best covered neighbour of a sliver that is no sliver itself: across an edge, else across a corner,
/// else itself.
int hostOf(int cell, const GridLines& lines, const std::vector<double>& covered, double least) {
  constexpr std::array<std::array<int, 2>, 8> kNeighbours{
      {{0, -1}, {-1, 0}, {1, 0}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
  const int i = cell % lines.columns, j = cell / lines.columns;
  int host = cell;
  double best = least;
  for (std::size_t k = 0; k < kNeighbours.size(); ++k) {
    if (k == 4 && host != cell) break;
    const int x = i + kNeighbours[k][0], y = j + kNeighbours[k][1];
    if (x < 0 || y < 0 || x >= lines.columns || y >= lines.rows) continue;
    const double here = covered[static_cast<std::size_t>(x + lines.columns * y)];
    if (here > best || (here == best && here > 0.0 && host == cell)) {
      best = here;
      host = x + lines.columns * y;
    }
  }
  return host;
}

/// The host of every cell: itself, its neighbour when it is a sliver, or −1 when nothing maps to it.
std::vector<int> hosts(const Cells& cells, const GridLines& lines, double mergeBelow) {
  std::vector<char> used(cells.covered.size(), 0);
  for (const ElementOverlap& overlap : cells.overlaps) used[static_cast<std::size_t>(overlap.element)] = 1;
  std::vector<int> result(cells.covered.size(), -1);
  const double least = mergeBelow * lines.cellArea();
  for (std::size_t c = 0; c < result.size(); ++c) {
    if (!used[c]) continue;
    const int cell = static_cast<int>(c);
    result[c] =
        mergeBelow > 0.0 && cells.covered[c] < least ? hostOf(cell, lines, cells.covered, least) : cell;
  }
  return result;
}

void addElements(ElementGrid& grid, const Cells& cells, const std::vector<int>& host) {
  const GridLines& lines = grid.lines;
  grid.cellElement.assign(host.size(), -1);
  for (std::size_t c = 0; c < host.size(); ++c) {
    if (host[c] != static_cast<int>(c)) continue;
    grid.cellElement[c] = static_cast<int>(grid.elements.size());
    Element element;
    element.i = static_cast<int>(c) % lines.columns;
    element.j = static_cast<int>(c) / lines.columns;
    element.lower = {lines.line(0, element.i), lines.line(1, element.j)};
    element.upper = {lines.line(0, element.i + 1), lines.line(1, element.j + 1)};
    element.imageArea = cells.covered[c];
    element.interior = cells.covered[c] >= (1.0 - kWholeCell) * lines.cellArea();
    grid.elements.push_back(element);
  }
  for (std::size_t c = 0; c < host.size(); ++c) {
    if (host[c] < 0 || host[c] == static_cast<int>(c)) continue;
    grid.cellElement[c] = grid.cellElement[static_cast<std::size_t>(host[c])];
    Element& element = grid.elements[static_cast<std::size_t>(grid.cellElement[c])];
    const int i = static_cast<int>(c) % lines.columns, j = static_cast<int>(c) / lines.columns;
    element.lower = {std::min(element.lower[0], lines.line(0, i)),
                     std::min(element.lower[1], lines.line(1, j))};
    element.upper = {std::max(element.upper[0], lines.line(0, i + 1)),
                     std::max(element.upper[1], lines.line(1, j + 1))};
    element.imageArea += cells.covered[c];
    element.interior = false;
  }
}

/// Overlaps by element and face; the parts of one face that lie in one element become one.
void addOverlaps(ElementGrid& grid, std::vector<ElementOverlap> parts) {
  for (ElementOverlap& part : parts) part.element = grid.cellElement[static_cast<std::size_t>(part.element)];
  std::stable_sort(parts.begin(), parts.end(), [](const ElementOverlap& a, const ElementOverlap& b) {
    return a.element < b.element || (a.element == b.element && a.face < b.face);
  });
  for (const ElementOverlap& part : parts) {
    if (grid.overlaps.empty() || grid.overlaps.back().element != part.element ||
        grid.overlaps.back().face != part.face) {
      grid.overlaps.push_back(part);
      continue;
    }
    ElementOverlap& whole = grid.overlaps.back();
    const double sum = whole.fraction + part.fraction;
    for (std::size_t k = 0; k < 3; ++k) {
      whole.corner[k] = (whole.fraction * whole.corner[k] + part.fraction * part.corner[k]) / sum;
    }
    whole.fraction = sum;
  }
  grid.firstOverlap.assign(grid.elements.size() + 1, 0);
  for (const ElementOverlap& overlap : grid.overlaps)
    ++grid.firstOverlap[static_cast<std::size_t>(overlap.element) + 1];
  std::partial_sum(grid.firstOverlap.begin(), grid.firstOverlap.end(), grid.firstOverlap.begin());
}

void measureElements(ElementGrid& grid, const TriangleMesh& surface) {
  std::vector<double> faceAreas(static_cast<std::size_t>(surface.faceCount()));
  for (int f = 0; f < surface.faceCount(); ++f) {
    faceAreas[static_cast<std::size_t>(f)] = faceArea(surface, f);
    grid.surfaceArea += faceAreas[static_cast<std::size_t>(f)];
  }
  for (const ElementOverlap& overlap : grid.overlaps) {
    const double area = overlap.fraction * faceAreas[static_cast<std::size_t>(overlap.face)];
    Element& element = grid.elements[static_cast<std::size_t>(overlap.element)];
    element.area += area;
    for (int k = 0; k < 3; ++k) {
      element.centroid +=
          area * overlap.corner[static_cast<std::size_t>(k)] * surface.corner(overlap.face, k);
    }
  }
  for (Element& element : grid.elements) {
    if (element.area > 0.0) element.centroid /= element.area;
    element.targetArea = grid.surfaceArea * element.imageArea / grid.imageArea;
  }
}

ElementDeviation deviationOf(const std::vector<Element>& elements) {
  ElementDeviation result;
  int measured = 0;
  for (const Element& element : elements) {
    if (!(element.targetArea > 0.0)) continue;
    const double deviation = std::abs(element.area / element.targetArea - 1.0);
    ++measured;
    result.mean += deviation;
    result.maximum = std::max(result.maximum, deviation);
    if (!element.interior) continue;
    ++result.interiorElements;
    result.interiorMean += deviation;
    result.interiorMaximum = std::max(result.interiorMaximum, deviation);
  }
  if (measured > 0) result.mean /= measured;
  if (result.interiorElements > 0) result.interiorMean /= result.interiorElements;
  return result;
}

void findDominantElements(ElementGrid& grid, const TriangleMesh& surface) {
  std::vector<double> most(static_cast<std::size_t>(surface.faceCount()), 0.0);
  grid.faceElement.assign(most.size(), -1);
  for (const ElementOverlap& overlap : grid.overlaps) {
    const auto f = static_cast<std::size_t>(overlap.face);
    if (overlap.fraction > most[f]) {
      most[f] = overlap.fraction;
      grid.faceElement[f] = overlap.element;
    }
  }
  most.assign(static_cast<std::size_t>(surface.vertexCount()), 0.0);
  grid.vertexElement.assign(most.size(), -1);
  for (int e = 0; e < static_cast<int>(grid.elements.size()); ++e) {
    for (const VertexWeight& weight : vertexWeights(surface, grid, e)) {
      const auto v = static_cast<std::size_t>(weight.vertex);
      if (weight.area > most[v]) {
        most[v] = weight.area;
        grid.vertexElement[v] = e;
      }
    }
  }
}

/// Image areas signed so that the majority is positive; fills the lists of flipped and collapsed faces.
std::vector<double> orientedImageAreas(ElementGrid& grid, const Faces& faces, const Points2& image) {
  std::vector<double> areas(static_cast<std::size_t>(faces.rows()));
  double sum = 0.0, magnitude = 0.0;
  for (int f = 0; f < static_cast<int>(faces.rows()); ++f) {
    const double area = imageFaceArea(faces, image, f);
    areas[static_cast<std::size_t>(f)] = area;
    sum += area;
    magnitude += std::abs(area);
  }
  if (!(magnitude > 0.0) || !(std::abs(sum) > 1e-9 * magnitude)) {
    throw GeometryError("An image with positive area is required, but the areas of its faces sum to " +
                        std::to_string(sum) + "; the map has collapsed or folds onto itself.");
  }
  for (std::size_t f = 0; f < areas.size(); ++f) {
    if (sum < 0.0) areas[f] = -areas[f];
    if (std::abs(areas[f]) < 1e-14 * magnitude) {
      grid.zeroAreaFaces.push_back(static_cast<int>(f));
    } else if (areas[f] < 0.0) {
      grid.flippedFaces.push_back(static_cast<int>(f));
    }
  }
  grid.imageArea = std::abs(sum);
  return areas;
}

}  // namespace

void ElementGridOptions::validate() const {
  if (!(std::isfinite(elementArea) && elementArea >= 0.0)) {
    throw InvalidArgument("An element area of 0 (unused) or more mm² is required, but it is " +
                          std::to_string(elementArea) + ".");
  }
  if (elementArea == 0.0 && elements < 1) {
    throw InvalidArgument("At least 1 element is required, but " + std::to_string(elements) +
                          " are asked for.");
  }
  if (!(mergeBelow >= 0.0 && mergeBelow <= 0.5)) {
    throw InvalidArgument("A merge fraction from 0 to 0.5 is required, but it is " +
                          std::to_string(mergeBelow) + ".");
  }
}

int GridLines::locate(int axis, double x) const {
  const int n = axis == 0 ? columns : rows;
  const auto a = static_cast<std::size_t>(axis);
  const double position = (x - lower[a]) / (upper[a] - lower[a]) * n;
  int k = position <= 0.0 ? 0 : position >= n ? n - 1 : static_cast<int>(position);
  while (k > 0 && x < line(axis, k)) --k;
  while (k + 1 < n && x >= line(axis, k + 1)) ++k;
  return k;
}

ElementGrid elementGrid(const TriangleMesh& surface, const Points2& image, const ElementGridOptions& options,
                        const Execution& execution) {
  options.validate();
  requireImage(surface, image);
  ElementGrid grid;
  const Box frame = gridFrame(surface, image, options.frame);
  const std::vector<double> imageAreas = orientedImageAreas(grid, surface.faces(), image);
  double surfaceArea = 0.0;
  for (int f = 0; f < surface.faceCount(); ++f) surfaceArea += faceArea(surface, f);
  if (!(surfaceArea > 0.0)) {
    throw GeometryError(
        "A surface with positive area is required, but the areas of its faces sum to 0; repair it.");
  }
  grid.lines = tile(frame, options.elementArea > 0.0 ? options.elementArea * grid.imageArea / surfaceArea
                                                     : grid.imageArea / options.elements);
  Cells cells = cutFaces(surface, image, imageAreas, grid.lines, execution);
  addElements(grid, cells, hosts(cells, grid.lines, options.mergeBelow));
  addOverlaps(grid, std::move(cells.overlaps));
  measureElements(grid, surface);
  grid.deviation = deviationOf(grid.elements);
  findDominantElements(grid, surface);
  execution.report(1.0, "cutting faces by the grid");
  return grid;
}

std::vector<VertexWeight> vertexWeights(const TriangleMesh& surface, const ElementGrid& grid, int element) {
  std::vector<VertexWeight> parts;
  const auto e = static_cast<std::size_t>(element);
  for (std::size_t o = grid.firstOverlap[e]; o < grid.firstOverlap[e + 1]; ++o) {
    const ElementOverlap& overlap = grid.overlaps[o];
    const double area = overlap.fraction * faceArea(surface, overlap.face);
    for (int k = 0; k < 3; ++k) {
      parts.push_back({surface.faces()(overlap.face, k), area * overlap.corner[static_cast<std::size_t>(k)]});
    }
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const VertexWeight& a, const VertexWeight& b) { return a.vertex < b.vertex; });
  std::vector<VertexWeight> result;
  for (const VertexWeight& part : parts) {
    if (!(part.area > 0.0)) continue;
    if (!result.empty() && result.back().vertex == part.vertex) {
      result.back().area += part.area;
    } else {
      result.push_back(part);
    }
  }
  return result;
}

}  // namespace authalic
