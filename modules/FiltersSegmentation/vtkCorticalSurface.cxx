#include "vtkCorticalSurface.h"

#include <optional>
#include <string>

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/imaging/CorticalSurface.h"
#include "FieldArrays.h"

vtkStandardNewMacro(vtkCorticalSurface);

namespace {

void setHemisphere(vtkPolyData* output, const authalic::HemisphereSurface& side, const char* structure) {
  using authalic::addField;
  authalic::setMesh(output, side.mesh);
  authalic::addArray(output->GetPointData(), "MedialWall", side.medialWall);
  addField(output, "AnatomicalStructurePrimary", std::string(structure));
  addField(output, "CoordinateSpace", std::string("scanner-ras"));
  addField(output, "SurfaceArea", side.area);
  addField(output, "EnclosedVolume", side.volume);
  addField(output, "MedialWallShare", side.medialWallShare);
  addField(output, "EulerCharacteristic", side.eulerCharacteristic);
  addField(output, "ExtractedFaces", side.extractedFaces);
  addField(output, "PrunedSpikes", side.prunedSpikes);
  addField(output, "CutVoxels", static_cast<int>(side.cutVoxels));
  addField(output, "SealedVoxels", static_cast<int>(side.sealedVoxels));
}

void addBrain(vtkPolyData* output, const authalic::CorticalSurfaceResult& brain) {
  authalic::addField(output, "BrainVolume", brain.brainVolume);
  authalic::addField(output, "GreyWhiteThreshold", brain.classes.threshold);
  authalic::addField(output, "GreyMean", brain.classes.grey);
  authalic::addField(output, "WhiteMean", brain.classes.white);
}

}  // namespace

vtkCorticalSurface::vtkCorticalSurface() {
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  const authalic::CorticalSurfaceOptions defaults;
  this->Threshold = defaults.whiteMatter.threshold;
  this->BiasScale = defaults.whiteMatter.biasScale;
  this->MidlineBand = defaults.whiteMatter.midlineBand;
  this->Sealing = defaults.sealing;
  this->SmoothingIterations = defaults.smoothing.iterations;
  this->PassBand = defaults.smoothing.passBand;
  this->TargetFaces = defaults.targetFaces;
  this->MedialWallReach = defaults.medialWallReach;
}

int vtkCorticalSurface::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

authalic::CorticalSurfaceOptions vtkCorticalSurface::Options() const {
  authalic::CorticalSurfaceOptions options;
  if (this->LabelConvention == FREESURFER) options.whiteMatter.labels = authalic::LabelConvention::freeSurfer();
  options.whiteMatter.threshold = this->Threshold;
  options.whiteMatter.biasScale = this->BiasScale;
  options.whiteMatter.midlineBand = this->MidlineBand;
  options.sealing = this->Sealing;
  options.smoothing.iterations = this->SmoothingIterations;
  options.smoothing.passBand = this->PassBand;
  options.targetFaces = this->TargetFaces;
  options.medialWallReach = this->MedialWallReach;
  return options;
}

void vtkCorticalSurface::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                 const authalic::Execution& execution) {
  const authalic::ScalarVolume t1 = authalic::toScalarVolume(vtkImageData::GetData(inputs[0]));
  std::optional<authalic::LabelVolume> labels;
  if (vtkImageData* given = vtkImageData::GetData(inputs[1])) labels = authalic::toLabelVolume(given);
  const authalic::CorticalSurfaceResult brain =
      authalic::extractCorticalSurfaces(t1, labels ? &*labels : nullptr, this->Options(), execution);
  vtkPolyData* left = vtkPolyData::GetData(outputs, 0);
  vtkPolyData* right = vtkPolyData::GetData(outputs, 1);
  setHemisphere(left, brain.left, "CortexLeft");
  setHemisphere(right, brain.right, "CortexRight");
  for (vtkPolyData* output : {left, right}) addBrain(output, brain);
  for (const std::string& warning : brain.warnings) vtkWarningMacro(<< warning);
}

void vtkCorticalSurface::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LabelConvention: " << this->LabelConvention << "\n";
  os << indent << "Threshold: " << this->Threshold << "\n";
  os << indent << "BiasScale: " << this->BiasScale << " mm\n";
  os << indent << "MidlineBand: " << this->MidlineBand << " mm\n";
  os << indent << "Sealing: " << this->Sealing << "\n";
  os << indent << "SmoothingIterations: " << this->SmoothingIterations << "\n";
  os << indent << "PassBand: " << this->PassBand << "\n";
  os << indent << "TargetFaces: " << this->TargetFaces << "\n";
  os << indent << "MedialWallReach: " << this->MedialWallReach << " mm\n";
}
