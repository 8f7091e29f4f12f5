/**
 * @class vtkCircleDomainMap
 * @brief Conformal map of a surface with several boundary loops onto the unit disk without round holes.
 *
 * One flow with the curvature of circles on every loop; or Koebe's iteration, loop by loop, an independent check. Both
 * roads agree up to a Moebius transformation as meshes get finer.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: connected, oriented, manifold, genus 0, one or more boundary loops |
 * | output 0 | vtkPolyData, the map: see vtkConformalFlowAlgorithm |
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | point | LogScaleFactor | 1 double | u: image lengths are l_ij exp((u_i + u_j)/2) where no edge was flipped (road CURVATURE) |
 * | field | Method | 1 string | circle-domain |
 * | field | Circles | 3 double per loop | x, y of the centre, and the radius |
 * | field | OuterLoop | 1 int | which of them is the unit circle |
 * | field | Roundness | 1 double | how far loops were from their circles, relative, before they were put on them |
 * | field | Pockets | 1 int | pockets of the boundary that were bulged into holes |
 *
 * Loops are in the order of their smallest vertex id. See su2016 and koebe1910 in docs/references.bib, and
 * docs/methods/circle-domain.md.
 *
 * @sa vtkRiemannMap vtkAnnulusMap
 */
#ifndef vtkCircleDomainMap_h
#define vtkCircleDomainMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkUnitDiskConformalAlgorithm.h"

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkCircleDomainMap : public vtkUnitDiskConformalAlgorithm
{
public:
  static vtkCircleDomainMap* New();
  vtkTypeMacro(vtkCircleDomainMap, vtkUnitDiskConformalAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum RoadType
  {
    CURVATURE = 0,
    KOEBE = 1
  };

  ///@{
  /** One flow for all loops, or Koebe's iteration. Default CURVATURE. */
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
  /** Koebe: stop when every loop is a circle to this, relative to its radius, > 0. */
  vtkSetMacro(RoundnessTolerance, double);
  vtkGetMacro(RoundnessTolerance, double);
  ///@}

  ///@{
  /** Koebe: most rounds over all loops, 0 or more. */
  vtkSetClampMacro(MaximumRounds, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumRounds, int);
  ///@}

protected:
  vtkCircleDomainMap();
  ~vtkCircleDomainMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int Road = CURVATURE;
  int OuterVertex = -1;
  double RoundnessTolerance;
  int MaximumRounds;

private:
  vtkCircleDomainMap(const vtkCircleDomainMap&) = delete;
  void operator=(const vtkCircleDomainMap&) = delete;
};

#endif
