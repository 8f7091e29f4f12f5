/// @file
/// Cortical elements: an isotropic grid on the image of a map, pulled back to the surface.
#pragma once

#include <array>
#include <vector>

#include "Core/base/Execution.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Which rectangle the grid divides.
enum class GridFrame {
  Automatic,  ///< [−1, 1]² when every point of the image lies in the unit disk and its boundary on the unit
              ///< circle (to 1e-6), else the bounding box without what bulges out of straight sides
  UnitDisk,     ///< [−1, 1]²: the same grid for every map to the unit disk
  BoundingBox,  ///< the bounding box of the image: squares and rectangles are tiled exactly
};

struct ElementGridOptions {
  /// How many elements are wanted; the grid that comes closest is taken. On a disk the cells that the circle
  /// cuts count by the part that lies inside.
  int elements = 400;
  /// Wanted native area of an element in mm²; above 0 it decides instead of `elements`.
  double elementArea = 0.0;
  GridFrame frame = GridFrame::Automatic;
  /// A cell covered by less than this fraction joins the neighbour across an edge (else a corner) that is
  /// covered most; 0 keeps every sliver an element of its own. In [0, 0.5].
  double mergeBelow = 0.25;

  /// @throws InvalidArgument
  void validate() const;
};

/// The lines of the grid: columns × rows cells on [lower, upper], as square as exact tiling allows.
struct GridLines {
  std::array<double, 2> lower{0, 0}, upper{1, 1};
  int columns = 1, rows = 1;

  /// Coordinate of line k = 0 … columns (axis 0) or rows (axis 1).
  [[nodiscard]] double line(int axis, int k) const {
    const int n = axis == 0 ? columns : rows;
    const auto a = static_cast<std::size_t>(axis);
    return k == n ? upper[a] : lower[a] + (upper[a] - lower[a]) * k / n;
  }
  /// Column or row of a coordinate: line(k) ≤ x < line(k + 1), clamped to the grid.
  [[nodiscard]] int locate(int axis, double x) const;
  [[nodiscard]] double cellArea() const {
    return (upper[0] - lower[0]) * (upper[1] - lower[1]) / (static_cast<double>(columns) * rows);
  }
};

/// One element: a cell of the grid, with the slivers that joined it.
struct Element {
  int i = 0, j = 0;                                ///< column and row of the cell
  std::array<double, 2> lower{0, 0}, upper{0, 0};  ///< u and v range of the cell (slivers included)
  double area = 0.0;                               ///< native area, mm²
  double targetArea = 0.0;                         ///< surface area × share of the image area, mm²
  double imageArea = 0.0;                          ///< part of the element that the image covers
  Eigen::Vector3d centroid{0, 0, 0};               ///< area-weighted, mm; need not lie on the surface
  bool interior = false;                           ///< exactly one cell, wholly covered by the image
};

/// The part of a face that an element owns.
struct ElementOverlap {
  int element = -1;
  int face = -1;
  double fraction = 0.0;                  ///< of the face's area, in (0, 1]; the fractions of a face sum to 1
  std::array<double, 3> corner{0, 0, 0};  ///< barycentric centroid of the part; sums to 1
};

/// |area / target − 1| over elements with a positive target.
struct ElementDeviation {
  int interiorElements = 0;
  double interiorMaximum = 0.0, interiorMean = 0.0;
  double maximum = 0.0, mean = 0.0;  ///< over all elements
};

struct ElementGrid {
  GridLines lines;
  std::vector<int> cellElement;           ///< element of cell i + columns·j, or −1 where nothing is mapped
  std::vector<Element> elements;          ///< by row, then column; element_id in tables is the index + 1
  std::vector<ElementOverlap> overlaps;   ///< by element, then face
  std::vector<std::size_t> firstOverlap;  ///< elements + 1 offsets into overlaps
  std::vector<int> faceElement;           ///< the element with the largest part of the face (ties: the lower)
  std::vector<int> vertexElement;  ///< the element with the largest part of the vertex (see vertexWeights);
                                   ///< −1 for vertices without faces
  std::vector<int> flippedFaces;   ///< faces whose image runs against the majority
  std::vector<int> zeroAreaFaces;  ///< faces whose image has no area (below 1e-14 of the whole)
  ElementDeviation deviation;
  double surfaceArea = 0.0;  ///< mm²
  double imageArea = 0.0;
};

/// Divides the image of a map into cells and the surface into elements, the preimages of the cells
/// (@cite zou2011).
///
/// The map is linear on each face, so the preimage of a cell in a face is a convex polygon. It is cut out
/// exactly, line by line (@cite sutherland1974), in barycentric coordinates: its share of the native face is
/// an affine invariant, hence also right for faces whose image is flipped or collapsed, which are listed, not
/// dropped. element area = Σ_faces A_face · fraction.
///
/// On an area-preserving map every interior element has the area surfaceArea · cellArea / imageArea;
/// `deviation` says how nearly. Square cells of the bounding box clipped by the disk, rather than a polar
/// layout, keep all interior elements congruent in the domain and in the neighbourhood of four.
///
/// Guarantees: fractions of each face sum to 1 and element areas to the surface area up to rounding (1e-12
/// relative); the result depends neither on threads nor, up to rounding, on the order of vertices and faces.
/// Does not guarantee that an element is connected where the map folds, nor equal areas when the map does not
/// preserve area. Complexity: O(faces + crossings).
///
/// @param surface  n vertices, mm
/// @param image    n×2, the image of each vertex
/// @throws GeometryError when image and surface differ in length, a coordinate is not finite, surface or
/// image
///         has no area, or the image leaves the frame by more than 1 %.
/// @throws InvalidArgument for bad options, or when more than 4,000,000 cells would result.
[[nodiscard]] ElementGrid elementGrid(const TriangleMesh& surface, const Points2& image,
                                      const ElementGridOptions& options = {},
                                      const Execution& execution = {});

/// Area (mm²) that a vertex carries in an element: the integral of its hat function over the element. With
/// it, Σ w x / Σ w is the exact mean over the element of the piecewise linear field with the vertex values x.
struct VertexWeight {
  int vertex = -1;
  double area = 0.0;
};

/// The vertices of one element, ascending, with positive weights that sum to the element's area.
[[nodiscard]] std::vector<VertexWeight> vertexWeights(const TriangleMesh& surface, const ElementGrid& grid,
                                                      int element);

/// The borders between elements, drawn on the surface.
struct ElementOutline {
  Points3 points;         ///< 2 rows per segment, mm
  Points2 image;          ///< the same points in the domain
  std::vector<int> face;  ///< per segment: the face it lies in
  /// Per segment: the elements on its two sides, lower u (or v) first.
  std::vector<std::array<int, 2>> elements;
};

/// Cuts the grid lines out of every face and carries them to the surface by barycentric coordinates. Lines
/// inside a merged element are left out; the rim of the domain is not part of the outline.
[[nodiscard]] ElementOutline elementOutline(const TriangleMesh& surface, const Points2& image,
                                            const ElementGrid& grid);

}  // namespace authalic
