#include "vtkSurfaceMapAlgorithm.h"

#include <vtkPolyData.h>

#include "FieldArrays.h"
#include "FilterGuard.h"
#include "HistogramArrays.h"
#include "MapArrays.h"
#include "RegionArrays.h"
#include "Reports/MapReport.h"

int vtkSurfaceMapAlgorithm::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                        vtkInformationVector* outputs) {
  this->Report.clear();
  return this->Superclass::RequestData(request, inputs, outputs);
}

void vtkSurfaceMapAlgorithm::Publish(vtkPolyData* map, const authalic::MapReport& report) {
  authalic::addField(map, "Method", report.method);
  authalic::addField(map, "Residuals", report.residuals);
  if (this->OutputMode == TEXTURE_COORDINATES) authalic::imageToTextureCoordinates(map);
  authalic::MapReport complete = report;
  complete.histograms = authalic::histogramsOf(map);
  if (const auto regions = authalic::regionsReport(map)) complete.more.set("regions", *regions);
  this->Report = authalic::mapReport(complete).text();
  this->ErrorKind = authalic::reportStatus(this, map, report.status, report.iterations);
}

std::string vtkSurfaceMapAlgorithm::GetStatus() { return authalic::textField(this->GetOutput(), "Status"); }

int vtkSurfaceMapAlgorithm::GetIterations() {
  return static_cast<int>(authalic::numberField(this->GetOutput(), "Iterations"));
}

double vtkSurfaceMapAlgorithm::GetTotalAreaDistortion() {
  return authalic::numberField(this->GetOutput(), "TotalAreaDistortion");
}

double vtkSurfaceMapAlgorithm::GetTotalAngleDistortion() {
  return authalic::numberField(this->GetOutput(), "TotalAngleDistortion");
}

int vtkSurfaceMapAlgorithm::GetFlippedFaces() {
  return static_cast<int>(authalic::numberField(this->GetOutput(), "FlippedFaces"));
}

void vtkSurfaceMapAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputMode: " << this->OutputMode << "\n";
  os << indent << "MeasureArrayName: " << this->MeasureArrayName << "\n";
  os << indent << "Report: " << (this->Report.empty() ? "none" : "there is one") << "\n";
}
