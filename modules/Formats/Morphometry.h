/// @file
/// Numbers, regions and lists of vertices that go with a surface.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

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

/// One number per vertex from a FreeSurfer morphometry file (curv, thickness, sulc, area; new and old
/// layout), an .mgh/.mgz of n×1×1, the first metric of a GIFTI file, or text with one number per line ("n/a"
/// and "nan" are NaN, lines that begin with # are passed over). Gzip is undone.
///
/// NaN means no value. Signs are as in the file: FreeSurfer's curv and sulc are positive in sulci.
/// @throws FormatError when the file is missing, of another kind, truncated or inconsistent
[[nodiscard]] std::vector<float> readVertexScalars(const std::string& path);

/// FreeSurfer annotation (.annot, both colour-table layouts, gzipped or not) or the first label array of a
/// .label.gii. Vertices are placed by their number in the file, in whatever order they come; labels are the
/// ids of the table (position for the old layout and for files without table the packed colour r + 256 g +
/// 65536 b).
/// @throws FormatError as readVertexScalars does
[[nodiscard]] Annotation readAnnot(const std::string& path);

/// The vertices of a FreeSurfer .label text file, in its order; entries without vertex (-1) are left out.
/// @throws FormatError as readVertexScalars does
[[nodiscard]] std::vector<int> readLabel(const std::string& path);

/// New-layout FreeSurfer morphometry file.
/// @param faceCount  number of triangles of the surface, which the file states; readers ignore it
/// @throws FormatError when the file cannot be written
void writeMorphometry(const std::string& path, const std::vector<float>& values, int faceCount = 0);

}  // namespace authalic
