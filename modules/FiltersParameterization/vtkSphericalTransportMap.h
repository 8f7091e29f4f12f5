/**
 * @class vtkSphericalTransportMap
 * @brief Area-preserving, or measure-controlled, map of a topological sphere to the unit sphere by optimal transport.
 *
 * As vtkOptimalTransportMap, with the cost −ln cos d of great-circle distances d: cells are bounded by great circles
 * and have exactly the solid angles that their vertices shall have. The sites are the conformal map, or a given one.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: closed, connected, oriented, manifold, genus 0 |
 * | input 1, optional | vtkPolyData, an initial map to the unit sphere: same vertices in the same order |
 * | output 0 | vtkPolyData, the map on the unit sphere: see vtkSurfaceMapAlgorithm |
 * | output 1 | vtkPolyData, the cells: one polygon per vertex, sides with a corner every 0.05 radians |
 *
 * | port | association | name | components, type | meaning |
 * |---|---|---|---|---|
 * | 0 | point | Site | 3 double | y_i: the initial map |
 * | 0 | point | CellArea | 1 double | solid angle of the cell |
 * | 0 | point | Potential | 1 double | u at the image, u(x) = max over i of ln⟨x, y_i⟩ + h_i; STEREOGRAPHIC: ⟨x, z_i⟩ + h_i in the plane |
 * | 0 | field | Method | 1 string | transport; balanced with a balance |
 * | 0 | field | Balance | 1 double | as set; without BalanceArrayName |
 * | 0 | field | TransportResidual | 1 double | max of the absolute difference of cell area and target / mean target |
 * | 0 | field | TransportCost | 1 double | Σ ∫ over cells of −ln cos d to the site; not with STEREOGRAPHIC, whose cost is infinite |
 * | 0 | field | DisplacementCost | 1 double | Σ ν times squared great-circle distance of image and site, before the finish |
 * | 0 | field | FinishedCost | 1 double | the same after it, when there is one |
 * | 0 | field | FlippedBeforeFinish | 1 int | folded faces before it, when there is one |
 * | 0 | field | EmptyCells | 1 int | 0 |
 * | 0 | field | Pole | 3 double | STEREOGRAPHIC: of the projection, a unit vector |
 * | 1 | cell | SiteIds | 1 id | vertex of the cell |
 * | 1 | cell | Area | 1 double | exact |
 *
 * See oliker2007, kitagawa2019 and nadeem2017 in docs/references.bib, and docs/methods/optimal-transport.md.
 *
 * @sa vtkOptimalTransportMap vtkSphericalAuthalicMap vtkSphericalConformalMap
 */
#ifndef vtkSphericalTransportMap_h
#define vtkSphericalTransportMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceMapAlgorithm.h"

#include <string> // for BalanceArrayName

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkSphericalTransportMap : public vtkSurfaceMapAlgorithm
{
public:
  static vtkSphericalTransportMap* New();
  vtkTypeMacro(vtkSphericalTransportMap, vtkSurfaceMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FinishType
  {
    NO_FINISH = 0,
    AUTHALIC = 1
  };

  enum FormulationType
  {
    SPHERICAL = 0,
    STEREOGRAPHIC = 1
  };

  ///@{
  /** SPHERICAL: on the sphere itself. STEREOGRAPHIC: in the plane of a projection. Default SPHERICAL. */
  vtkSetClampMacro(Formulation, int, SPHERICAL, STEREOGRAPHIC);
  vtkGetMacro(Formulation, int);
  void SetFormulationToSpherical() { this->SetFormulation(SPHERICAL); }
  void SetFormulationToStereographic() { this->SetFormulation(STEREOGRAPHIC); }
  ///@}

  ///@{
  /**
   * Pole of the projection of STEREOGRAPHIC, of any length, in the space of the initial map; 0 0 0: the middle of the
   * largest face of that map. Default 0 0 0.
   */
  vtkSetVector3Macro(Pole, double);
  vtkGetVector3Macro(Pole, double);
  ///@}

  ///@{
  /** Of max |cell area − target| / mean target, > 0. Default: authalic::SphericalTransportMapOptions, as below. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Most Newton steps, 0 or more. */
  vtkSetClampMacro(MaximumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  ///@{
  /** AUTHALIC: remove folds and area errors afterwards, with the defaults of vtkSphericalAuthalicMap. Default
   * NO_FINISH. */
  vtkSetClampMacro(Finish, int, NO_FINISH, AUTHALIC);
  vtkGetMacro(Finish, int);
  void SetFinishToNone() { this->SetFinish(NO_FINISH); }
  void SetFinishToAuthalic() { this->SetFinish(AUTHALIC); }
  ///@}

  ///@{
  /**
   * Weight of the areas, 0 to 1: the masses are (1 - Balance) × the areas of the conformal map + Balance × the measure,
   * and below 1 the sites are that map. 1 = area-preserving, 0 = conformal. Default 1.
   */
  vtkSetClampMacro(Balance, double, 0.0, 1.0);
  vtkGetMacro(Balance, double);
  ///@}

  ///@{
  /**
   * Point array of weights, 0 to 1 at every vertex, that takes the place of Balance: the balance from place to place.
   * Empty = Balance everywhere. Default empty.
   */
  vtkSetMacro(BalanceArrayName, std::string);
  vtkGetMacro(BalanceArrayName, std::string);
  ///@}

protected:
  vtkSphericalTransportMap();
  ~vtkSphericalTransportMap() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  double Tolerance;
  int MaximumIterations;
  int Finish = NO_FINISH;
  int Formulation;
  double Pole[3] = {0.0, 0.0, 0.0};
  double Balance = 1.0;
  std::string BalanceArrayName;

private:
  vtkSphericalTransportMap(const vtkSphericalTransportMap&) = delete;
  void operator=(const vtkSphericalTransportMap&) = delete;
};

#endif
