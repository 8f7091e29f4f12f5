/**
 * @class vtkCircleDomainMap
 * @brief Conformal map of a surface with several boundary loops onto the unit disk without round holes.
 *
 * CURVATURE: one flow with the curvature of circles on every loop. KOEBE: loop by loop, holes filled, a Riemann map,
 * over and over; slower, an independent check. Both agree up to a Möbius transformation as meshes get finer. What is
 * free, a Möbius transformation of the disk, is fixed by Centre and StartVertex.
 *
 * Folded faces and non-convergence: as in vtkYamabeMap; ears on inner loops bulge into the hole (Pockets). Input 0 must
 * be connected, oriented, manifold, of genus 0 and have a boundary. Ports and arrays: see vtkCurvatureFlowMapAlgorithm
 * (LogScale and Refine for CURVATURE only) and vtkSurfaceMapAlgorithm; also
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | Circles | 3 double each | x, y of the centre and radius of every loop, in the order of the loops' smallest ids |
 * | field | CircleRoundness | 1 double each | how far its vertices are from it, relative to the radius, pockets set aside |
 * | field | OuterLoop | 1 int | which of them is the unit circle |
 * | field | Roundness | 1 double | how far loops were from their circles, relative, before they were put on them |
 * | field | Rounds | 1 int | KOEBE: rounds over all loops |
 *
 * See su2016 and koebe1910 in docs/references.bib, and docs/methods/circle-domain.md.
 *
 * @sa vtkAnnulusMap vtkRiemannMap
 */
#ifndef vtkCircleDomainMap_h
#define vtkCircleDomainMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkCurvatureFlowMapAlgorithm.h"

#include <vector> // for loops

namespace authalic
{
struct CircleDomainOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkCircleDomainMap : public vtkCurvatureFlowMapAlgorithm
{
public:
  static vtkCircleDomainMap* New();
  vtkTypeMacro(vtkCircleDomainMap, vtkCurvatureFlowMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum RoadType
  {
    CURVATURE = 0,
    KOEBE = 1
  };
  enum CentreType
  {
    AREA_CENTROID = 0,
    VERTEX = 1,
    FACE = 2
  };

  ///@{
  /** Which way leads to round holes. Default: authalic::CircleDomainOptions, as below. */
  vtkSetClampMacro(Road, int, CURVATURE, KOEBE);
  vtkGetMacro(Road, int);
  void SetRoadToCurvature() { this->SetRoad(CURVATURE); }
  void SetRoadToKoebe() { this->SetRoad(KOEBE); }
  ///@}

  ///@{
  /** A vertex of the loop that becomes the unit circle; -1 = the longest loop. Default -1. */
  vtkSetMacro(OuterVertex, int);
  vtkGetMacro(OuterVertex, int);
  ///@}

  ///@{
  /** KOEBE: stop when every loop is a circle to this, relative to its radius, > 0. */
  vtkSetMacro(RoundnessTolerance, double);
  vtkGetMacro(RoundnessTolerance, double);
  ///@}

  ///@{
  /** KOEBE: most rounds over all loops, 0 or more. */
  vtkSetClampMacro(MaximumRounds, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumRounds, int);
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
  vtkCircleDomainMap();
  ~vtkCircleDomainMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int Road;
  int OuterVertex = -1;
  double RoundnessTolerance;
  int MaximumRounds;
  int Centre;
  int CentreId;

private:
  authalic::CircleDomainOptions Options(const std::vector<std::vector<int>>& loops) const;

  vtkCircleDomainMap(const vtkCircleDomainMap&) = delete;
  void operator=(const vtkCircleDomainMap&) = delete;
};

#endif
