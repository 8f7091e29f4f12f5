/**
 * @class vtkYamabeMap
 * @brief Conformal map of a topological disk to a disk, or to the planar domain whose boundary turns as prescribed.
 *
 * Looks for the scale factors u for which the lengths l_ij e^{(u_i + u_j)/2} are flat inside and the boundary has the
 * curvature of a circle, or that of CurvatureArrayName; the flat metric is developed into the plane. The image has
 * the area of the surface (mm²), its area centroid at 0, and the start vertex on the positive x axis. With prescribed
 * curvature the image may overlap itself: curvature says how the boundary turns, not where it goes. A vertex turns by
 * its K̄: corners of a rectangle by π/2, straight sides by 0; over the boundary the sum is 2π.
 *
 * The map is one-to-one on the flow's own Delaunay triangulation. Faces of the input whose edges were flipped away
 * may fold: they are counted, unfolded, and on output 1, on request, cut along the edges of that triangulation.
 *
 * Where the flow does not reach the tolerance the image comes with Status stalled or not-converged, a warning, and
 * ErrorKind NOT_CONVERGED. Ports and arrays: see vtkCurvatureFlowMapAlgorithm and vtkSurfaceMapAlgorithm; also
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | point | Curvature | 1 double | radians | K reached |
 * | field | AddedVertices | 1 int | | vertices by which the flow split boundary edges; not part of the image |
 *
 * See luo2004, springborn2008, gu2018 and su2016 in docs/references.bib, and docs/methods/yamabe-flow.md.
 *
 * @sa vtkRiemannMap vtkLeastSquaresConformalMap
 */
#ifndef vtkYamabeMap_h
#define vtkYamabeMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkCurvatureFlowMapAlgorithm.h"

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkYamabeMap : public vtkCurvatureFlowMapAlgorithm
{
public:
  static vtkYamabeMap* New();
  vtkTypeMacro(vtkYamabeMap, vtkCurvatureFlowMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Point array with the target curvature, radians: 0 at inner vertices, less than π on the boundary, 2π in all.
   * Empty = the boundary becomes a circle. Default empty.
   */
  vtkSetMacro(CurvatureArrayName, std::string);
  vtkGetMacro(CurvatureArrayName, std::string);
  ///@}

protected:
  vtkYamabeMap() = default;
  ~vtkYamabeMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  std::string CurvatureArrayName;

private:
  vtkYamabeMap(const vtkYamabeMap&) = delete;
  void operator=(const vtkYamabeMap&) = delete;
};

#endif
