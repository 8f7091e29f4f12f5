/// @file
/// CIFTI-2 dense files: values on both cortices (and in voxels, which are passed over) in one file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "Formats/Morphometry.h"

namespace authalic {

/// Where the values of one surface stand among all values of a map.
struct CiftiSurface {
  std::string structure;         ///< by GIFTI's name: CortexLeft, CortexRight, Cerebellum …
  std::int64_t vertexCount = 0;  ///< of the whole surface
  std::int64_t offset = 0;       ///< of the value of vertices[0]
  std::vector<int> vertices;
};

struct CiftiMap {
  std::string name;
  std::vector<Region> regions;  ///< of a dlabel file
  std::vector<float> values;    ///< one for each row of the file, all structures together
};

struct CiftiFile {
  bool labels = false;  ///< dlabel
  std::vector<CiftiSurface> surfaces;
  std::vector<CiftiMap> maps;
};

/// Whether the header is that of a CIFTI-2 file.
/// @throws FormatError when the file is missing or empty
[[nodiscard]] bool isCifti(const std::string& path);

/// Reads dscalar, dlabel and dtseries files. Memory grows with the data really there, never with the header.
/// @throws FormatError when the file is missing, of another kind (parcellated or connectivity files, for
///         instance), truncated, or its header and matrix disagree
[[nodiscard]] CiftiFile readCifti(const std::string& path);

/// The surface of that structure. An empty name is enough where there is one surface alone, or one alone of
/// `vertexCount` vertices.
/// @throws FormatError when there is none or several, naming those there are
[[nodiscard]] const CiftiSurface& ciftiSurface(const std::string& path, const CiftiFile& file,
                                               const std::string& structure, std::size_t vertexCount);

/// One value for each vertex of the surface, `none` for vertices the file leaves out (the medial wall).
[[nodiscard]] std::vector<float> onCiftiSurface(const CiftiSurface& surface, const CiftiMap& map, float none);

}  // namespace authalic
