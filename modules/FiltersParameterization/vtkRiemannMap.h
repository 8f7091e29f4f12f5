/**
 * @class vtkRiemannMap
 * @brief Conformal map of a topological disk onto the unit disk.
 *
 * BOUNDARY prescribes the curvature of a circle on the boundary: discretely conformal up to the boundary. PUNCTURE
 * takes out a face, makes the rest a flat cylinder and closes it by the exponential; faces at the puncture are less
 * conformal. Both agree up to a Möbius transformation as meshes get finer. What is free, a Möbius transformation, is
 * fixed by Centre and StartVertex.
 *
 * Folded faces and non-convergence: as in vtkYamabeMap. Ports and arrays: see vtkCurvatureFlowMapAlgorithm and
 * vtkSurfaceMapAlgorithm (the factors of LogScale hold to second order in the edge length for PUNCTURE); also
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | Roundness | 1 double | how far boundary vertices were from the circle, relative, before they were put on it |
 *
 * See springborn2008 and nadeem2017 in docs/references.bib, and docs/methods/riemann-map.md.
 *
 * @sa vtkYamabeMap vtkBarycentricMap
 */
#ifndef vtkRiemannMap_h
#define vtkRiemannMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkCurvatureFlowMapAlgorithm.h"

namespace authalic
{
struct RiemannMapOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkRiemannMap : public vtkCurvatureFlowMapAlgorithm
{
public:
  static vtkRiemannMap* New();
  vtkTypeMacro(vtkRiemannMap, vtkCurvatureFlowMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum RoadType
  {
    BOUNDARY = 0,
    PUNCTURE = 1
  };
  enum CentreType
  {
    AREA_CENTROID = 0,
    VERTEX = 1,
    FACE = 2
  };

  ///@{
  /** Which way leads to the disk. Default: authalic::RiemannMapOptions, as below. */
  vtkSetClampMacro(Road, int, BOUNDARY, PUNCTURE);
  vtkGetMacro(Road, int);
  void SetRoadToBoundary() { this->SetRoad(BOUNDARY); }
  void SetRoadToPuncture() { this->SetRoad(PUNCTURE); }
  ///@}

  ///@{
  /**
   * Face taken out on the road PUNCTURE, none of its vertices on the boundary; -1 = the one farthest from it. It says
   * nothing about the centre of the image.
   */
  vtkSetMacro(Puncture, int);
  vtkGetMacro(Puncture, int);
  ///@}

  ///@{
  /** What goes to the centre of the disk: the area centroid of the surface, or the vertex or face CentreId. */
  vtkSetClampMacro(Centre, int, AREA_CENTROID, FACE);
  vtkGetMacro(Centre, int);
  void SetCentreToAreaCentroid() { this->SetCentre(AREA_CENTROID); }
  void SetCentreToVertex() { this->SetCentre(VERTEX); }
  void SetCentreToFace() { this->SetCentre(FACE); }
  ///@}

  ///@{
  /** Inner vertex or face that goes to the centre, for VERTEX and FACE; not read else. */
  vtkSetMacro(CentreId, int);
  vtkGetMacro(CentreId, int);
  ///@}

protected:
  vtkRiemannMap();
  ~vtkRiemannMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int Road;
  int Puncture;
  int Centre;
  int CentreId;

private:
  authalic::RiemannMapOptions Options() const;

  vtkRiemannMap(const vtkRiemannMap&) = delete;
  void operator=(const vtkRiemannMap&) = delete;
};

#endif
