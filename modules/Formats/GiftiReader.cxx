#include <algorithm>
#include <cctype>
#include <climits>
#include <cmath>
#include <utility>

#include "Core/base/Error.h"
#include "Formats/Gifti.h"
#include "Formats/GiftiData.h"
#include "Formats/InputFile.h"
#include "Formats/SurfaceParsers.h"
#include "Formats/TextNumbers.h"
#include "Formats/XmlReader.h"

namespace authalic {

namespace {

using Attributes = XmlAttributes;

const std::map<std::string, int>& intentCodes() {
  static const std::map<std::string, int> codes{
      {"NIFTI_INTENT_NONE", 0},           {"NIFTI_INTENT_CORREL", 2},
      {"NIFTI_INTENT_TTEST", 3},          {"NIFTI_INTENT_FTEST", 4},
      {"NIFTI_INTENT_ZSCORE", 5},         {"NIFTI_INTENT_CHISQ", 6},
      {"NIFTI_INTENT_NORMAL", 11},        {"NIFTI_INTENT_PVAL", 22},
      {"NIFTI_INTENT_LOGPVAL", 23},       {"NIFTI_INTENT_LOG10PVAL", 24},
      {"NIFTI_INTENT_ESTIMATE", 1001},    {"NIFTI_INTENT_LABEL", 1002},
      {"NIFTI_INTENT_GENMATRIX", 1004},   {"NIFTI_INTENT_VECTOR", 1007},
      {"NIFTI_INTENT_POINTSET", 1008},    {"NIFTI_INTENT_TRIANGLE", 1009},
      {"NIFTI_INTENT_TIME_SERIES", 2001}, {"NIFTI_INTENT_TIMESERIES", 2001},
      {"NIFTI_INTENT_NODE_INDEX", 2002},  {"NIFTI_INTENT_RGB_VECTOR", 2003},
      {"NIFTI_INTENT_RGBA_VECTOR", 2004}, {"NIFTI_INTENT_SHAPE", 2005}};
  return codes;
}

const std::map<std::string, int>& typeCodes() {
  static const std::map<std::string, int> codes{
      {"NIFTI_TYPE_UINT8", 2},       {"NIFTI_TYPE_INT16", 4},      {"NIFTI_TYPE_INT32", 8},
      {"NIFTI_TYPE_FLOAT32", 16},    {"NIFTI_TYPE_COMPLEX64", 32}, {"NIFTI_TYPE_FLOAT64", 64},
      {"NIFTI_TYPE_RGB24", 128},     {"NIFTI_TYPE_INT8", 256},     {"NIFTI_TYPE_UINT16", 512},
      {"NIFTI_TYPE_UINT32", 768},    {"NIFTI_TYPE_INT64", 1024},   {"NIFTI_TYPE_UINT64", 1280},
      {"NIFTI_TYPE_FLOAT128", 1536}, {"NIFTI_TYPE_RGBA32", 2304}};
  return codes;
}

/// Collects a GIFTI document.
class GiftiParser : private XmlReader {
 public:
  explicit GiftiParser(const std::string& path) : XmlReader(path) {}

  GiftiFile parse(const FileBytes& bytes) {
    walk({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    if (!sawRoot_) {
      throw FormatError(path_, "A GIFTI document is needed, but the XML has another root element.");
    }
    return std::move(file_);
  }

 private:
  void start(const std::string& element, const Attributes& attributes) override {
    if (!sawRoot_ && element != "GIFTI") {
      throw FormatError(path_, "A GIFTI document is needed, but the root element is <" + element + ">.");
    }
    sawRoot_ = true;
    if (element == "DataArray") {
      startArray(attributes);
    } else if (element == "Label") {
      startLabel(attributes);
    } else if (element == "MD") {
      name_.clear();
      value_.clear();
    } else if (element == "CoordinateSystemTransformMatrix" && inArray_) {
      array_.transforms.emplace_back();
    }
  }

  void end(const std::string& element) override {
    if (element == "Name") {
      name_ = trimmed(text_);
    } else if (element == "Value") {
      value_ = trimmed(text_);
    } else if (element == "MD") {
      (inArray_ ? array_.metadata : file_.metadata)[name_] = value_;
    } else if (element == "Label" && !file_.labels.empty()) {
      file_.labels.back().name = trimmed(text_);
    } else if (element == "Data" && inArray_) {
      array_.values = decodeGiftiPayload(path_, payload_, text_);
      hasData_ = true;
    } else if (element == "DataArray") {
      endArray();
    } else if (inArray_ && !array_.transforms.empty()) {
      endTransformPart(element);
    }
  }

  void endTransformPart(const std::string& element) {
    GiftiTransform& transform = array_.transforms.back();
    if (element == "DataSpace") {
      transform.dataSpace = trimmed(text_);
    } else if (element == "TransformedSpace") {
      transform.transformedSpace = trimmed(text_);
    } else if (element == "MatrixData") {
      std::string_view rest = text_;
      for (auto token = nextToken(rest); !token.empty() && transform.matrix.size() < 16;
           token = nextToken(rest)) {
        transform.matrix.push_back(parseNumber<double>(token).value_or(std::nan("")));
      }
    }
  }

  std::string required(const Attributes& attributes, const std::string& key) const {
    const auto found = attributes.find(key);
    if (found == attributes.end()) {
      throw FormatError(path_, "An array lacks its attribute " + key + ".", byteIndex());
    }
    return found->second;
  }
  std::int64_t integer(const Attributes& attributes, const std::string& key) const {
    const std::string text = trimmed(required(attributes, key));
    const auto value = parseNumber<std::int64_t>(text);
    if (!value || *value < 0) {
      throw FormatError(path_,
                        "The attribute " + key + " of an array should be a number, but is \"" + text + "\".",
                        byteIndex());
    }
    return *value;
  }
  /// The code of a name in a table, of a plain number, or -1.
  static int codeOf(const std::map<std::string, int>& codes, const std::string& name) {
    const auto found = codes.find(name);
    return found != codes.end() ? found->second : parseNumber<int>(name).value_or(-1);
  }

  void startArray(const Attributes& attributes) {
    if (inArray_) {
      throw FormatError(path_, "An array begins inside another array.", byteIndex());
    }
    inArray_ = true;
    hasData_ = false;
    array_ = GiftiArray();
    payload_ = GiftiPayload();
    array_.intent = codeOf(intentCodes(), required(attributes, "Intent"));
    payload_.type = array_.type = codeOf(typeCodes(), required(attributes, "DataType"));
    const auto dimensionality = integer(attributes, "Dimensionality");
    if (dimensionality < 1 || dimensionality > 6) {
      throw FormatError(
          path_, "An array claims " + std::to_string(dimensionality) + " dimensions; 1 to 6 are possible.",
          byteIndex());
    }
    for (int d = 0; d < dimensionality; ++d) {
      payload_.dimensions.push_back(integer(attributes, "Dim" + std::to_string(d)));
    }
    array_.dimensions = payload_.dimensions;
    setStorage(attributes);
  }

  void setStorage(const Attributes& attributes) {
    // The names in capitals are those of early writers.
    static const std::map<std::string, GiftiEncoding> encodings{
        {"ASCII", GiftiEncoding::Ascii},
        {"GIFTI_ENCODING_ASCII", GiftiEncoding::Ascii},
        {"Base64Binary", GiftiEncoding::Base64},
        {"GIFTI_ENCODING_B64BIN", GiftiEncoding::Base64},
        {"GZipBase64Binary", GiftiEncoding::GzipBase64},
        {"GIFTI_ENCODING_B64GZ", GiftiEncoding::GzipBase64},
        {"ExternalFileBinary", GiftiEncoding::External},
        {"GIFTI_ENCODING_EXTBIN", GiftiEncoding::External}};
    const std::string encoding = required(attributes, "Encoding");
    const auto found = encodings.find(encoding);
    if (found == encodings.end()) {
      throw FormatError(path_, "The encoding \"" + encoding + "\" of an array is not one of GIFTI's four.",
                        byteIndex());
    }
    payload_.encoding = found->second;
    const auto get = [&attributes](const char* key) {
      const auto at = attributes.find(key);
      return at == attributes.end() ? std::string() : at->second;
    };
    const std::string endian = get("Endian");
    payload_.order =
        endian == "BigEndian" || endian == "GIFTI_ENDIAN_BIG" ? ByteOrder::Big : ByteOrder::Little;
    payload_.columnMajor = get("ArrayIndexingOrder").find("Column") == 0;
    payload_.externalFile = get("ExternalFileName");
    payload_.externalOffset = parseNumber<std::uint64_t>(trimmed(get("ExternalFileOffset"))).value_or(0);
  }

  void startLabel(const Attributes& attributes) {
    Region region;
    const bool old = attributes.count("Key") == 0;
    const auto key = parseNumber<std::int32_t>(trimmed(required(attributes, old ? "Index" : "Key")));
    if (!key) {
      throw FormatError(path_, "A label of the table has a key that is not a number.", byteIndex());
    }
    region.id = *key;
    const std::array<const char*, 4> names{"Red", "Green", "Blue", "Alpha"};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto found = attributes.find(names[i]);
      const double part = found == attributes.end() ? (i == 3 ? 1.0 : 0.0)
                                                    : parseNumber<double>(trimmed(found->second)).value_or(0);
      const double clamped = part > 0 ? std::min(part, 1.0) : 0.0;
      region.rgba[i] = static_cast<std::uint8_t>(std::lround(255 * clamped));
    }
    file_.labels.push_back(region);
  }

  void endArray() {
    if (!hasData_) {
      if (payload_.encoding != GiftiEncoding::External) {
        throw FormatError(path_, "An array has no data.", byteIndex());
      }
      array_.values = decodeGiftiPayload(path_, payload_, {});
    }
    file_.arrays.push_back(std::move(array_));
    array_ = GiftiArray();
    inArray_ = false;
  }

  GiftiFile file_;
  GiftiArray array_;
  GiftiPayload payload_;
  std::string name_, value_;
  bool inArray_ = false;
  bool hasData_ = false;
  bool sawRoot_ = false;
};

const GiftiArray& arrayOfThree(const std::string& path, const GiftiFile& file, int intent, const char* name) {
  for (const GiftiArray& array : file.arrays) {
    if (array.intent != intent) {
      continue;
    }
    if (array.dimensions.size() != 2 || array.dimensions[1] != 3 || array.dimensions[0] > INT_MAX / 3) {
      throw FormatError(path,
                        std::string("The ") + name + " array should be n × 3, but has other dimensions.");
    }
    return array;
  }
  throw FormatError(path, std::string("A GIFTI surface is needed, but the file has no ") + name +
                              " array; it may hold data that belong to a surface.");
}

/// The 19 VolGeom entries that FreeSurfer writes.
VolumeGeometry volumeGeometryOf(const std::map<std::string, std::string>& metadata) {
  VolumeGeometry geometry;
  bool complete = true;
  const auto number = [&](const std::string& key) {
    const auto found = metadata.find("VolGeom" + key);
    const auto value = found == metadata.end() ? std::nullopt : parseNumber<double>(found->second);
    complete = complete && value && std::isfinite(*value) && std::abs(*value) < 1e9;
    return value.value_or(0);
  };
  const std::array<const char*, 3> sizes{"Width", "Height", "Depth"}, axes{"X", "Y", "Z"}, ras{"R", "A", "S"};
  for (std::size_t i = 0; i < 3; ++i) {
    const double extent = number(sizes[i]);
    geometry.dimensions[i] = complete ? static_cast<int>(extent) : 0;
    geometry.voxelSize[i] = number(std::string(axes[i]) + "size");
    geometry.center[i] = number(std::string("C_") + ras[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      geometry.directions[3 * i + k] = number(std::string(axes[i]) + "_" + ras[k]);
    }
  }
  const auto name = metadata.find("VolGeomFname");
  geometry.fileName = name == metadata.end() ? std::string() : name->second;
  geometry.valid = complete;
  return geometry;
}

bool isIdentity(const std::array<double, 16>& m) {
  bool same = true;
  for (std::size_t i = 0; i < 16; ++i) {
    same = same && std::abs(m[i] - (i % 5 == 0 ? 1.0 : 0.0)) < 1e-6;
  }
  return same;
}

/// The decision table: DataSpace first, then VolGeom, else unknown.
void decideSpace(const GiftiArray& points, SurfaceFile& surface) {
  const auto& transforms = points.transforms;
  const bool scanner = std::any_of(transforms.begin(), transforms.end(), [](const GiftiTransform& t) {
    return t.dataSpace.find("SCANNER_ANAT") != std::string::npos;
  });
  const auto& c = surface.geometry.center;
  const bool offCentre = c[0] != 0 || c[1] != 0 || c[2] != 0;
  const std::string said =
      transforms.empty() || transforms[0].dataSpace.empty() ? "no DataSpace" : transforms[0].dataSpace;
  if (scanner) {
    surface.space = CoordinateSpace::ScannerRAS;
    surface.spaceReason = "GIFTI DataSpace is NIFTI_XFORM_SCANNER_ANAT";
  } else if (surface.geometry.valid && isIdentity(surface.geometry.tkRasToScanner())) {
    surface.space = CoordinateSpace::ScannerRAS;
    surface.spaceReason = "GIFTI VolGeom for which tkRAS and scanner RAS are the same";
  } else if (surface.geometry.valid && offCentre) {
    surface.space = CoordinateSpace::TkRAS;
    surface.spaceReason = "GIFTI VolGeom with a centre and " + said + " (FreeSurfer's convention)";
  } else {
    surface.spaceReason = "GIFTI with " + said + " and no usable VolGeom";
  }
}

}  // namespace

GiftiFile readGifti(const std::string& path) {
  const FileBytes bytes = readBytes(path);
  if (recognise(bytes) != FileKind::Gifti) {
    throw FormatError(
        path, std::string("A GIFTI file is needed, but this is ") + fileKindName(recognise(bytes)) + ".");
  }
  return GiftiParser(path).parse(bytes);
}

SurfaceFile parseGiftiSurface(const std::string& path, const FileBytes& bytes) {
  const GiftiFile file = GiftiParser(path).parse(bytes);
  const GiftiArray& points = arrayOfThree(path, file, GiftiIntent::PointSet, "POINTSET");
  const GiftiArray& triangles = arrayOfThree(path, file, GiftiIntent::Triangle, "TRIANGLE");
  SurfaceFile surface;
  surface.points = points.values;
  surface.faces.reserve(triangles.values.size());
  for (const double index : triangles.values) {
    const bool fits = index >= 0 && index <= INT_MAX && index == std::floor(index);
    surface.faces.push_back(fits ? static_cast<int>(index) : -1);
  }
  surface.metadata = points.metadata;
  surface.geometry = volumeGeometryOf(points.metadata);
  decideSpace(points, surface);
  if (file.arrays.size() > 2) {
    surface.notRead = std::to_string(file.arrays.size() - 2) + " further arrays (read them as per-vertex data)";
  }
  return surface;
}

}  // namespace authalic
