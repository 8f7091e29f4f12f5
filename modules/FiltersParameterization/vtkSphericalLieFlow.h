/**
 * @class vtkSphericalLieFlow
 * @brief Area-preserving, or measure-controlled, map of a topological sphere by the discrete Lie flow.
 *
 * As vtkDiscreteLieFlow, with solid angles as the areas of the image. The start is a conformal map, or, where that is
 * too far from area-preserving, two balanced caps. The rotation is the one that brings the image closest to the
 * surface. See su2019 in docs/references.bib and authalic::sphericalLieFlow.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: closed, connected, oriented, manifold, genus 0 |
 * | input 1, optional | vtkPolyData, an initial map to the unit sphere: same vertices in the same order |
 * | output 0 | vtkPolyData, the map on the unit sphere: see vtkLieFlowAlgorithm |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | field | Coverage | 1 double | | Σ solid angles / 4π; 1 for a homeomorphism |
 * | field | FlatAreaDistortion | 1 double | | D_area of the flat triangles through the image's points |
 * | field | SphericalAngleError | 1 double | degrees | mean over corners of the spherical triangles |
 *
 * @sa vtkSphericalAuthalicMap
 */
#ifndef vtkSphericalLieFlow_h
#define vtkSphericalLieFlow_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkLieFlowAlgorithm.h"

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkSphericalLieFlow : public vtkLieFlowAlgorithm
{
public:
  static vtkSphericalLieFlow* New();
  vtkTypeMacro(vtkSphericalLieFlow, vtkLieFlowAlgorithm);

protected:
  vtkSphericalLieFlow();
  ~vtkSphericalLieFlow() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

private:
  vtkSphericalLieFlow(const vtkSphericalLieFlow&) = delete;
  void operator=(const vtkSphericalLieFlow&) = delete;
};

#endif
