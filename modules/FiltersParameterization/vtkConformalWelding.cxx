#include "vtkConformalWelding.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>
#include <vector>

#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/conformal/SphereNormalisation.h"
#include "Core/conformal/WeldedDisks.h"
#include "FieldArrays.h"
#include "FilterGuard.h"
#include "HistogramArrays.h"
#include "MapArrays.h"
#include "Reports/MapReport.h"

vtkStandardNewMacro(vtkConformalWelding);

namespace {

using namespace authalic;

std::vector<int> numbersOf(vtkPolyData* map, const std::string& array) {
  return toIntegers(requireArray(map->GetPointData(), array, 1, "welding"));
}

/// The welded surface with where its vertices and faces come from.
vtkSmartPointer<vtkPolyData> describeOrigin(const WeldedDisks& welded, const DiskMesh& first, const DiskMesh& second,
                                            const SeamPairs& seam) {
  const auto whole = vtkSmartPointer<vtkPolyData>::New();
  setMesh(whole, welded.surface.mesh());
  const auto points = static_cast<std::size_t>(welded.surface.mesh().vertexCount());
  const auto cells = static_cast<std::size_t>(welded.surface.mesh().faceCount());
  const auto firstCells = static_cast<std::size_t>(first.mesh().faceCount());
  std::vector<int> pointIds(points), pointDisks(points, 1), cellIds(cells), cellDisks(cells, 1);
  for (int i = 0; i < second.mesh().vertexCount(); ++i) {
    const auto here = static_cast<std::size_t>(welded.secondVertices[static_cast<std::size_t>(i)]);
    pointIds[here] = i;
    pointDisks[here] = 2;
  }
  std::iota(pointIds.begin(), pointIds.begin() + first.mesh().vertexCount(), 0);
  for (const auto& pair : seam) pointDisks[static_cast<std::size_t>(pair[0])] = 0;
  for (std::size_t f = 0; f < cells; ++f) cellIds[f] = static_cast<int>(f < firstCells ? f : f - firstCells);
  std::fill(cellDisks.begin() + first.mesh().faceCount(), cellDisks.end(), 2);
  addIds(whole->GetPointData(), "OriginalPointIds", pointIds);
  addArray(whole->GetPointData(), "Disk", pointDisks);
  addIds(whole->GetCellData(), "OriginalCellIds", cellIds);
  addArray(whole->GetCellData(), "Disk", cellDisks);
  return whole;
}

SphereNormalisation inPosition(const WeldedDisks& welded, bool normalise) {
  if (normalise) return normaliseSphere(welded.surface.mesh(), welded.image);
  SphereNormalisation as;
  as.image = welded.image;
  as.residual = centreOfMassDistance(welded.surface.mesh(), welded.image);
  return as;
}

}  // namespace

vtkConformalWelding::vtkConformalWelding() { this->SetNumberOfInputPorts(2); }

int vtkConformalWelding::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkConformalWelding::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                     vtkInformationVector* outputs) {
  this->Report.clear();
  return this->Superclass::RequestData(request, inputs, outputs);
}

void vtkConformalWelding::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                  const Execution& execution) {
  vtkPolyData* maps[] = {vtkPolyData::GetData(inputs[0]), vtkPolyData::GetData(inputs[1])};
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const auto start = std::chrono::steady_clock::now();
  const DiskMesh first(surfaceOfMap(maps[0])), second(surfaceOfMap(maps[1]));
  const std::string& signature = this->SignatureArrayName;
  const SeamPairs seam = signature.empty() ? matchByPlace(first, second)
                                           : matchByNumber(first, numbersOf(maps[0], signature), second,
                                                           numbersOf(maps[1], signature));
  const WeldedDisks welded =
      weldDisks(first, toPlanarPoints(maps[0]), second, toPlanarPoints(maps[1]), seam, execution);
  const WeldingAccuracy accuracy = welded.welding.accuracy(execution);
  const SphereNormalisation position = inPosition(welded, this->Normalise);
  const TriangleMesh& surface = welded.surface.mesh();
  const auto whole = describeOrigin(welded, first, second, seam);
  passFields(maps[0], whole);
  MapReport report;
  report.method = "conformal-welding";
  report.seconds = {{"map", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()}};
  const SphericalDistortion distortion = fillMap(whole, output, surface, position.image);
  report.status = Status::Converged;
  report.metrics = distortion.summary;
  report.histograms = histogramsOf(output);
  report.topology = inspect(surface, welded.surface.topology());
  report.options.set("signature", signature).set("normalise", this->Normalise);
  report.more.set("seam_points", seam.size())
      .set("boundary_mismatch", accuracy.boundaryMismatch)
      .set("midpoint_mismatch", accuracy.midpointMismatch)
      .set("centre_of_mass", position.residual)
      .set("sphere", sphericalDistortionReport(distortion));
  addField(output, "Method", report.method);
  addField(output, "SeamPoints", static_cast<int>(seam.size()));
  addField(output, "BoundaryMismatch", accuracy.boundaryMismatch);
  addField(output, "MidpointMismatch", accuracy.midpointMismatch);
  addField(output, "CentreOfMass", position.residual);
  this->Report = mapReport(report).text();
  this->ErrorKind = reportStatus(this, output, report.status, 0);
}

void vtkConformalWelding::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SignatureArrayName: " << this->SignatureArrayName << "\n";
  os << indent << "Normalise: " << (this->Normalise ? "On" : "Off") << "\n";
  os << indent << "Report: " << (this->Report.empty() ? "none" : "there is one") << "\n";
}
