#include "vtkElementGrid.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "GridArrays.h"

vtkStandardNewMacro(vtkElementGrid);

static_assert(static_cast<int>(authalic::GridFrame::BoundingBox) == vtkElementGrid::BOUNDING_BOX);

vtkElementGrid::vtkElementGrid() {
  this->SetNumberOfOutputPorts(3);
  const authalic::ElementGridOptions defaults;
  this->NumberOfElements = defaults.elements;
  this->ElementArea = defaults.elementArea;
  this->Frame = static_cast<int>(defaults.frame);
  this->MergeBelow = defaults.mergeBelow;
}

void vtkElementGrid::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                             const authalic::Execution& execution) {
  vtkPolyData* map = vtkPolyData::GetData(inputs[0]);
  const authalic::TriangleMesh surface = authalic::surfaceOfMap(map);
  const authalic::Points2 image = authalic::toPlanarPoints(map);
  authalic::ElementGridOptions options;
  options.elements = this->NumberOfElements;
  options.elementArea = this->ElementArea;
  options.frame = static_cast<authalic::GridFrame>(this->Frame);
  options.mergeBelow = this->MergeBelow;
  const authalic::ElementGrid grid = authalic::elementGrid(surface, image, options, execution);
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  output->ShallowCopy(map);
  authalic::addGrid(output, grid, options);
  authalic::setOutline(vtkPolyData::GetData(outputs, 1), authalic::elementOutline(surface, image, grid));
  authalic::setCells(vtkPolyData::GetData(outputs, 2), grid);
}

void vtkElementGrid::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfElements: " << this->NumberOfElements << "\n";
  os << indent << "ElementArea: " << this->ElementArea << " mm^2\n";
  os << indent << "Frame: " << this->Frame << "\n";
  os << indent << "MergeBelow: " << this->MergeBelow << "\n";
}
