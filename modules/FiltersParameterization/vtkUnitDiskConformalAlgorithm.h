/**
 * @class vtkUnitDiskConformalAlgorithm
 * @brief What the conformal maps into the unit disk share: the Moebius transformation, and the common refinement.
 *
 * Ports and arrays: see vtkConformalFlowAlgorithm.
 */
#ifndef vtkUnitDiskConformalAlgorithm_h
#define vtkUnitDiskConformalAlgorithm_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkConformalFlowAlgorithm.h"

namespace authalic
{
class Json;
struct DiskNormalisation;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkUnitDiskConformalAlgorithm : public vtkConformalFlowAlgorithm
{
public:
  vtkTypeMacro(vtkUnitDiskConformalAlgorithm, vtkConformalFlowAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum CentreType
  {
    AREA_CENTROID = 0,
    VERTEX = 1,
    FACE = 2
  };

  ///@{
  /**
   * What a Moebius transformation brings to the centre of the disk: the centroid of the surface's area, a vertex,
   * or the middle of a face. Default AREA_CENTROID.
   */
  vtkSetClampMacro(Centre, int, AREA_CENTROID, FACE);
  vtkGetMacro(Centre, int);
  void SetCentreToAreaCentroid() { this->SetCentre(AREA_CENTROID); }
  void SetCentreToVertex() { this->SetCentre(VERTEX); }
  void SetCentreToFace() { this->SetCentre(FACE); }
  ///@}

  ///@{
  /** Id of that vertex or face. Default -1: none. */
  vtkSetMacro(CentreId, int);
  vtkGetMacro(CentreId, int);
  ///@}

  ///@{
  /** Vertex of the outer loop that goes to angle 0; -1 = the one with the smallest id. Default -1. */
  vtkSetMacro(StartVertex, int);
  vtkGetMacro(StartVertex, int);
  ///@}

  ///@{
  /**
   * Whether the output is the common refinement of the input and of the flow's triangulation, on which nothing is
   * folded, in place of the input's faces. It has OriginalPointIds (-1 where edges cross) and OriginalCellIds.
   * Default off.
   */
  vtkSetMacro(Refine, bool);
  vtkGetMacro(Refine, bool);
  vtkBooleanMacro(Refine, bool);
  ///@}

protected:
  vtkUnitDiskConformalAlgorithm() = default;
  ~vtkUnitDiskConformalAlgorithm() override = default;

  authalic::DiskNormalisation Normalisation() const;

  /** DescribeFlow() and the properties here. */
  authalic::Json DescribeDisk(const char* domain) const;

  int Centre = AREA_CENTROID;
  int CentreId = -1;
  int StartVertex = -1;
  bool Refine = false;

private:
  vtkUnitDiskConformalAlgorithm(const vtkUnitDiskConformalAlgorithm&) = delete;
  void operator=(const vtkUnitDiskConformalAlgorithm&) = delete;
};

#endif
