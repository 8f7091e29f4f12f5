#include <algorithm>
#include <array>

#include "Core/base/Error.h"
#include "Formats/AtomicFile.h"
#include "Formats/Gifti.h"
#include "Formats/GiftiData.h"
#include "Formats/TextNumbers.h"

namespace authalic {

namespace {

/// CDATA cannot hold its own end mark: it is split over two sections.
std::string cdata(std::string text) {
  for (auto at = text.find("]]>"); at != std::string::npos; at = text.find("]]>", at + 15)) {
    text.replace(at, 3, "]]]]><![CDATA[>");
  }
  return "<![CDATA[" + text + "]]>";
}

void appendMetadata(std::string& xml, const std::map<std::string, std::string>& metadata,
                    const std::string& indent) {
  if (metadata.empty()) {
    xml += indent + "<MetaData/>\n";
    return;
  }
  xml += indent + "<MetaData>\n";
  for (const auto& [name, value] : metadata) {
    xml += indent + "  <MD><Name>" + cdata(name) + "</Name><Value>" + cdata(value) + "</Value></MD>\n";
  }
  xml += indent + "</MetaData>\n";
}

void appendLabels(std::string& xml, const std::vector<Region>& labels) {
  if (labels.empty()) {
    xml += "  <LabelTable/>\n";
    return;
  }
  xml += "  <LabelTable>\n";
  const std::array<const char*, 4> names{"Red", "Green", "Blue", "Alpha"};
  for (const Region& region : labels) {
    xml += "    <Label Key=\"" + std::to_string(region.id) + "\"";
    for (std::size_t i = 0; i < 4; ++i) {
      xml += std::string(" ") + names[i] + "=\"";
      appendNumber(xml, region.rgba[i] / 255.0);
      xml += "\"";
    }
    xml += ">" + cdata(region.name) + "</Label>\n";
  }
  xml += "  </LabelTable>\n";
}

void appendTransform(std::string& xml, const GiftiTransform& transform) {
  xml += "    <CoordinateSystemTransformMatrix>\n      <DataSpace>" + cdata(transform.dataSpace) +
         "</DataSpace>\n      <TransformedSpace>" + cdata(transform.transformedSpace) +
         "</TransformedSpace>\n      <MatrixData>";
  for (std::size_t i = 0; i < 16; ++i) {
    appendNumber(xml, i < transform.matrix.size() ? transform.matrix[i] : (i % 5 == 0 ? 1.0 : 0.0));
    xml += i % 4 == 3 ? "\n" : " ";
  }
  xml += "      </MatrixData>\n    </CoordinateSystemTransformMatrix>\n";
}

const char* intentName(const std::string& path, int intent) {
  switch (intent) {
    case GiftiIntent::None:
      return "NIFTI_INTENT_NONE";
    case GiftiIntent::Label:
      return "NIFTI_INTENT_LABEL";
    case GiftiIntent::Vector:
      return "NIFTI_INTENT_VECTOR";
    case GiftiIntent::PointSet:
      return "NIFTI_INTENT_POINTSET";
    case GiftiIntent::Triangle:
      return "NIFTI_INTENT_TRIANGLE";
    case GiftiIntent::TimeSeries:
      return "NIFTI_INTENT_TIME_SERIES";
    case GiftiIntent::NodeIndex:
      return "NIFTI_INTENT_NODE_INDEX";
    case GiftiIntent::Rgb:
      return "NIFTI_INTENT_RGB_VECTOR";
    case GiftiIntent::Rgba:
      return "NIFTI_INTENT_RGBA_VECTOR";
    case GiftiIntent::Shape:
      return "NIFTI_INTENT_SHAPE";
    default:
      break;
  }
  throw FormatError(path,
                    "An array with intent code " + std::to_string(intent) + " is not written to GIFTI.");
}

const char* typeName(const std::string& path, int type) {
  switch (type) {
    case GiftiType::Uint8:
      return "NIFTI_TYPE_UINT8";
    case GiftiType::Int32:
      return "NIFTI_TYPE_INT32";
    case GiftiType::Float32:
      return "NIFTI_TYPE_FLOAT32";
    default:
      break;
  }
  throw FormatError(path, "GIFTI arrays are written as UINT8, INT32 or FLOAT32, not as type code " +
                              std::to_string(type) + ".");
}

void checkDimensions(const std::string& path, const GiftiArray& array) {
  std::int64_t count = array.dimensions.empty() ? 0 : 1;
  for (const auto d : array.dimensions) {
    count *= d;
  }
  if (count != static_cast<std::int64_t>(array.values.size())) {
    throw FormatError(path, "An array to write has " + std::to_string(array.values.size()) +
                                " values, but its dimensions ask for " + std::to_string(count) + ".");
  }
}

void appendArray(std::string& xml, const std::string& path, const GiftiArray& array) {
  checkDimensions(path, array);
  xml += std::string("  <DataArray Intent=\"") + intentName(path, array.intent) + "\" DataType=\"" +
         typeName(path, array.type) + "\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"" +
         std::to_string(array.dimensions.size()) + "\"";
  for (std::size_t d = 0; d < array.dimensions.size(); ++d) {
    xml += " Dim" + std::to_string(d) + "=\"" + std::to_string(array.dimensions[d]) + "\"";
  }
  xml +=
      " Encoding=\"GZipBase64Binary\" Endian=\"LittleEndian\" ExternalFileName=\"\" "
      "ExternalFileOffset=\"\">\n";
  appendMetadata(xml, array.metadata, "    ");
  for (const GiftiTransform& transform : array.transforms) {
    appendTransform(xml, transform);
  }
  xml += "    <Data>" + encodeGiftiPayload(array.values, array.type) + "</Data>\n  </DataArray>\n";
}

void addVolumeGeometry(std::map<std::string, std::string>& metadata, const VolumeGeometry& geometry) {
  const std::array<const char*, 3> sizes{"Width", "Height", "Depth"}, axes{"X", "Y", "Z"}, ras{"R", "A", "S"};
  const auto put = [&metadata](const std::string& key, double value) {
    std::string text;
    appendNumber(text, value);
    metadata["VolGeom" + key] = text;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    put(sizes[i], geometry.dimensions[i]);
    put(std::string(axes[i]) + "size", geometry.voxelSize[i]);
    put(std::string("C_") + ras[i], geometry.center[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      put(std::string(axes[i]) + "_" + ras[k], geometry.directions[3 * i + k]);
    }
  }
  metadata["VolGeomFname"] = geometry.fileName;
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::map<std::string, std::string> structureMetadata(const std::string& structure) {
  std::map<std::string, std::string> metadata;
  if (!structure.empty()) {
    metadata["AnatomicalStructurePrimary"] = structure;
  }
  return metadata;
}

}  // namespace

void writeGifti(const std::string& path, const GiftiFile& file) {
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n"
      "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"" +
      std::to_string(file.arrays.size()) + "\">\n";
  appendMetadata(xml, file.metadata, "  ");
  appendLabels(xml, file.labels);
  for (const GiftiArray& array : file.arrays) {
    appendArray(xml, path, array);
  }
  xml += "</GIFTI>\n";
  writeFileAtomically(path, xml);
}

void writeGiftiSurface(const std::string& path, const SurfaceFile& original) {
  SurfaceFile surface = original;
  toScannerRas(surface);
  const bool known = surface.space == CoordinateSpace::ScannerRAS;
  GiftiArray points;
  points.intent = GiftiIntent::PointSet;
  points.dimensions = {static_cast<std::int64_t>(surface.vertexCount()), 3};
  points.metadata = surface.metadata;
  const auto type = points.metadata.find("GeometricType");
  if (type != points.metadata.end() && type->second == "Sphere") {
    type->second = "Spherical";
  }
  if (surface.geometry.valid) {
    addVolumeGeometry(points.metadata, surface.geometry);
  }
  const std::string space = known ? "NIFTI_XFORM_SCANNER_ANAT" : "NIFTI_XFORM_UNKNOWN";
  points.transforms.push_back({space, space, {}});
  points.values = std::move(surface.points);

  GiftiArray triangles;
  triangles.intent = GiftiIntent::Triangle;
  triangles.type = GiftiType::Int32;
  triangles.dimensions = {static_cast<std::int64_t>(surface.faceCount()), 3};
  triangles.values.assign(surface.faces.begin(), surface.faces.end());

  GiftiFile file;
  file.arrays.push_back(std::move(points));
  file.arrays.push_back(std::move(triangles));
  writeGifti(path, file);
}

void writeGiftiScalars(const std::string& path, const std::vector<NamedScalars>& arrays,
                       const std::string& structure) {
  GiftiFile file;
  file.metadata = structureMetadata(structure);
  for (const NamedScalars& scalars : arrays) {
    if (scalars.values.size() != arrays.front().values.size()) {
      throw FormatError(path, "All arrays of a GIFTI file need one length, but \"" + arrays.front().name +
                                  "\" has " + std::to_string(arrays.front().values.size()) +
                                  " values and \"" + scalars.name + "\" has " +
                                  std::to_string(scalars.values.size()) + ".");
    }
    GiftiArray array;
    array.intent = endsWith(path, ".func.gii") ? GiftiIntent::None : GiftiIntent::Shape;
    array.dimensions = {static_cast<std::int64_t>(scalars.values.size())};
    array.metadata["Name"] = scalars.name;
    array.values.assign(scalars.values.begin(), scalars.values.end());
    file.arrays.push_back(std::move(array));
  }
  writeGifti(path, file);
}

void writeGiftiLabels(const std::string& path, const Annotation& annotation, const std::string& structure) {
  GiftiFile file;
  file.metadata = structureMetadata(structure);
  file.labels = annotation.regions;
  const bool hasZero =
      std::any_of(file.labels.begin(), file.labels.end(), [](const Region& r) { return r.id == 0; });
  if (!hasZero) {
    file.labels.insert(file.labels.begin(), Region{0, "???", {0, 0, 0, 0}});
  }
  GiftiArray array;
  array.intent = GiftiIntent::Label;
  array.type = GiftiType::Int32;
  array.dimensions = {static_cast<std::int64_t>(annotation.labels.size())};
  array.metadata["Name"] = "labels";
  array.values.reserve(annotation.labels.size());
  for (const std::int32_t id : annotation.labels) {
    array.values.push_back(id == -1 ? 0 : id);
  }
  file.arrays.push_back(std::move(array));
  writeGifti(path, file);
}

}  // namespace authalic
