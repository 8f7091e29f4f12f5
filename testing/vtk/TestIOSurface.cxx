#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSmartPointer.h>
#include <vtkSurfaceFileReader.h>
#include <vtkSurfaceFileWriter.h>
#include <vtkVertexDataReader.h>
#include <vtkVertexDataWriter.h>
#include <vtkVolumeFileReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <random>

#include "Conversion.h"
#include "FieldArrays.h"
#include "Formats/VolumeFile.h"
#include "SurfaceConversion.h"
#include "support/SharedData.h"
#include "support/TemporaryFolder.h"
#include "support/TestMeshes.h"
#include "support/VtkWords.h"

namespace {

using authalic::testing::sharedData;
using authalic::testing::TemporaryFolder;
using authalic::testing::VtkWords;

struct Outcome {
  int kind = -1;
  unsigned long code = 0;
  std::string words;
  vtkSmartPointer<vtkPolyData> surface;
};

Outcome read(const std::string& path, int assume = vtkSurfaceFileReader::AS_STATED) {
  vtkNew<vtkSurfaceFileReader> reader;
  const VtkWords words(reader);
  reader->SetFileName(path.c_str());
  reader->SetAssumeSpace(assume);
  reader->Update();
  return {reader->GetErrorKind(), reader->GetErrorCode(), words.text(), reader->GetOutput()};
}

int write(vtkPolyData* surface, const std::string& path) {
  vtkNew<vtkSurfaceFileWriter> writer;
  const VtkWords words(writer);
  writer->SetInputData(surface);
  writer->SetFileName(path.c_str());
  const int done = writer->Write();
  EXPECT_EQ(done == 1, writer->GetErrorKind() == 0);
  return writer->GetErrorKind();
}

vtkSmartPointer<vtkPolyData> sphere() {
  const auto mesh = authalic::testing::sphereMesh(2);
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  authalic::Points3 points = 10 * mesh.points();
  points.rowwise() += Eigen::RowVector3d(3, -5, 20);
  authalic::setMesh(surface, authalic::TriangleMesh(points, mesh.faces()));
  return surface;
}

double largestDifference(vtkPolyData* a, vtkPolyData* b) {
  double worst = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i) {
    for (int k = 0; k < 3; ++k) {
      worst = std::max(worst, std::abs(a->GetPoint(i)[k] - b->GetPoint(i)[k]));
    }
  }
  return worst;
}

void expectSameFaces(vtkPolyData* a, vtkPolyData* b) {
  const auto first = authalic::toSurfaceFile(a);
  const auto second = authalic::toSurfaceFile(b);
  EXPECT_EQ(first.faces, second.faces);
}

std::string spaceOf(vtkPolyData* surface) { return authalic::textField(surface, "CoordinateSpace"); }

class SurfaceFormats : public ::testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(SurfaceFormats, GiveBackPointsAndFacesInTheirOrder) {
  const TemporaryFolder folder;
  const std::string path = folder / GetParam();
  const auto original = sphere();
  ASSERT_EQ(write(original, path), 0);
  const Outcome outcome = read(path);
  ASSERT_EQ(outcome.kind, 0) << outcome.words;
  ASSERT_EQ(outcome.surface->GetNumberOfPoints(), original->GetNumberOfPoints());
  EXPECT_LT(largestDifference(outcome.surface, original), 2e-6);
  EXPECT_EQ(outcome.surface->GetPoints()->GetDataType(), VTK_DOUBLE);
  expectSameFaces(outcome.surface, original);
  EXPECT_EQ(spaceOf(outcome.surface), "unknown");
  EXPECT_FALSE(authalic::textField(outcome.surface, "CoordinateSpaceReason").empty());
}

INSTANTIATE_TEST_SUITE_P(AllButStl, SurfaceFormats,
                         ::testing::Values("s.surf.gii", "s.vtp", "s.vtk", "s.ply", "s.off", "s.obj", "lh.white",
                                           "rh.x"));

TEST(SurfaceFileReader, MergesTheCornersOfStl) {
  const TemporaryFolder folder;
  const auto original = sphere();
  ASSERT_EQ(write(original, folder / "s.stl"), 0);
  const Outcome outcome = read(folder / "s.stl");
  ASSERT_EQ(outcome.kind, 0) << outcome.words;
  EXPECT_EQ(outcome.surface->GetNumberOfPoints(), original->GetNumberOfPoints());
  EXPECT_EQ(outcome.surface->GetNumberOfPolys(), original->GetNumberOfPolys());
}

TEST(SurfaceFileReader, MakesTrianglesOfPolygonsAndDropsTheRest) {
  const TemporaryFolder folder;
  std::ofstream(folder / "mixed.vtk") << "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 6 float\n"
                                         "0 0 0 1 0 0 1 1 0 0 1 0 2 0 0 2 1 0\nVERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\n"
                                         "POLYGONS 1 5\n4 0 1 2 3\nTRIANGLE_STRIPS 1 5\n4 1 4 2 5\n";
  const Outcome outcome = read(folder / "mixed.vtk");
  ASSERT_EQ(outcome.kind, 0) << outcome.words;
  EXPECT_EQ(outcome.surface->GetNumberOfCells(), 4);
  EXPECT_EQ(outcome.surface->GetNumberOfPolys(), 4);
  EXPECT_EQ(authalic::toSurfaceFile(outcome.surface).faceCount(), 4U);
}

TEST(SurfaceFileReader, KeepsArraysAndSpaceOfVtp) {
  const TemporaryFolder folder;
  const auto original = sphere();
  vtkNew<vtkFloatArray> thickness;
  thickness->SetName("thickness");
  for (vtkIdType i = 0; i < original->GetNumberOfPoints(); ++i) {
    thickness->InsertNextValue(i == 3 ? std::nanf("") : static_cast<float>(i) / 7);
  }
  original->GetPointData()->AddArray(thickness);
  authalic::SurfaceFile stated;
  stated.space = authalic::CoordinateSpace::ScannerRAS;
  stated.spaceReason = "by construction";
  stated.metadata["AnatomicalStructurePrimary"] = "CortexRight";
  stated.geometry.valid = true;
  stated.geometry.center = {1, 2, 3};
  authalic::setSpaceFields(original, stated);
  for (const char* name : {"s.vtp", "s.vtk"}) {
    ASSERT_EQ(write(original, folder / name), 0);
    const Outcome outcome = read(folder / name);
    ASSERT_EQ(outcome.kind, 0) << outcome.words;
    vtkDataArray* back = outcome.surface->GetPointData()->GetArray("thickness");
    ASSERT_NE(back, nullptr) << name;
    EXPECT_EQ(back->GetTuple1(5), thickness->GetTuple1(5));
    EXPECT_TRUE(std::isnan(back->GetTuple1(3)));
    const auto space = authalic::spaceFields(outcome.surface);
    EXPECT_EQ(space.space, authalic::CoordinateSpace::ScannerRAS);
    EXPECT_EQ(space.metadata.at("AnatomicalStructurePrimary"), "CortexRight");
    EXPECT_EQ(space.geometry.center[2], 3);
  }
}

TEST(SurfaceFileReader, BringsTkRasToScannerRasAndBack) {
  const std::string path = sharedData("cortex/subject1_fs/lh.pialsurface4");
  AUTHALIC_NEEDS(path);
  const TemporaryFolder folder;
  const Outcome native = read(path);
  ASSERT_EQ(native.kind, 0) << native.words;
  EXPECT_EQ(spaceOf(native.surface), "scanner-ras");
  EXPECT_NE(native.surface->GetFieldData()->GetArray("VolumeGeometry"), nullptr);
  for (const char* name : {"lh.copy", "lh.surf.gii", "lh.vtp"}) {
    ASSERT_EQ(write(native.surface, folder / name), 0);
    const Outcome copy = read(folder / name);
    ASSERT_EQ(copy.kind, 0) << copy.words;
    EXPECT_EQ(spaceOf(copy.surface), "scanner-ras") << name;
    EXPECT_LT(largestDifference(native.surface, copy.surface), 2e-5) << name;
  }
  const auto raw = authalic::readSurface(path);
  const auto copy = authalic::readSurface(folder / "lh.copy");
  for (std::size_t i = 0; i < raw.points.size(); ++i) {
    ASSERT_NEAR(raw.points[i], copy.points[i], 2e-5);
  }
}

TEST(SurfaceFileReader, BelievesSlicerThatTurnsTheCoordinatesAndLeavesOurFields) {
  const TemporaryFolder folder;
  const auto ras = sphere();
  authalic::addField(ras, "CoordinateSpace", std::string("scanner-ras"));
  ASSERT_EQ(write(ras, folder / "ras.vtp"), 0);
  vtkNew<vtkXMLPolyDataReader> plain;
  plain->SetFileName((folder / "ras.vtp").c_str());
  plain->Update();
  EXPECT_EQ(authalic::textField(plain->GetOutput(), "SPACE"), "RAS");  // else Slicer would take it for LPS
  authalic::Points3 points = authalic::toPoints(ras);
  points.leftCols(2) *= -1;
  authalic::setPoints(plain->GetOutput(), points);
  for (const bool ours : {true, false}) {  // a file of ours that Slicer saved again; one that Slicer made
    if (!ours) plain->GetOutput()->GetFieldData()->RemoveArray("CoordinateSpace");
    authalic::addField(plain->GetOutput(), "SPACE", std::string("LPS"));
    vtkNew<vtkXMLPolyDataWriter> xml;
    xml->SetInputData(plain->GetOutput());
    xml->SetFileName((folder / "lps.vtp").c_str());
    xml->Write();
    plain->GetOutput()->GetFieldData()->RemoveArray("SPACE");
    vtkNew<vtkPolyDataWriter> legacy;
    legacy->SetInputData(plain->GetOutput());
    legacy->SetFileName((folder / "lps.vtk").c_str());
    legacy->SetHeader("3D Slicer output. SPACE=LPS");
    legacy->Write();
    for (const char* name : {"lps.vtp", "lps.vtk"}) {
      const Outcome outcome = read(folder / name);
      ASSERT_EQ(outcome.kind, 0) << outcome.words;
      EXPECT_EQ(spaceOf(outcome.surface), "scanner-ras") << name;
      EXPECT_LT(largestDifference(outcome.surface, ras), 1e-5) << name;
      EXPECT_FALSE(outcome.surface->GetFieldData()->HasArray("SPACE"));
      const std::string reason = authalic::textField(outcome.surface, "CoordinateSpaceReason");
      EXPECT_EQ(reason.find("SPACE=LPS in the file"), 0U) << reason;
      EXPECT_EQ(reason.find("CoordinateSpace") != std::string::npos, ours) << reason;
    }
  }
}

TEST(SurfaceFileReader, SaysThatAFieldDecidedWhenItGivesNoReason) {
  const TemporaryFolder folder;
  const auto surface = sphere();
  authalic::addField(surface, "CoordinateSpace", std::string("scanner-ras"));
  for (const char* name : {"s.vtp", "s.vtk"}) {
    ASSERT_EQ(write(surface, folder / name), 0);
    EXPECT_EQ(authalic::textField(read(folder / name).surface, "CoordinateSpaceReason"),
              "field CoordinateSpace of the file");
  }
}

TEST(SurfaceFileReader, TakesTheAssertedSpace) {
  const TemporaryFolder folder;
  const auto original = sphere();
  ASSERT_EQ(write(original, folder / "s.off"), 0);
  const Outcome asserted = read(folder / "s.off", vtkSurfaceFileReader::SCANNER_RAS);
  EXPECT_EQ(asserted.kind, 0);
  EXPECT_EQ(spaceOf(asserted.surface), "scanner-ras");
  EXPECT_LT(largestDifference(asserted.surface, original), 1e-12);
  for (const char* name : {"s.off", "s.vtp"}) {
    ASSERT_EQ(write(original, folder / name), 0);
    const Outcome refused = read(folder / name, vtkSurfaceFileReader::TK_RAS);
    EXPECT_EQ(refused.kind, vtkSurfaceAlgorithm::FORMAT);
    EXPECT_NE(refused.words.find("geometry"), std::string::npos);
    EXPECT_EQ(refused.surface->GetNumberOfPoints(), 0);
  }
}

TEST(SurfaceFileReader, RefusesWhatIsNoSurfaceInOneSentence) {
  const TemporaryFolder folder;
  std::ofstream(folder / "empty.vtp");
  for (const char* name : {"a.vtp", "a.vtk", "a.ply", "a.stl", "a.off", "a.obj", "a.gii", "lh.white"}) {
    std::ofstream(folder / name) << "this is not a surface\n";
  }
  for (const char* name :
       {"a.vtp", "a.vtk", "a.ply", "a.stl", "a.off", "a.obj", "a.gii", "lh.white", "empty.vtp", "."}) {
    const Outcome outcome = read(folder / name);
    EXPECT_EQ(outcome.kind, vtkSurfaceAlgorithm::FORMAT) << name;
    EXPECT_EQ(outcome.code, static_cast<unsigned long>(vtkErrorCode::FileFormatError)) << name;
    EXPECT_NE(outcome.words.find(folder / name), std::string::npos) << outcome.words;
    EXPECT_EQ(outcome.surface->GetNumberOfPoints(), 0) << name;
  }
  EXPECT_EQ(read(folder / "missing.vtp").code, static_cast<unsigned long>(vtkErrorCode::FileNotFoundError));
  EXPECT_EQ(read("").kind, vtkSurfaceAlgorithm::ARGUMENT);
}

TEST(SurfaceFileReader, RefusesCountsThatTheFileCannotHold) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.ply")
      << "ply\nformat ascii 1.0\nelement vertex 900000000\nproperty float x\nend_header\n0\n";
  std::ofstream(folder / "a.vtk")
      << "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 900000000 float\n0\n";
  std::ofstream(folder / "b.vtk") << "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
                                     "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 77\n";
  std::ofstream(folder / "a.stl") << std::string(80, ' ') << "\xFF\xFF\xFF\x7F";
  for (const char* name : {"a.ply", "a.vtk", "b.vtk", "a.stl"}) {
    EXPECT_EQ(read(folder / name).kind, vtkSurfaceAlgorithm::FORMAT) << name;
  }
}

TEST(SurfaceFileReader, SurvivesTruncatedAndAlteredFilesOfVtksFormats) {
  const TemporaryFolder folder;
  std::mt19937 random(11);
  for (const char* name : {"s.vtp", "s.vtk", "s.stl", "s.ply"}) {
    ASSERT_EQ(write(sphere(), folder / name), 0);
    std::ifstream input(folder / name, std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(input)), {});
    const std::string path = folder / (std::string("broken") + (std::strrchr(name, '.')));
    for (int i = 0; i < 37 + 60; ++i) {
      std::string bytes = whole;
      if (i < 37) {
        bytes.resize(whole.size() * static_cast<std::size_t>(i) / 37);
      } else {
        bytes[random() % bytes.size()] = static_cast<char>(random());
      }
      std::ofstream(path, std::ios::binary) << bytes;
      const Outcome outcome = read(path);
      EXPECT_TRUE(outcome.kind != 0 || outcome.surface->GetNumberOfPoints() > 0) << name << " " << i;
    }
  }
}

TEST(SurfaceFileReader, ReadsTheLegacyFilesOfOthers) {
  for (const char* name :
       {"colon/EdinGCA_3D_00020_CTC_inflated/large-intestine-SF-SF+.vtk",
        "colon/HuBMAPVHM_3D_00070/large-intestine-Sigmoid.vtk", "meshes/multi_boundary/fran_cut.vtk"}) {
    AUTHALIC_NEEDS(sharedData(name));
    const Outcome outcome = read(sharedData(name));
    EXPECT_EQ(outcome.kind, 0) << outcome.words;
    EXPECT_GT(outcome.surface->GetNumberOfPolys(), 500) << name;
  }
}

TEST(SurfaceFileWriter, LeavesNothingBehindWhenItFails) {
  const TemporaryFolder folder;
  EXPECT_EQ(write(sphere(), folder / "missing/s.vtp"), vtkSurfaceAlgorithm::FORMAT);
  EXPECT_EQ(write(vtkNew<vtkPolyData>(), folder / "s.surf.gii"), vtkSurfaceAlgorithm::SURFACE);
  EXPECT_EQ(write(sphere(), folder / "."), vtkSurfaceAlgorithm::FORMAT);
  EXPECT_TRUE(folder.isEmpty());
}

TEST(SurfaceFileWriter, RefusesNamesOfPerVertexData) {
  const TemporaryFolder folder;
  for (const char* name : {"s.func.gii", "s.shape.gii", "s.label.gii", "s.annot", "s.txt"}) {
    EXPECT_EQ(write(sphere(), folder / name), vtkSurfaceAlgorithm::ARGUMENT) << name;
  }
  EXPECT_TRUE(folder.isEmpty());
}

TEST(VolumeFileReader, PutsVoxelsWhereTheAffineSays) {
  const TemporaryFolder folder;
  Eigen::Matrix4d affine;
  affine << -0.8, 0.6, 0, 10, 1.2, 1.6, 0, -20, 0, 0, 1.5, 30, 0, 0, 0, 1;
  authalic::LabelVolume labels({4, 5, 6}, affine);
  labels.at(1, 2, 3) = 70000001;
  authalic::writeVolume(folder / "v.nii.gz", labels);
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName((folder / "v.nii.gz").c_str());
  reader->Update();
  ASSERT_EQ(reader->GetErrorKind(), 0);
  vtkImageData* image = reader->GetOutput();
  EXPECT_EQ(image->GetScalarType(), VTK_INT);
  EXPECT_EQ(image->GetScalarComponentAsDouble(1, 2, 3, 0), 70000001);
  double place[3];
  const int ijk[3] = {1, 2, 3};
  image->TransformIndexToPhysicalPoint(ijk, place);
  const Eigen::Vector3d expected = labels.world(1, 2, 3);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(place[k], expected[k], 1e-5);
  }
  EXPECT_EQ(authalic::textField(image, "CoordinateSpace"), "scanner-ras");
}

TEST(VolumeFileReader, ReadsTheFrameAskedFor) {
  const std::string path = sharedData("volumes/edge/functional.nii");
  AUTHALIC_NEEDS(path);
  vtkNew<vtkVolumeFileReader> reader;
  const VtkWords words(reader);
  reader->SetFileName(path.c_str());
  reader->SetFrame(19);
  reader->Update();
  const auto expected = authalic::readVolume(path, 19).scalars();
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsFloat(5, 6, 1, 0), expected.at(5, 6, 1));
  reader->SetFrame(20);
  reader->Update();
  EXPECT_EQ(reader->GetErrorKind(), vtkSurfaceAlgorithm::FORMAT);
  EXPECT_TRUE(words.contain("20 frames")) << words.text();
}

TEST(VolumeFileReader, RefusesMissingAndColourFiles) {
  vtkNew<vtkVolumeFileReader> reader;
  const VtkWords words(reader);
  reader->SetFileName("/nowhere/t1.nii.gz");
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileNotFoundError));
  const std::string rgb = sharedData("volumes/edge/example_rgb.nii.gz");
  AUTHALIC_NEEDS(rgb);
  reader->SetFileName(rgb.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorKind(), vtkSurfaceAlgorithm::FORMAT);
  EXPECT_TRUE(words.contain("RGB")) << words.text();
}

namespace {

Outcome addData(vtkPolyData* surface, const std::string& path, const char* name = nullptr) {
  vtkNew<vtkVertexDataReader> reader;
  const VtkWords words(reader);
  reader->SetInputData(surface);
  reader->SetFileName(path.c_str());
  reader->SetArrayName(name);
  reader->Update();
  return {reader->GetErrorKind(), reader->GetErrorCode(), words.text(), reader->GetOutput()};
}

int writeData(vtkPolyData* surface, const std::string& path, std::initializer_list<const char*> names = {}) {
  vtkNew<vtkVertexDataWriter> writer;
  const VtkWords words(writer);
  writer->SetInputData(surface);
  writer->SetFileName(path.c_str());
  for (const char* name : names) {
    writer->AddArrayName(name);
  }
  writer->Write();
  return writer->GetErrorKind();
}

}  // namespace

TEST(VertexData, ComesBackAsItWasWritten) {
  const TemporaryFolder folder;
  const auto surface = sphere();
  for (const char* name : {"thickness", "curv"}) {
    vtkNew<vtkFloatArray> values;
    values->SetName(name);
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
      values->InsertNextValue(i == 7 ? std::nanf("") : 0.1F * static_cast<float>(i) - static_cast<float>(name[0]));
    }
    surface->GetPointData()->AddArray(values);
  }
  EXPECT_EQ(writeData(surface, folder / "two.func.gii"), 0);
  EXPECT_EQ(writeData(surface, folder / "lh.curv", {"curv"}), 0);
  EXPECT_EQ(writeData(surface, folder / "curv.txt", {"curv"}), 0);
  EXPECT_EQ(writeData(surface, folder / "lh.sulc"), vtkSurfaceAlgorithm::ARGUMENT);
  EXPECT_EQ(writeData(surface, folder / "lh.sulc", {"absent"}), vtkSurfaceAlgorithm::ARGUMENT);
  for (const char* name : {"two.func.gii", "lh.curv", "curv.txt"}) {
    const Outcome outcome = addData(sphere(), folder / name);
    ASSERT_EQ(outcome.kind, 0) << outcome.words;
    vtkDataArray* back = outcome.surface->GetPointData()->GetArray("curv");
    ASSERT_NE(back, nullptr) << name;
    EXPECT_EQ(back->GetTuple1(11), surface->GetPointData()->GetArray("curv")->GetTuple1(11));
    EXPECT_TRUE(std::isnan(back->GetTuple1(7)));
  }
  EXPECT_EQ(addData(sphere(), folder / "lh.curv", "mine").surface->GetPointData()->HasArray("mine"), 1);
}

TEST(VertexData, CarriesRegionsWithNamesAndColours) {
  const std::string path = sharedData("cortex/fsaverage5_gifti/test.annot");
  const std::string white = sharedData("cortex/fsaverage5_gifti/white_left.gii.gz");
  AUTHALIC_NEEDS(path);
  AUTHALIC_NEEDS(white);
  const TemporaryFolder folder;
  const Outcome surface = read(white);
  ASSERT_EQ(surface.kind, 0) << surface.words;
  const Outcome outcome = addData(surface.surface, path, "regions");
  ASSERT_EQ(outcome.kind, 0) << outcome.words;
  const auto regions = authalic::toRegions(outcome.surface, "regions");
  const auto expected = authalic::readAnnot(path);
  ASSERT_EQ(regions.size(), expected.regions.size());
  EXPECT_EQ(regions[1].name, expected.regions[1].name);
  EXPECT_EQ(regions[1].rgba, expected.regions[1].rgba);
  ASSERT_EQ(writeData(outcome.surface, folder / "r.label.gii", {"regions"}), 0);
  const auto back = authalic::readAnnot(folder / "r.label.gii");
  for (std::size_t i = 0; i < back.labels.size(); ++i) {
    ASSERT_EQ(back.labels[i], std::max(0, expected.labels[i]));
  }
}

TEST(VertexData, OfAnotherSurfaceIsRefusedWithBothCounts) {
  const TemporaryFolder folder;
  authalic::writeMorphometry(folder / "lh.thickness", std::vector<float>(642, 1.F));
  const Outcome outcome = addData(sphere(), folder / "lh.thickness");
  EXPECT_EQ(outcome.kind, vtkSurfaceAlgorithm::SURFACE);
  EXPECT_NE(outcome.words.find("642"), std::string::npos);
  EXPECT_NE(outcome.words.find(std::to_string(sphere()->GetNumberOfPoints())), std::string::npos);
  EXPECT_EQ(outcome.surface->GetNumberOfPoints(), 0);
}

TEST(VertexData, OfALabelMarksItsVertices) {
  const std::string path = sharedData("cortex/fsaverage3_fs/lh.cortex.label");
  AUTHALIC_NEEDS(path);
  const Outcome surface = read(sharedData("cortex/fsaverage3_fs/lh.white"));
  const Outcome outcome = addData(surface.surface, path);
  ASSERT_EQ(outcome.kind, 0) << outcome.words;
  vtkDataArray* inside = outcome.surface->GetPointData()->GetArray("cortex");
  ASSERT_NE(inside, nullptr);
  int count = 0;
  for (vtkIdType i = 0; i < inside->GetNumberOfTuples(); ++i) {
    count += inside->GetTuple1(i) == 1 ? 1 : 0;
  }
  EXPECT_EQ(count, static_cast<int>(authalic::readLabel(path).vertices.size()));
}
