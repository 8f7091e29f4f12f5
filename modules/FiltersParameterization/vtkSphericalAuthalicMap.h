/**
 * @class vtkSphericalAuthalicMap
 * @brief Area-preserving, or measure-controlled, map of a topological sphere: exact at every vertex, no face folded.
 *
 * As vtkAuthalicMap, with solid angles as the areas of the image: the vertex stars of the surface get exactly their
 * shares of the unit sphere. The rotation is the one that brings the image closest to the surface.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: closed, connected, oriented, manifold, genus 0 |
 * | input 1, optional | vtkPolyData, an initial map to the unit sphere: same vertices in the same order |
 * | output 0 | vtkPolyData, the map on the unit sphere: see vtkAreaSolveAlgorithm |
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | Method | 1 string | authalic |
 * | field | Balance | 1 double | as set; without BalanceArrayName |
 * | field | Coverage | 1 double | Σ solid angles / 4π; 1 for a homeomorphism |
 * | field | FlatAreaDistortion | 1 double | D_area of the flat triangles through the image's points |
 * | field | SphericalAngleError | 1 double | degrees, mean over corners, of the spherical triangles |
 *
 * See zou2011 and su2019 in docs/references.bib, and docs/methods/authalic-map.md.
 *
 * @sa vtkAuthalicMap
 */
#ifndef vtkSphericalAuthalicMap_h
#define vtkSphericalAuthalicMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkAreaSolveAlgorithm.h"

#include <string> // for BalanceArrayName

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkSphericalAuthalicMap : public vtkAreaSolveAlgorithm
{
public:
  static vtkSphericalAuthalicMap* New();
  vtkTypeMacro(vtkSphericalAuthalicMap, vtkAreaSolveAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Weight of the areas, 0 to 1: the target is (1 - Balance) × the areas of the conformal map (vtkSphericalConformalMap
   * with its defaults) + Balance × the measure. 1 = area-preserving, 0 = conformal. Default 1.
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
  vtkSphericalAuthalicMap();
  ~vtkSphericalAuthalicMap() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  double Balance = 1.0;
  std::string BalanceArrayName;

private:
  vtkSphericalAuthalicMap(const vtkSphericalAuthalicMap&) = delete;
  void operator=(const vtkSphericalAuthalicMap&) = delete;
};

#endif
