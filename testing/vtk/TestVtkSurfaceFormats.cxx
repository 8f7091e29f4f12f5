#include <gtest/gtest.h>

#include <fstream>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkSTLReader.h>
#include <vtkXMLPolyDataReader.h>

#include "VtkSurfaceFormats.h"
#include "support/TemporaryFolder.h"
#include "support/VtkHostileCases.h"

namespace {

using authalic::testing::TemporaryFolder;

void expectSame(vtkAbstractArray* ours, vtkAbstractArray* theirs) {
  ASSERT_TRUE(ours && theirs);
  EXPECT_STREQ(ours->GetName(), theirs->GetName());
  EXPECT_EQ(ours->GetDataType(), theirs->GetDataType());
  EXPECT_EQ(ours->GetNumberOfComponents(), theirs->GetNumberOfComponents());
  ASSERT_EQ(ours->GetNumberOfValues(), theirs->GetNumberOfValues());
  for (vtkIdType i = 0; i < ours->GetNumberOfValues(); ++i) {
    EXPECT_EQ(ours->GetVariantValue(i), theirs->GetVariantValue(i));
  }
}

void expectSame(vtkFieldData* ours, vtkFieldData* theirs) {
  ASSERT_EQ(ours->GetNumberOfArrays(), theirs->GetNumberOfArrays());
  for (int i = 0; i < ours->GetNumberOfArrays(); ++i) {
    expectSame(ours->GetAbstractArray(i), theirs->GetAbstractArray(i));
  }
}

/// The file through our reader and VTK's, where ours makes triangles of polygons.
void expectAgreement(const std::string& path) {
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData* theirs = reader->GetOutput();
  vtkNew<vtkPolyData> ours;
  authalic::readVtkSurface(path, ours);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->SetInputData(theirs);
  triangles->Update();
  expectSame(ours->GetPointData(), triangles->GetOutput()->GetPointData());
  expectSame(ours->GetCellData(), triangles->GetOutput()->GetCellData());
  expectSame(ours->GetFieldData(), triangles->GetOutput()->GetFieldData());
  expectSame(ours->GetPolys()->GetConnectivityArray(), triangles->GetOutput()->GetPolys()->GetConnectivityArray());
  ASSERT_EQ(ours->GetNumberOfPoints(), theirs->GetNumberOfPoints());
  for (vtkIdType i = 0; i < ours->GetNumberOfPoints(); ++i) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(ours->GetPoint(i)[k], theirs->GetPoint(i)[k]);
    }
  }
  vtkDataArray* scalars = ours->GetPointData()->GetScalars();
  ASSERT_TRUE(scalars);
  EXPECT_STREQ(scalars->GetName(), "height");
}

/// Every type of number, also of several components with names, and texts of points.
void addMore(vtkPolyData* surface) {
  for (const int type : {VTK_TYPE_INT8, VTK_TYPE_UINT8, VTK_TYPE_INT16, VTK_TYPE_UINT16, VTK_TYPE_INT32,
                         VTK_TYPE_UINT32, VTK_TYPE_INT64, VTK_TYPE_UINT64, VTK_TYPE_FLOAT64, VTK_ID_TYPE}) {
    const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    array->SetName(("type" + std::to_string(type)).c_str());
    array->SetNumberOfComponents(2);
    array->SetComponentName(1, "second");
    array->SetNumberOfTuples(surface->GetNumberOfPoints());
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
      array->SetTuple2(i, static_cast<double>(i), 3.0);
    }
    surface->GetPointData()->AddArray(array);
  }
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    words->InsertNextValue(i % 2 == 0 ? "" : "größe " + std::to_string(i));
  }
  surface->GetPointData()->AddArray(words);
}

}  // namespace

TEST(VtpReader, AgreesWithVtksOnEveryFlavourThatVtkWrites) {
  const TemporaryFolder folder;
  vtkNew<vtkPolyData> surface;
  authalic::testing::fillPolyData(surface);
  addMore(surface);
  for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended}) {
    for (const int compressor : {vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA}) {
      for (int choice = 0; choice < 8; ++choice) {
        vtkNew<vtkXMLPolyDataWriter> writer;
        writer->SetInputData(surface);
        writer->SetFileName((folder / "s.vtp").c_str());
        writer->SetDataMode(mode);
        writer->SetCompressorType(compressor);
        writer->SetEncodeAppendedData(choice & 1);
        writer->SetHeaderType((choice & 2) != 0 ? vtkXMLWriter::UInt64 : vtkXMLWriter::UInt32);
        writer->SetByteOrder((choice & 4) != 0 ? vtkXMLWriter::BigEndian : vtkXMLWriter::LittleEndian);
        writer->SetBlockSize(64);
        writer->Write();
        SCOPED_TRACE(std::to_string(mode) + " " + std::to_string(compressor) + " " + std::to_string(choice));
        expectAgreement(folder / "s.vtp");
      }
    }
  }
}

TEST(VtpReader, JoinsThePiecesOfAFile) {
  const TemporaryFolder folder;
  vtkNew<vtkPolyData> surface;
  authalic::testing::fillPolyData(surface);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileName((folder / "s.vtp").c_str());
  writer->SetDataMode(vtkXMLWriter::Ascii);
  writer->Write();
  std::ifstream input(folder / "s.vtp");
  std::string text((std::istreambuf_iterator<char>(input)), {});
  const auto begin = text.find("<Piece"), end = text.find("</Piece>") + 8;
  text.insert(end, text.substr(begin, end - begin));
  std::ofstream(folder / "t.vtp") << text;
  vtkNew<vtkPolyData> once, twice;
  authalic::readVtkSurface(folder / "s.vtp", once);
  authalic::readVtkSurface(folder / "t.vtp", twice);
  EXPECT_EQ(twice->GetNumberOfPoints(), 2 * once->GetNumberOfPoints());
  EXPECT_EQ(twice->GetNumberOfPolys(), 2 * once->GetNumberOfPolys());
}

TEST(StlReader, AgreesWithVtksOnTextAndBinary) {
  const TemporaryFolder folder;
  for (const bool ascii : {false, true}) {
    authalic::testing::writeStl(folder / "s.stl", ascii);
    vtkNew<vtkSTLReader> reader;
    reader->SetFileName((folder / "s.stl").c_str());
    reader->Update();
    vtkPolyData* theirs = reader->GetOutput();
    vtkNew<vtkPolyData> ours;
    authalic::readVtkSurface(folder / "s.stl", ours);
    ASSERT_EQ(ours->GetNumberOfPoints(), theirs->GetNumberOfPoints());
    for (vtkIdType i = 0; i < ours->GetNumberOfPoints(); ++i) {
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(ours->GetPoint(i)[k], theirs->GetPoint(i)[k]);
      }
    }
    vtkDataArray* corners = ours->GetPolys()->GetConnectivityArray();
    ASSERT_EQ(corners->GetNumberOfValues(), theirs->GetPolys()->GetConnectivityArray()->GetNumberOfValues());
    for (vtkIdType i = 0; i < corners->GetNumberOfValues(); ++i) {
      EXPECT_EQ(corners->GetComponent(i, 0), theirs->GetPolys()->GetConnectivityArray()->GetComponent(i, 0));
    }
  }
}
