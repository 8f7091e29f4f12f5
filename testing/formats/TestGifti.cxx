#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "Core/base/Error.h"
#include "Formats/AtomicFile.h"
#include "Formats/Gifti.h"
#include "support/SharedData.h"
#include "support/TemporaryFolder.h"

namespace {

using namespace authalic;
using authalic::testing::TemporaryFolder;

/// A document of one array.
std::string document(const std::string& attributes, const std::string& data, const std::string& before = "") {
  return "<?xml version=\"1.0\"?>" + before +
         "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"1\"><DataArray Intent=\"NIFTI_INTENT_NONE\" " + attributes +
         "><Data>" + data + "</Data></DataArray></GIFTI>";
}

std::string attributes(const std::string& type, const std::string& dims, const std::string& encoding,
                       const std::string& more = "Endian=\"LittleEndian\" ArrayIndexingOrder=\"RowMajorOrder\"") {
  return "DataType=\"NIFTI_TYPE_" + type + "\" " + dims + " Encoding=\"" + encoding + "\" " + more;
}

GiftiFile readText(const std::string& text) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.gii") << text;
  return readGifti(folder / "a.gii");
}

std::string messageOf(const std::string& text) {
  try {
    static_cast<void>(readText(text));
  } catch (const FormatError& error) {
    return error.what();
  }
  return "";
}

constexpr const char* kTwo = "Dimensionality=\"1\" Dim0=\"2\"";

}  // namespace

TEST(Gifti, ReadsEveryNumberTypeInBothByteOrders) {
  const struct {
    const char *type, *little, *big;
  } cases[] = {{"UINT8", "AQI=", "AQI="},
               {"INT8", "AQI=", "AQI="},
               {"INT16", "AQACAA==", "AAEAAg=="},
               {"UINT16", "AQACAA==", "AAEAAg=="},
               {"INT32", "AQAAAAIAAAA=", "AAAAAQAAAAI="},
               {"UINT32", "AQAAAAIAAAA=", "AAAAAQAAAAI="},
               {"INT64", "AQAAAAAAAAACAAAAAAAAAA==", "AAAAAAAAAAEAAAAAAAAAAg=="},
               {"UINT64", "AQAAAAAAAAACAAAAAAAAAA==", "AAAAAAAAAAEAAAAAAAAAAg=="},
               {"FLOAT32", "AACAPwAAAEA=", "P4AAAEAAAAA="},
               {"FLOAT64", "AAAAAAAA8D8AAAAAAAAAQA==", "P/AAAAAAAABAAAAAAAAAAA=="}};
  for (const auto& c : cases) {
    const auto little = readText(document(attributes(c.type, kTwo, "Base64Binary"), c.little));
    const auto big = readText(document(attributes(c.type, kTwo, "Base64Binary", "Endian=\"BigEndian\""), c.big));
    EXPECT_EQ(little.arrays[0].values, (std::vector<double>{1, 2})) << c.type;
    EXPECT_EQ(big.arrays[0].values, (std::vector<double>{1, 2})) << c.type;
  }
}

TEST(Gifti, TurnsColumnMajorIntoRowMajor) {
  const std::string dims = "Dimensionality=\"2\" Dim0=\"2\" Dim1=\"3\"";
  const auto file = readText(document(
      attributes("INT32", dims, "ASCII", "Endian=\"LittleEndian\" ArrayIndexingOrder=\"ColumnMajorOrder\""),
      "1 4 2 5 3 6"));
  EXPECT_EQ(file.arrays[0].values, (std::vector<double>{1, 2, 3, 4, 5, 6}));
}

TEST(Gifti, RefusesDimensionsThatTheDataDoNotFill) {
  const std::string huge = "Dimensionality=\"1\" Dim0=\"400000000\"";
  EXPECT_NE(messageOf(document(attributes("FLOAT32", huge, "Base64Binary"), "AACAPw==")).find("1600000000 bytes"),
            std::string::npos);
  EXPECT_NE(messageOf(document(attributes("FLOAT32", huge, "GZipBase64Binary"), "eJxjYGiwBwABAgCB")), "");
  EXPECT_NE(messageOf(document(attributes("FLOAT32", huge, "ASCII"), "1 2 3")), "");
  EXPECT_NE(messageOf(document(attributes("INT32", kTwo, "ASCII"), "1 2 3")), "");
  const std::string overflow = "Dimensionality=\"2\" Dim0=\"4611686018427387904\" Dim1=\"8\"";
  EXPECT_NE(messageOf(document(attributes("INT32", overflow, "ASCII"), "1")), "");
  EXPECT_NE(messageOf(document(attributes("INT32", "Dimensionality=\"1\" Dim0=\"-5\"", "ASCII"), "1")), "");
}

TEST(Gifti, RefusesMalformedDocumentsInWords) {
  EXPECT_NE(messageOf("<GIFTI><DataArray").find("not well formed"), std::string::npos);
  EXPECT_NE(messageOf(document(attributes("INT32", kTwo, "ASCII"), "1 x")).find("not a number"), std::string::npos);
  EXPECT_NE(messageOf(document(attributes("INT32", kTwo, "Base64Binary"), "A*==")).find("base64"), std::string::npos);
  EXPECT_NE(messageOf(document(attributes("INT32", kTwo, "Morse"), "1 2")).find("Morse"), std::string::npos);
  EXPECT_NE(messageOf(document(attributes("COMPLEX64", kTwo, "ASCII"), "1 2")).find("type code 32"), std::string::npos);
  EXPECT_NE(messageOf(document("DataType=\"NIFTI_TYPE_INT32\"", "1")).find("lacks"), std::string::npos);
  EXPECT_NE(messageOf(document(attributes("INT32", kTwo, "ASCII"), "&a; 2",
                               "<!DOCTYPE GIFTI [<!ENTITY a \"1\">]>")).find("entities"), std::string::npos);
}

TEST(Gifti, ReadsExternalFilesBesideTheDocumentAndRefusesShortOnes) {
  const TemporaryFolder folder;
  std::ofstream(folder / "x.dat", std::ios::binary) << std::string("\xAA\x01\0\0\0\x02\0\0\0", 9);
  const auto text = [](const char* offset) {
    return document(attributes("INT32", kTwo, "ExternalFileBinary") +
                        " ExternalFileName=\"x.dat\" ExternalFileOffset=\"" + offset + "\"",
                    "");
  };
  std::ofstream(folder / "a.gii") << text("1");
  std::ofstream(folder / "b.gii") << text("2");
  EXPECT_EQ(readGifti(folder / "a.gii").arrays[0].values, (std::vector<double>{1, 2}));
  EXPECT_THROW(static_cast<void>(readGifti(folder / "b.gii")), FormatError);
}

TEST(Gifti, DecidesTheSpaceByDataSpaceThenVolGeom) {
  const TemporaryFolder folder;
  SurfaceFile surface;
  surface.points = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  surface.faces = {0, 1, 2};
  surface.space = CoordinateSpace::ScannerRAS;
  surface.geometry.valid = true;
  surface.geometry.center = {5, 6, 7};
  surface.metadata["GeometricType"] = "Sphere";
  surface.metadata["AnatomicalStructurePrimary"] = "CortexLeft";
  writeGiftiSurface(folder / "a.surf.gii", surface);
  const SurfaceFile scanner = readSurface(folder / "a.surf.gii");
  EXPECT_EQ(scanner.space, CoordinateSpace::ScannerRAS);
  EXPECT_EQ(scanner.geometry.center, surface.geometry.center);
  EXPECT_EQ(scanner.metadata.at("GeometricType"), "Spherical");

  GiftiFile file = readGifti(folder / "a.surf.gii");
  file.arrays[0].transforms[0].dataSpace = "NIFTI_XFORM_UNKNOWN";
  writeGifti(folder / "b.surf.gii", file);
  EXPECT_EQ(readSurface(folder / "b.surf.gii").space, CoordinateSpace::TkRAS);
  for (const char* key : {"VolGeomC_R", "VolGeomC_A", "VolGeomC_S"}) {
    file.arrays[0].metadata[key] = "0";
  }
  writeGifti(folder / "c.surf.gii", file);
  EXPECT_EQ(readSurface(folder / "c.surf.gii").space, CoordinateSpace::ScannerRAS) << "both spaces are the same";
  file.arrays[0].metadata["VolGeomX_R"] = "1";
  writeGifti(folder / "d.surf.gii", file);
  EXPECT_EQ(readSurface(folder / "d.surf.gii").space, CoordinateSpace::Unknown);
  file.arrays[0].metadata.erase("VolGeomX_R");
  writeGifti(folder / "e.surf.gii", file);
  EXPECT_EQ(readSurface(folder / "e.surf.gii").space, CoordinateSpace::Unknown);
}

TEST(Gifti, WritesNamesThatLookLikeMarkup) {
  const TemporaryFolder folder;
  writeGiftiScalars(folder / "a.shape.gii", {{"a]]>b <&> \"c\"", {1.F, std::nanf("")}}}, "CortexLeft");
  const GiftiFile file = readGifti(folder / "a.shape.gii");
  EXPECT_EQ(file.arrays[0].metadata.at("Name"), "a]]>b <&> \"c\"");
  EXPECT_EQ(file.metadata.at("AnatomicalStructurePrimary"), "CortexLeft");
  EXPECT_TRUE(std::isnan(file.arrays[0].values[1]));
}

TEST(Gifti, WritesTheSameBytesTwice) {
  const TemporaryFolder folder;
  for (const char* name : {"a.shape.gii", "b.shape.gii"}) {
    writeGiftiScalars(folder / name, {{"x", {1.F, 2.F, 3.F}}});
  }
  std::ifstream a(folder / "a.shape.gii"), b(folder / "b.shape.gii");
  EXPECT_EQ(std::string((std::istreambuf_iterator<char>(a)), {}), std::string((std::istreambuf_iterator<char>(b)), {}));
}

TEST(Gifti, RefusesToWriteWhatWorkbenchCannotRead) {
  const TemporaryFolder folder;
  GiftiFile file;
  file.arrays.resize(1);
  file.arrays[0].type = GiftiType::Float64;
  file.arrays[0].dimensions = {1};
  file.arrays[0].values = {1};
  EXPECT_THROW(writeGifti(folder / "a.gii", file), FormatError);
  EXPECT_THROW(writeGiftiScalars(folder / "a.gii", {{"a", {1.F}}, {"b", {1.F, 2.F}}}), FormatError);
  EXPECT_TRUE(folder.isEmpty());
}

TEST(Gifti, LabelsKeepIdsNamesAndColours) {
  const TemporaryFolder folder;
  Annotation annotation;
  annotation.labels = {-1, 5, 1000000};
  annotation.regions = {{5, "five", {1, 2, 3, 255}}, {1000000, "million", {255, 128, 0, 77}}};
  writeGiftiLabels(folder / "a.label.gii", annotation);
  const Annotation back = readAnnot(folder / "a.label.gii");
  EXPECT_EQ(back.labels, (std::vector<std::int32_t>{0, 5, 1000000}));
  ASSERT_EQ(back.regions.size(), 3U);
  EXPECT_EQ(back.regions[0].name, "???");
  EXPECT_EQ(back.regions[2].name, "million");
  EXPECT_EQ(back.regions[2].rgba, annotation.regions[1].rgba);
}

TEST(Gifti, ReadsTheOldLabelTableAndRefusesSparseData) {
  const TemporaryFolder folder;
  const std::string array = "<DataArray Intent=\"NIFTI_INTENT_LABEL\" " + attributes("INT32", kTwo, "ASCII") +
                            "><Data>0 4</Data></DataArray>";
  std::ofstream(folder / "a.label.gii") << "<GIFTI><LabelTable><Label Index=\"4\">four</Label></LabelTable>" << array
                                        << "</GIFTI>";
  const Annotation annotation = readAnnot(folder / "a.label.gii");
  EXPECT_EQ(annotation.regions[0].id, 4);
  EXPECT_EQ(annotation.regions[0].name, "four");
  EXPECT_EQ(annotation.labels, (std::vector<std::int32_t>{0, 4}));
  std::ofstream(folder / "b.func.gii") << "<GIFTI><DataArray Intent=\"NIFTI_INTENT_NODE_INDEX\" " +
                                              attributes("INT32", kTwo, "ASCII") +
                                              "><Data>0 4</Data></DataArray></GIFTI>";
  EXPECT_THROW(static_cast<void>(readVertexScalars(folder / "b.func.gii")), FormatError);
}

TEST(AtomicFile, LeavesTheOldFileAloneUntilCommitted) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.txt";
  writeFileAtomically(path, std::string_view("old"));
  {
    AtomicFile file(path);
    file.write("new, but never finished");
  }
  std::ifstream input(path);
  EXPECT_EQ(std::string((std::istreambuf_iterator<char>(input)), {}), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(std::filesystem::path(path).parent_path()), {}), 1);
  writeFileAtomically(path, std::string_view("new"));
  EXPECT_EQ(std::filesystem::file_size(path), 3U);
}

TEST(AtomicFile, FollowsALinkAndRefusesFoldersDevicesAndMissingFolders) {
  const TemporaryFolder folder;
  writeFileAtomically(folder / "real", std::string_view("old"));
  std::filesystem::create_symlink(folder / "real", folder / "link");
  writeFileAtomically(folder / "link", std::string_view("newer"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(std::filesystem::file_size(folder / "real"), 5U);
  EXPECT_THROW(AtomicFile(folder / ""), FormatError);
  EXPECT_THROW(AtomicFile("/dev/null"), FormatError);
  EXPECT_THROW(AtomicFile(folder / "no/file"), FormatError);
  EXPECT_THROW(AtomicFile(""), FormatError);
}
