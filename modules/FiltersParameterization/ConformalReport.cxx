#include "ConformalReport.h"

#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "MapArrays.h"

namespace authalic {

Distortion fillRefinedMap(vtkPolyData* input, vtkPolyData* map, const CommonRefinement& refinement) {
  Distortion distortion = measureDistortion(refinement.mesh, refinement.image);
  setMesh(map, refinement.mesh);
  gatherArrays(input->GetCellData(), refinement.originalFaceIds, map->GetCellData());
  passFields(input, map);
  addIds(map->GetPointData(), "OriginalPointIds", refinement.originalPointIds);
  addIds(map->GetCellData(), "OriginalCellIds", refinement.originalFaceIds);
  addArray(map->GetPointData(), "OriginalPoints", refinement.mesh.points());
  setPoints(map, refinement.image);
  addDistortion(map, distortion);
  return distortion;
}

}  // namespace authalic
