#include "vtkSurfaceTopologyReport.h"

#include <vtkCellData.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/mesh/MeshReport.h"
#include "FieldArrays.h"
#include "Reports/MapReport.h"

vtkStandardNewMacro(vtkSurfaceTopologyReport);

namespace {

using authalic::MeshDefect;
using authalic::MeshReport;

void mark(std::vector<char>& flags, std::initializer_list<const std::vector<MeshDefect>*> lists) {
  for (const std::vector<MeshDefect>* list : lists) {
    for (const MeshDefect& defect : *list) {
      for (const int id : defect.ids) flags[static_cast<std::size_t>(id)] = 1;
    }
  }
}

void addPlaces(vtkPolyData* output, const MeshReport& report, const authalic::SurfaceTopology& topology) {
  std::vector<int> loopOf(static_cast<std::size_t>(topology.vertexCount()), 0);
  int number = 0;
  for (const std::vector<int>& loop : topology.boundaryLoops()) {
    ++number;
    for (const int vertex : loop) loopOf[static_cast<std::size_t>(vertex)] = number;
  }
  std::vector<char> points(loopOf.size(), 0), faces(static_cast<std::size_t>(topology.faces().rows()), 0);
  mark(points, {&report.nonManifoldEdges, &report.inconsistentEdges, &report.nonManifoldVertices,
                &report.isolatedVertices});
  mark(faces, {&report.degenerateFaces, &report.duplicateFaces});
  authalic::addArray(output->GetPointData(), "BoundaryLoop", loopOf);
  authalic::addArray(output->GetPointData(), "Defect", points);
  authalic::addArray(output->GetCellData(), "Component", topology.faceComponents());
  authalic::addArray(output->GetCellData(), "Defect", faces);
}

void addNumbers(vtkPolyData* output, const MeshReport& r) {
  const auto count = [](const auto& list) { return static_cast<int>(list.size()); };
  const std::pair<const char*, int> counts[] = {
      {"VertexCount", r.vertexCount},
      {"EdgeCount", r.edgeCount},
      {"FaceCount", r.faceCount},
      {"EulerCharacteristic", r.eulerCharacteristic},
      {"Genus", r.genus},
      {"Components", count(r.components)},
      {"BoundaryLoops", count(r.loops)},
      {"NonManifoldEdges", count(r.nonManifoldEdges)},
      {"InconsistentEdges", count(r.inconsistentEdges)},
      {"NonManifoldVertices", count(r.nonManifoldVertices)},
      {"IsolatedVertices", count(r.isolatedVertices)},
      {"DegenerateFaces", count(r.degenerateFaces)},
      {"DuplicateFaces", count(r.duplicateFaces)},
  };
  for (const auto& [name, value] : counts) authalic::addField(output, name, value);
  std::vector<double> lengths;
  for (const authalic::BoundaryLoopReport& loop : r.loops) lengths.push_back(loop.length);
  authalic::addField(output, "LoopLengths", lengths);
  authalic::addField(output, "SurfaceArea", r.area);
  authalic::addField(output, "EnclosedVolume", r.volume);
}

}  // namespace

void vtkSurfaceTopologyReport::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                       const authalic::Execution&) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->Summary.clear();
  this->Report.clear();
  const authalic::TriangleMesh mesh = authalic::toTriangleMesh(input);
  const authalic::SurfaceTopology topology(mesh.faces(), mesh.vertexCount());
  const MeshReport report = authalic::inspect(mesh, topology);
  output->ShallowCopy(input);
  addPlaces(output, report, topology);
  addNumbers(output, report);
  this->Summary = report.summary();
  this->Report = authalic::meshReport(report).text();
}

void vtkSurfaceTopologyReport::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Summary: " << this->Summary << "\n";
}
