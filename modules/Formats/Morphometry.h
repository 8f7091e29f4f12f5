/// @file
/// Numbers, regions and lists of vertices that go with a surface.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "Formats/Space.h"

namespace authalic {

/// A region of a parcellation.
struct Region {
  std::int32_t id = 0;
  std::string name;
  std::array<std::uint8_t, 4> rgba{0, 0, 0, 255};
};

/// A parcellation of a surface.
struct Annotation {
  std::vector<std::int32_t> labels;   ///< n, the id of each vertex's region; -1 = none
  std::vector<Region> regions;        ///< in the order of the file
  std::vector<std::string> warnings;  ///< two regions of one colour, for instance
};

/// Numbers for some vertices of a surface.
struct SparseScalars {
  std::vector<int> vertices;  ///< each once
  std::vector<float> values;  ///< one for each of them
};

/// One number per vertex from a FreeSurfer morphometry file (curv, thickness, sulc, area; new and old
/// layout), a FreeSurfer w file, an .mgh, .mgz or .nii of n×1×1, the first metric of a GIFTI file, the first overlay of
/// an MZ3 file, or text with one number per line ("n/a" and "nan" are NaN, lines that begin with # are passed
/// over). Gzip is undone.
///
/// NaN means no value. Signs are as in the file: FreeSurfer's curv and sulc are positive in sulci.
/// @param vertexCount  of the surface; needed by files that list some vertices only (w, GIFTI's NODE_INDEX),
///                     the others become NaN; ignored by all else
/// @throws FormatError when the file is missing, of another kind, truncated or inconsistent, or lists some
///         vertices only and `vertexCount` is 0 or too small
[[nodiscard]] std::vector<float> readVertexScalars(const std::string& path, std::size_t vertexCount = 0);

/// A FreeSurfer w ("paint") file; it has no magic number, so its length must fit exactly.
/// @throws FormatError as readVertexScalars does, and when a vertex comes twice
[[nodiscard]] SparseScalars readPaint(const std::string& path);

/// FreeSurfer annotation (.annot, both colour-table layouts, gzipped or not) or the first label array of a
/// .label.gii. Vertices are placed by their number in the file, in whatever order they come; labels are the
/// ids of the table (position for the old layout and for files without table the packed colour r + 256 g +
/// 65536 b).
/// @param vertexCount  as for readVertexScalars; vertices that a sparse file does not list get -1
/// @throws FormatError as readVertexScalars does
[[nodiscard]] Annotation readAnnot(const std::string& path, std::size_t vertexCount = 0);

/// Vertices and values of a FreeSurfer .label text file, in its order; entries without vertex (-1) are left out.
/// @throws FormatError as readVertexScalars does
[[nodiscard]] SparseScalars readLabel(const std::string& path);

/// Every frame of an .mgh, .mgz or NIfTI file of n × 1 × 1, each one number per vertex.
/// @throws FormatError as readVertexScalars does, and when the file is a volume
[[nodiscard]] std::vector<std::vector<float>> readVertexFrames(const std::string& path);

/// New-layout FreeSurfer morphometry file.
/// @param faceCount  number of triangles of the surface, which the file states; readers ignore it
/// @throws FormatError when the file cannot be written
void writeMorphometry(const std::string& path, const std::vector<float>& values, int faceCount = 0);

/// FreeSurfer w file of the values that are not NaN.
/// @throws FormatError when there are more than its 24 bits count or the file cannot be written
void writePaint(const std::string& path, const std::vector<float>& values);

/// FreeSurfer annotation with the new colour table. Vertices without region (-1) are stored as 0.
///
/// The file knows a region by its colour alone, so what cannot be told apart by colour is refused, never merged.
/// @throws FormatError when two regions share a colour or number, an id is negative, a label is not in the
///         table, vertices without region meet a black region (black means none), or it cannot be written
void writeAnnot(const std::string& path, const Annotation& annotation);

/// FreeSurfer label: numbers of vertices, their points (3 each) and values.
/// @param space  what the first line states: tkRAS, scanner, or nothing when unknown
/// @throws FormatError when the counts differ or the file cannot be written
void writeLabel(const std::string& path, const std::vector<int>& vertices, const std::vector<double>& points,
                const std::vector<float>& values, CoordinateSpace space);

}  // namespace authalic
