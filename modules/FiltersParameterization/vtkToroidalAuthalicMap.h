/**
 * @class vtkToroidalAuthalicMap
 * @brief Area-preserving, or measure-controlled, map of a torus to a flat torus: exact at every vertex, no seam.
 *
 * As vtkAuthalicMap, on the plane modulo a lattice that is found with the map: every star is whole and gets exactly its
 * share. The output is the torus cut open along its shortest loops; the two sides of the cut differ by periods. The
 * vertices of the input come first, in their order, then their copies.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: closed, connected, oriented, manifold, genus 1 |
 * | output 0 | vtkPolyData, the map of area 1: faces in the order of the input; see vtkAreaSolveAlgorithm |
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | point | OriginalPointIds | 1 vtkIdType | point of the input |
 * | field | Method | 1 string | authalic |
 * | field | Periods | 4 × 1 double | x, y of the first period (y = 0), x, y of the second; determinant 1 |
 * | field | SeamError | 1 double | largest difference of an edge of the cut as seen from its two sides |
 *
 * See zou2011 and gortler2006 in docs/references.bib, and docs/methods/authalic-map.md.
 *
 * @sa vtkAuthalicMap vtkSphericalAuthalicMap
 */
#ifndef vtkToroidalAuthalicMap_h
#define vtkToroidalAuthalicMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkAreaSolveAlgorithm.h"

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkToroidalAuthalicMap : public vtkAreaSolveAlgorithm
{
public:
  static vtkToroidalAuthalicMap* New();
  vtkTypeMacro(vtkToroidalAuthalicMap, vtkAreaSolveAlgorithm);

protected:
  vtkToroidalAuthalicMap() = default;
  ~vtkToroidalAuthalicMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

private:
  vtkToroidalAuthalicMap(const vtkToroidalAuthalicMap&) = delete;
  void operator=(const vtkToroidalAuthalicMap&) = delete;
};

#endif
