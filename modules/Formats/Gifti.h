/// @file
/// GIFTI files: arrays on surfaces in XML.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "Formats/Morphometry.h"
#include "Formats/SurfaceFile.h"

namespace authalic {

/// NIfTI codes of what an array means. Workbench marks every metric Normal, so meaning is not taken from the
/// intent alone: any one-dimensional array of numbers is a metric.
namespace GiftiIntent {
constexpr int None = 0, Label = 1002, Vector = 1007, PointSet = 1008, Triangle = 1009, TimeSeries = 2001,
              NodeIndex = 2002, Rgb = 2003, Rgba = 2004, Shape = 2005;
}
/// NIfTI codes of number types. Workbench accepts the first three only, and only these are written.
namespace GiftiType {
constexpr int Uint8 = 2, Int32 = 8, Float32 = 16, Int16 = 4, Float64 = 64, Int8 = 256, Uint16 = 512,
              Uint32 = 768, Int64 = 1024, Uint64 = 1280;
}

/// A `CoordinateSystemTransformMatrix`: recorded, never applied.
struct GiftiTransform {
  std::string dataSpace, transformedSpace;
  std::vector<double> matrix;  ///< 16 numbers, row-major
};

/// One `DataArray`.
struct GiftiArray {
  int intent = GiftiIntent::None;
  int type = GiftiType::Float32;
  std::vector<std::int64_t> dimensions;
  std::map<std::string, std::string> metadata;
  std::vector<GiftiTransform> transforms;
  std::vector<double> values;  ///< in row-major order whatever the order in the file; exact for 32-bit types
};

struct GiftiFile {
  std::map<std::string, std::string> metadata;
  std::vector<Region> labels;
  std::vector<GiftiArray> arrays;
};

/// Reads every array of a GIFTI file, gzipped or not: encodings ASCII, Base64Binary, GZipBase64Binary and
/// ExternalFileBinary; row and column major; both byte orders; all integer and floating-point types of 8 to
/// 64 bits.
///
/// The product of the dimensions must equal the number of values really decoded; memory grows with the
/// latter.
/// @throws FormatError when the XML is malformed or ends early, a number does not parse, dimensions and data
///         disagree, the type is complex, RGB or quadruple, or an external file is missing or too short
[[nodiscard]] GiftiFile readGifti(const std::string& path);

/// Makes dense what a NODE_INDEX array lists for some vertices: every other one-dimensional array gets one value
/// for each of `vertexCount` vertices (NaN, of labels -1, where nothing is listed), and NODE_INDEX goes. Files
/// without one stay as they are.
/// @throws FormatError when `vertexCount` is 0, an index is no vertex or comes twice, or lengths differ
void spreadNodeIndex(const std::string& path, GiftiFile& file, std::size_t vertexCount);

/// The first label array of a file, with its table.
/// @throws FormatError when there is none of one dimension or a label is no 32-bit whole number
[[nodiscard]] Annotation giftiAnnotation(const std::string& path, const GiftiFile& file);

/// Writes LittleEndian, GZipBase64Binary, RowMajorOrder with names and values in CDATA.
/// @throws FormatError when an array is not UINT8, INT32 or FLOAT32, its dimensions and values disagree, or
/// the file
///         cannot be written
void writeGifti(const std::string& path, const GiftiFile& file);

/// `.surf.gii`: points in scanner RAS with DataSpace NIFTI_XFORM_SCANNER_ANAT and an identity matrix (tkRAS
/// is converted first); unknown space is written as NIFTI_XFORM_UNKNOWN. VolGeom is written when the geometry
/// is known. Metadata of the surface go to the point array, so AnatomicalStructurePrimary (CortexLeft …),
/// AnatomicalStructureSecondary and GeometricType (Anatomical, Flat, Spherical …; "Sphere" becomes Spherical)
/// do. Coordinates become 32-bit. @throws FormatError when the file cannot be written
void writeGiftiSurface(const std::string& path, const SurfaceFile& surface);

/// One named array for a `.shape.gii` or `.func.gii`.
struct NamedScalars {
  std::string name;
  std::vector<float> values;
};

/// `.shape.gii` / `.func.gii`: one array per entry (intent SHAPE, or NONE when the name ends in `.func.gii`).
/// `structure` is AnatomicalStructurePrimary, which Workbench wants on the file; may be empty.
/// @throws FormatError when arrays differ in length or the file cannot be written
void writeGiftiScalars(const std::string& path, const std::vector<NamedScalars>& arrays,
                       const std::string& structure = "");

/// `.label.gii`: one array of region ids with its table; id 0 is added as "???" when the table lacks it.
/// Ids -1 (no region) become 0. @throws FormatError when the file cannot be written
void writeGiftiLabels(const std::string& path, const Annotation& annotation,
                      const std::string& structure = "");

}  // namespace authalic
