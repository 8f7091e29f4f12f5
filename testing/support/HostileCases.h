/// @file
/// One small file per reader, how it is written, and how what is read of it is held to itself: shared by the tests of
/// altered files and the fuzzer.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "Formats/ByteCursor.h"
#include "Formats/Cifti.h"
#include "Formats/FreeSurferPatch.h"
#include "Formats/Gifti.h"
#include "Formats/Morphometry.h"
#include "Formats/Mz3.h"
#include "Formats/StoredVolume.h"
#include "Formats/SurfaceFile.h"
#include "Formats/VolumeFile.h"
#include "support/Nifti2Bytes.h"
#include "support/TestMeshes.h"

namespace authalic::testing {

struct HostileCase {
  const char* name;
  std::function<void(const std::string&)> write;
  /// Reads and throws std::logic_error when the result contradicts itself.
  std::function<void(const std::string&)> read;
};

inline void require(bool holds, const char* what) {
  if (!holds) {
    throw std::logic_error(what);
  }
}

inline SurfaceFile sphere() {
  const TriangleMesh mesh = authalic::testing::sphereMesh(1);
  SurfaceFile surface;
  surface.points.assign(mesh.points().data(), mesh.points().data() + mesh.points().size());
  surface.faces.assign(mesh.faces().data(), mesh.faces().data() + mesh.faces().size());
  surface.space = CoordinateSpace::TkRAS;
  surface.geometry.valid = true;
  surface.geometry.center = {1, 2, 3};
  return surface;
}

inline void readConsistentSurface(const std::string& path) {
  SurfaceFile surface = readSurface(path);
  require(surface.points.size() % 3 == 0 && surface.faces.size() % 3 == 0, "not whole vertices or faces");
  for (const int index : surface.faces) {
    require(index >= 0 && static_cast<std::size_t>(index) < surface.vertexCount(), "index out of range");
  }
  toScannerRas(surface);
}

inline void readConsistentVolume(const std::string& path) {
  const VolumeFile file = readVolume(path);
  const auto& d = file.dimensions();
  const auto scalars = file.scalars();
  require(scalars.values.size() == static_cast<std::size_t>(d[0]) * d[1] * d[2], "wrong number of voxels");
  require(scalars.values.size() < 100000, "voxels from nowhere");
  require(file.voxelToWorld().allFinite() && std::abs(file.voxelToWorld().determinant()) > 0, "affine");
  const StoredVolume stored = readStoredVolume(path, {0, true, true, VolumeTransform::Automatic});
  const std::size_t all = scalars.values.size() * static_cast<std::size_t>(stored.framesHeld);
  require(stored.bytes.size() == all * static_cast<std::size_t>(voxelSize(stored.type)), "wrong number of bytes");
  require(stored.framesHeld == file.frames, "frames");
}

inline void writeBytesOf(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// Two maps on a surface of ten vertices, of which four have values.
inline void writeSmallCifti(const std::string& path) {
  const std::string xml =
      "<CIFTI Version=\"2\"><Matrix><MatrixIndicesMap AppliesToMatrixDimension=\"0\" "
      "IndicesMapToDataType=\"CIFTI_INDEX_TYPE_SCALARS\"><NamedMap><MapName>a</MapName></NamedMap>"
      "<NamedMap><MapName>b</MapName></NamedMap></MatrixIndicesMap><MatrixIndicesMap AppliesToMatrixDimension=\"1\" "
      "IndicesMapToDataType=\"CIFTI_INDEX_TYPE_BRAIN_MODELS\"><BrainModel IndexOffset=\"0\" IndexCount=\"4\" "
      "ModelType=\"CIFTI_MODEL_TYPE_SURFACE\" BrainStructure=\"CIFTI_STRUCTURE_CORTEX_LEFT\" "
      "SurfaceNumberOfVertices=\"10\"><VertexIndices>1 4 5 9</VertexIndices></BrainModel></MatrixIndicesMap></Matrix>"
      "</CIFTI>";
  std::vector<std::uint8_t> bytes = nifti2Bytes({16, 32, {6, 1, 1, 1, 1, 2, 4, 1}, 0, 3006, 32, xml});
  for (int i = 0; i < 8; ++i) {
    encode(bytes, static_cast<float>(i), ByteOrder::Little);
  }
  writeBytesOf(path, bytes);
}

inline void readConsistentCifti(const std::string& path) {
  const CiftiFile file = readCifti(path);
  for (const CiftiSurface& surface : file.surfaces) {
    for (const CiftiMap& map : file.maps) {
      const auto values = onCiftiSurface(surface, map, -1);
      require(values.size() == static_cast<std::size_t>(surface.vertexCount), "values for other vertices");
    }
  }
}

inline void readConsistentPatch(const std::string& path) {
  const SurfaceFile surface = patchSurface(path, readPatch(path), sphere());
  for (const int index : surface.faces) {
    require(static_cast<std::size_t>(index) < surface.vertexCount(), "index out of range");
  }
}

inline void readConsistentMz3(const std::string& path) {
  const Mz3File file = readMz3(path);
  for (const auto& layer : file.layers) {
    require(layer.size() == static_cast<std::size_t>(file.vertexCount), "an overlay of another length");
  }
  readConsistentSurface(path);
}

/// Two quadrangles on six vertices, in either layout.
inline void writeQuads(const std::string& path, bool old) {
  std::vector<std::uint8_t> bytes{0xFF, 0xFF, static_cast<std::uint8_t>(old ? 0xFF : 0xFD), 0, 0, 6, 0, 0, 2};
  for (int i = 0; i < 18; ++i) {
    if (old) {
      encode(bytes, static_cast<std::int16_t>(100 * i), ByteOrder::Big);
    } else {
      encode(bytes, static_cast<float>(i), ByteOrder::Big);
    }
  }
  for (const int corner : {0, 1, 2, 3, 2, 3, 4, 5}) {
    bytes.insert(bytes.end(), {0, 0, static_cast<std::uint8_t>(corner)});
  }
  writeBytesOf(path, bytes);
}

/// The first layout of colour tables: two regions, three vertices.
inline void writeOldAnnot(const std::string& path) {
  std::vector<std::uint8_t> bytes;
  const auto put = [&bytes](std::int32_t number) { encode(bytes, number, ByteOrder::Big); };
  const auto name = [&](const std::string& text) {
    put(static_cast<std::int32_t>(text.size() + 1));
    bytes.insert(bytes.end(), text.begin(), text.end());
    bytes.push_back(0);
  };
  for (const int number : {3, 0, 1 + 256, 1, 2, 2, 1 + 256, 1, 2}) {
    put(number);
  }
  name("table");
  name("one");
  for (const int part : {1, 1, 0, 0}) {
    put(part);
  }
  name("two");
  for (const int part : {2, 0, 0, 0}) {
    put(part);
  }
  writeBytesOf(path, bytes);
}

/// A tetrahedron as GIFTI without compression, so that altered bytes are altered numbers.
inline void writePlainGifti(const std::string& path, bool base64) {
  const std::string encoding = base64 ? "Base64Binary" : "ASCII";
  const auto array = [&](const char* intent, const char* type, const char* data) {
    return "<DataArray Intent=\"NIFTI_INTENT_" + std::string(intent) + "\" DataType=\"NIFTI_TYPE_" + type +
           "\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"2\" Dim0=\"4\" Dim1=\"3\" Encoding=\"" + encoding +
           "\" Endian=\"LittleEndian\"><Data>" + data + "</Data></DataArray>";
  };
  const char* points = base64 ? "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"
                              : "0 0 0  1 0 0  0 1 0  0 0 1";
  const char* faces = base64 ? "AAAAAAIAAAABAAAAAAAAAAEAAAADAAAAAQAAAAIAAAADAAAAAAAAAAMAAAACAAAA"
                             : "0 2 1  0 1 3  1 2 3  0 3 2";
  std::ofstream(path) << "<?xml version=\"1.0\"?><GIFTI Version=\"1.0\" NumberOfDataArrays=\"2\">"
                      << array("POINTSET", "FLOAT32", points) << array("TRIANGLE", "INT32", faces) << "</GIFTI>";
}

/// A NIfTI-2 volume of eight voxels with a qform and an extension.
inline void writeNifti2(const std::string& path) {
  Nifti2Fields fields;
  fields.datatype = 4;
  fields.bitsPerVoxel = 16;
  fields.qformCode = 1;
  fields.extensionCode = 6;
  fields.extension = std::string(24, '\0');
  std::vector<std::uint8_t> bytes = nifti2Bytes(fields);
  bytes.resize(bytes.size() + 16, 1);
  writeBytesOf(path, bytes);
}

inline std::vector<HostileCase> olderCases() {
  const auto scalars = [](const std::string& path) { require(!readVertexScalars(path).empty(), "no values"); };
  return {
      {"lh.quads", [](const auto& path) { writeQuads(path, false); }, readConsistentSurface},
      {"lh.oldquads", [](const auto& path) { writeQuads(path, true); }, readConsistentSurface},
      {"lh.oldcurv", [](const auto& path) { writeBytesOf(path, {0, 0, 3, 0, 0, 1, 0, 100, 0, 50, 255, 0}); }, scalars},
      {"old.annot", writeOldAnnot, [](const auto& path) { require(!readAnnot(path).labels.empty(), "no labels"); }},
      {"old.patch.3d",
       [](const auto& path) { writeBytesOf(path, {0, 0, 0, 1, 255, 255, 255, 254, 0, 150, 255, 231, 0, 0}); },
       readConsistentPatch},
      {"ascii.func.gii",
       [](const auto& path) {
         std::ofstream(path) << "<?xml version=\"1.0\"?><GIFTI Version=\"1.0\" NumberOfDataArrays=\"2\"><MetaData/>"
                                "<LabelTable/><DataArray Intent=\"NIFTI_INTENT_NODE_INDEX\" "
                                "DataType=\"NIFTI_TYPE_INT32\" ArrayIndexingOrder=\"RowMajorOrder\" "
                                "Dimensionality=\"1\" Dim0=\"2\" Encoding=\"ASCII\" Endian=\"LittleEndian\"><Data>4 "
                                "1</Data></DataArray><DataArray Intent=\"NIFTI_INTENT_SHAPE\" "
                                "DataType=\"NIFTI_TYPE_FLOAT32\" ArrayIndexingOrder=\"RowMajorOrder\" "
                                "Dimensionality=\"1\" Dim0=\"2\" Encoding=\"ASCII\" Endian=\"LittleEndian\"><Data>7 "
                                "8</Data></DataArray></GIFTI>";
       },
       [](const auto& path) { require(!readVertexScalars(path, 42).empty(), "no values"); }},
      {"s.ascii.gii", [](const auto& path) { writePlainGifti(path, false); }, readConsistentSurface},
      {"s.base64.gii", [](const auto& path) { writePlainGifti(path, true); }, readConsistentSurface},
      {"v.hdr",  // a header without voxels, and the voxels in the same bytes
       [](const auto& path) {
         writeVolume(path + ".nii", ScalarVolume({2, 2, 2}, Eigen::Matrix4d::Identity(), 1));
         std::filesystem::rename(path + ".nii", path);
       },
       readConsistentVolume},
      {"v.nifti2.nii", writeNifti2, readConsistentVolume},
      {"v.mgz", [](const auto& path) { writeVolume(path, LabelVolume({3, 4, 5}, Eigen::Matrix4d::Identity(), 7)); },
       readConsistentVolume},
  };
}

inline std::vector<HostileCase> newerCases() {
  return {
      {"lh.patch.flat",
       [](const auto& path) { writePatch(path, {{4, 1, 7}, {true, false, true}, {1, 2, 0, 3, 4, 0, 5, 6, 0}}); },
       readConsistentPatch},
      {"s.mz3",
       [](const auto& path) {
         const SurfaceFile surface = sphere();
         writeMz3(path, surface, {{"a", std::vector<float>(surface.vertexCount(), 1.F)}});
       },
       readConsistentMz3},
      {"plain.mz3",
       [](const auto& path) {  // one triangle with colours and one overlay, not compressed
         std::vector<std::uint8_t> bytes{'M', 'Z', 15, 0, 1, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0};
         for (const int index : {0, 1, 2}) {
           encode(bytes, index, ByteOrder::Little);
         }
         bytes.resize(bytes.size() + 36 + 12 + 12, 63);
         std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()),
                                                     static_cast<std::streamsize>(bytes.size()));
       },
       readConsistentMz3},
      {"lh.w", [](const auto& path) { writePaint(path, {1.F, std::nanf(""), 3.F}); },
       [](const auto& path) { require(readVertexScalars(path, 42).size() == 42, "not one value per vertex"); }},
      {"m.dscalar.nii", writeSmallCifti, readConsistentCifti},
      {"full.annot",
       [](const auto& path) { writeAnnot(path, {{0, 1, -1}, {{0, "a", {1, 2, 3, 255}}, {1, "b", {4, 5, 6, 9}}}, {}}); },
       [](const auto& path) { static_cast<void>(readAnnot(path)); }},
  };
}

inline std::vector<HostileCase> cases() {
  const auto scalars = [](const std::string& path) { require(!readVertexScalars(path).empty(), "no values"); };
  return {
      {"lh.white", [](const auto& path) { writeFreeSurferSurface(path, sphere()); }, readConsistentSurface},
      {"s.off", [](const auto& path) { writeOff(path, sphere()); }, readConsistentSurface},
      {"s.obj", [](const auto& path) { writeObj(path, sphere()); }, readConsistentSurface},
      {"s.ply", [](const auto& path) { writePly(path, sphere()); }, readConsistentSurface},
      {"s.surf.gii", [](const auto& path) { writeGiftiSurface(path, sphere()); }, readConsistentSurface},
      {"lh.curv", [](const auto& path) { writeMorphometry(path, std::vector<float>(42, 1.5F)); }, scalars},
      {"t.txt", [](const auto& path) { std::ofstream(path) << "1\n2\n3.5\nnan\n-4e-3\n"; }, scalars},
      {"m.func.gii", [](const auto& path) { writeGiftiScalars(path, {{"a", std::vector<float>(42, 2.F)}}); }, scalars},
      {"l.label.gii",
       [](const auto& path) { writeGiftiLabels(path, {{0, 1, 1}, {{1, "one", {1, 2, 3, 4}}}, {}}); },
       [](const auto& path) { require(!readAnnot(path).labels.empty(), "no labels"); }},
      {"v.nii", [](const auto& path) { writeVolume(path, LabelVolume({3, 4, 5}, Eigen::Matrix4d::Identity(), 7)); },
       readConsistentVolume},
      {"v.nii.gz", [](const auto& path) { writeVolume(path, ScalarVolume({3, 4, 5}, Eigen::Matrix4d::Identity(), 7)); },
       readConsistentVolume},
      {"v.mgh",
       [](const auto& path) {
         std::string bytes(284 + 60 * 4, '\0');
         const unsigned char start[] = {0, 0, 0, 1, 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0, 5, 0, 0, 0, 1, 0, 0, 0, 3};
         std::copy(std::begin(start), std::end(start), bytes.begin());
         std::ofstream(path, std::ios::binary) << bytes;
       },
       readConsistentVolume},
      {"lh.annot",
       [](const auto& path) {
         std::string bytes(4 + 42 * 8 + 4, '\0');
         bytes[3] = 42;
         for (int i = 0; i < 42; ++i) {
           bytes[static_cast<std::size_t>(7 + 8 * i)] = static_cast<char>(i);
         }
         std::ofstream(path, std::ios::binary) << bytes;
       },
       [](const auto& path) { static_cast<void>(readAnnot(path)); }},
      {"lh.label",
       [](const auto& path) { std::ofstream(path) << "#!ascii label\n3\n1 0.5 1 2 0\n2 1 2 3 0\n7 0 0 0 1\n"; },
       [](const auto& path) {
         for (const int vertex : readLabel(path).vertices) {
           require(vertex >= 0, "negative vertex");
         }
       }},
  };
}

/// Whether these are the bytes of a gzip file: what is inside is then altered too, and packed again.
inline bool isPacked(const std::string& bytes) { return bytes.rfind("\x1F\x8B", 0) == 0; }

inline const std::vector<HostileCase>& allHostileCases() {
  static const std::vector<HostileCase> all = [] {
    std::vector<HostileCase> joined = cases();
    for (auto& others : {newerCases(), olderCases()}) {
      joined.insert(joined.end(), others.begin(), others.end());
    }
    return joined;
  }();
  return all;
}

}  // namespace authalic::testing
