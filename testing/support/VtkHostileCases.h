/// @file
/// One small file per flavour of the formats that VTK reads, shared by the tests of altered files and the fuzzer.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSTLWriter.h>
#include <vtkStringArray.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataWriter.h>

namespace authalic::testing {

struct VtkHostileCase {
  const char* name;
  std::function<void(const std::string&)> write;
};

/// An octahedron with a square, a strip, a line and a vertex, arrays of points, cells and fields.
inline void fillPolyData(vtkPolyData* surface) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> values;
  vtkNew<vtkIntArray> ids;
  vtkNew<vtkStringArray> words;
  const double corners[6][3] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const auto& corner : corners) {
    points->InsertNextPoint(corner);
    values->InsertNextValue(static_cast<float>(corner[0]));
  }
  const auto add = [](const std::vector<std::vector<vtkIdType>>& list) {
    vtkNew<vtkCellArray> cells;
    for (const auto& cell : list) {
      cells->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
    }
    return vtkSmartPointer<vtkCellArray>(cells);
  };
  surface->SetPoints(points);
  surface->SetVerts(add({{0}}));
  surface->SetLines(add({{0, 1, 2}}));
  surface->SetPolys(add({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 3, 2, 1}}));
  surface->SetStrips(add({{0, 5, 1, 2}}));
  for (int i = 0; i < 8; ++i) {
    ids->InsertNextValue(i);
  }
  values->SetName("height");
  ids->SetName("id");
  words->SetName("CoordinateSpace");
  words->InsertNextValue("scanner-ras");
  surface->GetPointData()->SetScalars(values);
  surface->GetCellData()->AddArray(ids);
  surface->GetFieldData()->AddArray(words);
}

inline void writeLegacy(const std::string& path, bool ascii, int version) {
  vtkNew<vtkPolyData> surface;
  fillPolyData(surface);
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileName(path.c_str());
  writer->SetFileType(ascii ? VTK_ASCII : VTK_BINARY);
  writer->SetFileVersion(version);
  writer->Write();
}

inline void writeXml(const std::string& path, int mode, bool base64, bool compressed) {
  vtkNew<vtkPolyData> surface;
  fillPolyData(surface);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileName(path.c_str());
  writer->SetDataMode(mode);
  writer->SetEncodeAppendedData(base64);
  writer->SetCompressorType(compressed ? vtkXMLWriter::ZLIB : vtkXMLWriter::NONE);
  writer->Write();
}

inline void writeStl(const std::string& path, bool ascii) {
  vtkNew<vtkPolyData> surface;
  fillPolyData(surface);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputConnection(triangles->GetOutputPort());
  writer->SetFileName(path.c_str());
  writer->SetFileType(ascii ? VTK_ASCII : VTK_BINARY);
  writer->Write();
}

inline const std::vector<VtkHostileCase>& vtkHostileCases() {
  static const std::vector<VtkHostileCase> all{
      {"ascii42.vtk", [](const auto& path) { writeLegacy(path, true, 42); }},
      {"binary42.vtk", [](const auto& path) { writeLegacy(path, false, 42); }},
      {"ascii51.vtk", [](const auto& path) { writeLegacy(path, true, 51); }},
      {"binary51.vtk", [](const auto& path) { writeLegacy(path, false, 51); }},
      {"ascii.vtp", [](const auto& path) { writeXml(path, vtkXMLWriter::Ascii, true, false); }},
      {"inline.vtp", [](const auto& path) { writeXml(path, vtkXMLWriter::Binary, true, true); }},
      {"base64.vtp", [](const auto& path) { writeXml(path, vtkXMLWriter::Appended, true, true); }},
      {"raw.vtp", [](const auto& path) { writeXml(path, vtkXMLWriter::Appended, false, true); }},
      {"plain.vtp", [](const auto& path) { writeXml(path, vtkXMLWriter::Appended, false, false); }},
      {"ascii.stl", [](const auto& path) { writeStl(path, true); }},
      {"binary.stl", [](const auto& path) { writeStl(path, false); }},
  };
  return all;
}

}  // namespace authalic::testing
