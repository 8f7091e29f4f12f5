/**
 * @class vtkRiemannMap
 * @brief Conformal map of a topological disk onto the unit disk.
 *
 * Finds the flat metric in the discrete conformal class of the surface whose boundary is a circle, lays it out, and
 * puts it in place by a Moebius transformation; or takes out a face, makes the rest a flat cylinder and closes it
 * by the exponential. Both roads agree as meshes get finer.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: connected, oriented, manifold, genus 0, one boundary loop |
 * | output 0 | vtkPolyData, the map: see vtkConformalFlowAlgorithm |
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | Method | 1 string | riemann |
 * | field | Roundness | 1 double | how far the boundary was from the circle, relative, before it was put on it |
 *
 * See nadeem2017 and springborn2008 in docs/references.bib, and docs/methods/riemann-map.md.
 *
 * @sa vtkYamabeMap vtkCircleDomainMap vtkLeastSquaresConformalMap
 */
#ifndef vtkRiemannMap_h
#define vtkRiemannMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkUnitDiskConformalAlgorithm.h"

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkRiemannMap : public vtkUnitDiskConformalAlgorithm
{
public:
  static vtkRiemannMap* New();
  vtkTypeMacro(vtkRiemannMap, vtkUnitDiskConformalAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum RoadType
  {
    BOUNDARY = 0,
    PUNCTURE = 1
  };

  ///@{
  /** The curvature of a circle on the boundary, or the way over a puncture. Default BOUNDARY. */
  vtkSetClampMacro(Road, int, BOUNDARY, PUNCTURE);
  vtkGetMacro(Road, int);
  void SetRoadToBoundary() { this->SetRoad(BOUNDARY); }
  void SetRoadToPuncture() { this->SetRoad(PUNCTURE); }
  ///@}

  ///@{
  /** Face that the road PUNCTURE takes out; -1 = the one farthest from the boundary. Default -1. */
  vtkSetMacro(PuncturedFace, int);
  vtkGetMacro(PuncturedFace, int);
  ///@}

protected:
  vtkRiemannMap() = default;
  ~vtkRiemannMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int Road = BOUNDARY;
  int PuncturedFace = -1;

private:
  vtkRiemannMap(const vtkRiemannMap&) = delete;
  void operator=(const vtkRiemannMap&) = delete;
};

#endif
