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
 * | output 0 | vtkPolyData, the map of area 1: faces in the order of the input; see vtkSurfaceMapAlgorithm |
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | point | OriginalPointIds | 1 vtkIdType | point of the input |
 * | field | Method | 1 string | authalic |
 * | field | FaceResidual | 1 double | (Σ m (r + 1/r − 2))^½ over faces, r = image share / target share |
 * | field | VertexResidual | 1 double | max of the absolute logarithm of r over whole vertex stars |
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
#include "vtkSurfaceMapAlgorithm.h"

namespace authalic
{
struct AuthalicMapOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkToroidalAuthalicMap : public vtkSurfaceMapAlgorithm
{
public:
  static vtkToroidalAuthalicMap* New();
  vtkTypeMacro(vtkToroidalAuthalicMap, vtkSurfaceMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Of the face residual (Σ m (r + 1/r − 2))^½ = (D_area − 2)^½, > 0. Default: authalic::AuthalicMapOptions,
   * as below. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Of max |ln r| over vertex stars, > 0. */
  vtkSetMacro(VertexTolerance, double);
  vtkGetMacro(VertexTolerance, double);
  ///@}

  ///@{
  /** Most steps of both kinds, 0 or more. */
  vtkSetClampMacro(MaximumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

protected:
  vtkToroidalAuthalicMap();
  ~vtkToroidalAuthalicMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  double Tolerance;
  double VertexTolerance;
  int MaximumIterations;

private:
  authalic::AuthalicMapOptions Options() const;

  vtkToroidalAuthalicMap(const vtkToroidalAuthalicMap&) = delete;
  void operator=(const vtkToroidalAuthalicMap&) = delete;
};

#endif
