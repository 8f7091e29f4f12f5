#include "Formats/Cifti.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "Core/base/Error.h"
#include "Formats/InputFile.h"
#include "Formats/NiftiHeader.h"
#include "Formats/TextNumbers.h"
#include "Formats/XmlReader.h"

namespace authalic {

namespace {

constexpr std::uint64_t kHeaderSize = 540;
constexpr std::int32_t kExtensionCode = 32;

/// CIFTI_STRUCTURE_CORTEX_LEFT → CortexLeft
std::string giftiStructure(std::string name) {
  const std::string prefix = "CIFTI_STRUCTURE_";
  if (name.compare(0, prefix.size(), prefix) == 0) {
    name.erase(0, prefix.size());
  }
  std::string words;
  bool first = true;
  for (const char c : name) {
    if (c != '_') {
      const auto letter = static_cast<unsigned char>(c);
      words += static_cast<char>(first ? std::toupper(letter) : std::tolower(letter));
    }
    first = c == '_';
  }
  return words;
}

/// Collects maps and surfaces from the XML of the header extension.
class CiftiParser : private XmlReader {
 public:
  explicit CiftiParser(const std::string& path) : XmlReader(path) {}

  CiftiFile parse(std::string_view document) {
    walk(document);
    if (columnType_.empty() || rowType_.find("BRAIN_MODELS") == std::string::npos) {
      throw FormatError(path_, "A dense CIFTI file (dscalar, dlabel, dtseries) is needed, but this one maps \"" +
                                   columnType_ + "\" by \"" + rowType_ + "\"; make a dense one with wb_command.");
    }
    return std::move(file_);
  }
  /// How many values each map has by the brain models, voxels included.
  [[nodiscard]] std::int64_t rows() const noexcept { return rows_; }
  [[nodiscard]] bool series() const noexcept { return columnType_.find("SERIES") != std::string::npos; }

 private:
  void start(const std::string& element, const XmlAttributes& attributes) override {
    if (!sawRoot_ && element != "CIFTI") {
      throw FormatError(path_, "A CIFTI document is needed, but the root element is <" + element + ">.");
    }
    sawRoot_ = true;
    if (element == "MatrixIndicesMap") {
      startDimension(attributes);
    } else if (element == "BrainModel") {
      startModel(attributes);
    } else if (element == "NamedMap") {
      file_.maps.emplace_back();
    } else if (element == "Label" && !file_.maps.empty()) {
      startRegion(attributes);
    }
  }

  void end(const std::string& element) override {
    if (element == "MapName" && !file_.maps.empty()) {
      file_.maps.back().name = trimmed(text_);
    } else if (element == "Label" && !file_.maps.empty() && !file_.maps.back().regions.empty()) {
      file_.maps.back().regions.back().name = trimmed(text_);
    } else if (element == "VertexIndices" && onSurface_) {
      endVertices();
    } else if (element == "BrainModel") {
      endModel();
    }
  }

  [[nodiscard]] static std::string get(const XmlAttributes& attributes, const char* key) {
    const auto found = attributes.find(key);
    return found == attributes.end() ? std::string() : trimmed(found->second);
  }
  [[nodiscard]] std::int64_t integer(const XmlAttributes& attributes, const char* key) const {
    const auto value = parseNumber<std::int64_t>(get(attributes, key));
    if (!value || *value < 0 || *value > 0x7FFFFFFF) {
      throw FormatError(path_, std::string("The attribute ") + key + " of the header should be a count, but is \"" +
                                   get(attributes, key) + "\".");
    }
    return *value;
  }

  void startDimension(const XmlAttributes& attributes) {
    const std::string dimensions = get(attributes, "AppliesToMatrixDimension");
    const std::string type = get(attributes, "IndicesMapToDataType");
    const bool known = type.find("SCALARS") != std::string::npos || type.find("LABELS") != std::string::npos ||
                       type.find("SERIES") != std::string::npos;
    if (dimensions.find('0') != std::string::npos) {
      columnType_ = type;
      file_.labels = type.find("LABELS") != std::string::npos;
      if (!known) {
        throw FormatError(path_, "A dense CIFTI file of scalars or labels is needed, but this one maps to " + type +
                                     "; make a dscalar or dlabel file with wb_command.");
      }
    }
    if (dimensions.find('1') != std::string::npos) {
      rowType_ = type;
    }
  }

  void startModel(const XmlAttributes& attributes) {
    const std::int64_t offset = integer(attributes, "IndexOffset");
    count_ = integer(attributes, "IndexCount");
    rows_ = std::max(rows_, offset + count_);
    onSurface_ = get(attributes, "ModelType") == "CIFTI_MODEL_TYPE_SURFACE";
    if (!onSurface_) {
      return;
    }
    CiftiSurface surface;
    surface.structure = giftiStructure(get(attributes, "BrainStructure"));
    surface.vertexCount = integer(attributes, "SurfaceNumberOfVertices");
    // Memory must not follow a bare claim: a mask leaves out a part of a surface, not nearly all of it.
    if (surface.vertexCount > std::max<std::int64_t>(1 << 20, 64 * count_)) {
      throw FormatError(path_, "The brain model of " + surface.structure + " claims " +
                                   std::to_string(surface.vertexCount) + " vertices with values for " +
                                   std::to_string(count_) + "; the header is damaged.");
    }
    surface.offset = offset;
    file_.surfaces.push_back(std::move(surface));
  }

  void endVertices() {
    CiftiSurface& surface = file_.surfaces.back();
    std::string_view rest = text_;
    for (auto token = nextToken(rest); !token.empty(); token = nextToken(rest)) {
      const auto vertex = parseNumber<int>(token);
      if (!vertex || *vertex < 0 || *vertex >= surface.vertexCount) {
        throw FormatError(path_, "A vertex of " + surface.structure + " should lie between 0 and " +
                                     std::to_string(surface.vertexCount - 1) + ", but is \"" +
                                     std::string(token.substr(0, 20)) + "\".");
      }
      surface.vertices.push_back(*vertex);
    }
  }

  void endModel() {
    if (onSurface_ && static_cast<std::int64_t>(file_.surfaces.back().vertices.size()) != count_) {
      throw FormatError(path_, "The brain model of " + file_.surfaces.back().structure + " claims " +
                                   std::to_string(count_) + " vertices, but lists " +
                                   std::to_string(file_.surfaces.back().vertices.size()) + ".");
    }
    onSurface_ = false;
  }

  void startRegion(const XmlAttributes& attributes) {
    Region region;
    const auto key = parseNumber<std::int32_t>(get(attributes, "Key"));
    if (!key) {
      throw FormatError(path_, "A label of the table has a key that is not a number.");
    }
    region.id = *key;
    const std::array<const char*, 4> names{"Red", "Green", "Blue", "Alpha"};
    for (std::size_t i = 0; i < 4; ++i) {
      const double part = parseNumber<double>(get(attributes, names[i])).value_or(i == 3 ? 1 : 0);
      region.rgba[i] = static_cast<std::uint8_t>(std::lround(255 * (part > 0 ? std::min(part, 1.0) : 0.0)));
    }
    file_.maps.back().regions.push_back(region);
  }

  CiftiFile file_;
  std::string columnType_, rowType_;
  std::int64_t rows_ = 0;
  std::int64_t count_ = 0;
  bool onSurface_ = false;
  bool sawRoot_ = false;
};

/// What of the NIfTI-2 header matters to a matrix.
struct MatrixHeader {
  std::int64_t maps = 0, rows = 0;
  VoxelCoding coding;
  std::uint64_t dataOffset = 0;
};

void setScalingAndOffset(const std::string& path, const std::uint8_t* b, MatrixHeader& header) {
  const ByteOrder order = header.coding.order;
  const auto slope = decode<double>(b + 176, order), inter = decode<double>(b + 184, order);
  if (!std::isfinite(slope) || !std::isfinite(inter)) {
    throw FormatError(path, "The scaling of the matrix should be finite numbers, but is not.", 176);
  }
  if (slope != 0) {
    header.coding.slope = slope;
    header.coding.inter = inter;
  }
  const auto offset = decode<std::int64_t>(b + 168, order);
  if (offset < 544 || offset > std::int64_t{1} << 32) {
    throw FormatError(path, "The matrix is said to begin at byte " + std::to_string(offset) +
                                ", which lies inside the header or nowhere.", 168);
  }
  header.dataOffset = static_cast<std::uint64_t>(offset);
}

MatrixHeader parseMatrixHeader(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  const auto* b = bytes.data();
  MatrixHeader header;
  const bool little = decode<std::int32_t>(b, ByteOrder::Little) == 540;
  const ByteOrder order = header.coding.order = little ? ByteOrder::Little : ByteOrder::Big;
  const auto intent = decode<std::int32_t>(b + 504, order);
  if (decode<std::int32_t>(b, order) != 540 || std::string_view(reinterpret_cast<const char*>(b) + 4, 3) != "n+2" ||
      intent < 3000 || intent > 3099) {
    throw FormatError(path, "Values on a surface are needed: a CIFTI-2 file (NIfTI-2 with an intent of 3000 to 3099), "
                            "but this is not one.", 0);
  }
  const auto dim = [b, order](std::size_t i) { return decode<std::int64_t>(b + 16 + 8 * i, order); };
  header.maps = dim(5);
  header.rows = dim(6);
  if (dim(0) != 6 || dim(1) != 1 || dim(2) != 1 || dim(3) != 1 || dim(4) != 1 || header.maps < 1 || header.rows < 1 ||
      header.maps > 0x7FFFFFFF || header.rows > 0x7FFFFFFF) {
    throw FormatError(path, "The matrix of a CIFTI file is 1 × 1 × 1 × 1 × maps × rows, but this header claims other "
                            "dimensions.", 16);
  }
  header.coding.type = niftiVoxelType(path, decode<std::int16_t>(b + 12, order));
  setScalingAndOffset(path, b, header);
  return header;
}

/// The XML among the extensions between the header and the matrix.
std::string_view findDocument(const std::string& path, const std::vector<std::uint8_t>& extensions, ByteOrder order) {
  std::size_t at = 4;
  while (at + 8 <= extensions.size()) {
    const auto size = decode<std::int32_t>(extensions.data() + at, order);
    const auto code = decode<std::int32_t>(extensions.data() + at + 4, order);
    if (size < 8 || static_cast<std::size_t>(size) > extensions.size() - at) {
      break;
    }
    if (code == kExtensionCode) {
      const std::string_view text(reinterpret_cast<const char*>(extensions.data()) + at + 8,
                                  static_cast<std::size_t>(size) - 8);
      return text.substr(0, text.find('\0'));
    }
    at += static_cast<std::size_t>(size);
  }
  throw FormatError(path, "The XML that says what the matrix means (extension 32) is missing or damaged.", 544);
}

/// Row after row, the maps of each side by side.
void fillMaps(const std::string& path, const MatrixHeader& header, const std::vector<std::uint8_t>& bytes,
              CiftiFile& file) {
  VolumeFile matrix;
  matrix.volume = decodeVoxels(bytes, header.coding, {static_cast<int>(header.maps), static_cast<int>(header.rows), 1},
                               Eigen::Matrix4d::Identity());
  const std::vector<float> values = matrix.scalars().values;
  if (file.maps.size() != static_cast<std::size_t>(header.maps)) {
    throw FormatError(path, "The header names " + std::to_string(file.maps.size()) + " maps, but the matrix has " +
                                std::to_string(header.maps) + "; the file is damaged.");
  }
  for (std::size_t m = 0; m < file.maps.size(); ++m) {
    file.maps[m].values.reserve(static_cast<std::size_t>(header.rows));
    for (std::size_t at = m; at < values.size(); at += file.maps.size()) {
      file.maps[m].values.push_back(values[at]);
    }
  }
}

}  // namespace

bool isCifti(const std::string& path) {
  const auto bytes = InputFile(path).readUpTo(kHeaderSize);
  if (bytes.size() < kHeaderSize) {
    return false;
  }
  const bool little = decode<std::int32_t>(bytes.data(), ByteOrder::Little) == 540;
  const bool big = decode<std::int32_t>(bytes.data(), ByteOrder::Big) == 540;
  const auto intent = decode<std::int32_t>(bytes.data() + 504, little ? ByteOrder::Little : ByteOrder::Big);
  return (little || big) && intent >= 3000 && intent < 3100;
}

CiftiFile readCifti(const std::string& path) {
  InputFile input(path);
  const MatrixHeader header = parseMatrixHeader(path, input.read(kHeaderSize, "the CIFTI header"));
  const auto extensions = input.read(header.dataOffset - kHeaderSize, "the XML of the CIFTI header");
  CiftiParser parser(path);
  CiftiFile file = parser.parse(findDocument(path, extensions, header.coding.order));
  if (parser.rows() != header.rows) {
    throw FormatError(path, "The brain models need " + std::to_string(parser.rows()) + " rows, but the matrix has " +
                                std::to_string(header.rows) + "; the file is damaged.");
  }
  const auto size = static_cast<std::uint64_t>(voxelSize(header.coding.type));
  const auto values = static_cast<std::uint64_t>(header.maps) * static_cast<std::uint64_t>(header.rows);
  const auto matrix = input.read(values * size, "the matrix");
  input.drain();
  for (std::int64_t m = 0; parser.series() && m < header.maps; ++m) {
    file.maps.emplace_back().name = "frame " + std::to_string(m);
  }
  fillMaps(path, header, matrix, file);
  return file;
}

const CiftiSurface& ciftiSurface(const std::string& path, const CiftiFile& file, const std::string& structure,
                                 std::size_t vertexCount) {
  const CiftiSurface* found = nullptr;
  std::string names;
  int fitting = 0;
  for (const CiftiSurface& surface : file.surfaces) {
    names += (names.empty() ? "" : ", ") + surface.structure + " (" + std::to_string(surface.vertexCount) +
             " vertices)";
    const bool fits = structure.empty() ? file.surfaces.size() == 1 ||
                                              static_cast<std::size_t>(surface.vertexCount) == vertexCount
                                        : surface.structure == structure;
    found = fits ? &surface : found;
    fitting += fits ? 1 : 0;
  }
  if (fitting != 1) {
    throw FormatError(path, "One surface of the CIFTI file is needed, but " + std::to_string(fitting) + " are " +
                                (structure.empty() ? "of that size" : "called \"" + structure + "\"") + "; it holds " +
                                (names.empty() ? "none" : names) + "; name the structure.");
  }
  return *found;
}

std::vector<float> onCiftiSurface(const CiftiSurface& surface, const CiftiMap& map, float none) {
  std::vector<float> values(static_cast<std::size_t>(surface.vertexCount), none);
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    values[static_cast<std::size_t>(surface.vertices[i])] = map.values[static_cast<std::size_t>(surface.offset) + i];
  }
  return values;
}

}  // namespace authalic
