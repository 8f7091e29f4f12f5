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
 * | output 0 | vtkPolyData, the map on the unit sphere: see vtkSurfaceMapAlgorithm |
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | Method | 1 string | authalic |
 * | field | FaceResidual | 1 double | (Σ m (r + 1/r − 2))^½ over faces, r = solid angle share / target share |
 * | field | VertexResidual | 1 double | max of the absolute logarithm of r over vertex stars |
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
#include "vtkSurfaceMapAlgorithm.h"

namespace authalic
{
struct AuthalicMapOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkSphericalAuthalicMap : public vtkSurfaceMapAlgorithm
{
public:
  static vtkSphericalAuthalicMap* New();
  vtkTypeMacro(vtkSphericalAuthalicMap, vtkSurfaceMapAlgorithm);
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
  vtkSphericalAuthalicMap();
  ~vtkSphericalAuthalicMap() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  double Tolerance;
  double VertexTolerance;
  int MaximumIterations;

private:
  authalic::AuthalicMapOptions Options() const;

  vtkSphericalAuthalicMap(const vtkSphericalAuthalicMap&) = delete;
  void operator=(const vtkSphericalAuthalicMap&) = delete;
};

#endif
