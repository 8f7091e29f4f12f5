/**
 * @class vtkFlatConeAuthalicMap
 * @brief Area-preserving, or measure-controlled, map of a closed surface of genus 2 or more to a flat cone surface.
 *
 * As vtkToroidalAuthalicMap, for surfaces with more handles: these have no flat metric without cones. The curvature
 * sits in cones of angle 5π/2 (and some of 3π/2), found with the map; every other star is that of a plane and gets
 * exactly its share. The output is the surface cut open through the cones; the two sides of every seam differ by
 * one rigid motion. It is locally injective; as a whole it may lie in several layers. The vertices of the input
 * come first, in their order, then their copies.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: closed, connected, oriented, manifold, genus 2 or more |
 * | output 0 | vtkPolyData, the map of area 1: faces in the order of the input; see vtkAreaSolveAlgorithm |
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | point | OriginalPointIds | 1 vtkIdType | point of the input |
 * | point | ConeAngle | 1 double | angle around the vertex in the flat surface, radians: 2π, at cones 5π/2 or 3π/2 |
 * | field | Method | 1 string | authalic |
 * | field | SeamPairs | 3 × double | per vertex of every seam: number of the seam, point on one side, on the other |
 * | field | SeamMotions | 3 × double | per seam: angle (radians), x and y of the motion x ↦ R x + t from side to side |
 * | field | SeamError | 1 double | largest distance of the two sides of a seam after its motion |
 * | field | AngleError | 1 double | largest difference of the angles around a vertex from its ConeAngle, radians |
 *
 * See zou2011 and springborn2008 in docs/references.bib, and docs/methods/authalic-high-genus.md.
 *
 * @sa vtkAuthalicMap vtkSphericalAuthalicMap vtkToroidalAuthalicMap
 */
#ifndef vtkFlatConeAuthalicMap_h
#define vtkFlatConeAuthalicMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkAreaSolveAlgorithm.h"

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkFlatConeAuthalicMap : public vtkAreaSolveAlgorithm
{
public:
  static vtkFlatConeAuthalicMap* New();
  vtkTypeMacro(vtkFlatConeAuthalicMap, vtkAreaSolveAlgorithm);

protected:
  vtkFlatConeAuthalicMap() = default;
  ~vtkFlatConeAuthalicMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

private:
  vtkFlatConeAuthalicMap(const vtkFlatConeAuthalicMap&) = delete;
  void operator=(const vtkFlatConeAuthalicMap&) = delete;
};

#endif
