/**
 * @class vtkYamabeMap
 * @brief Conformal map of a topological disk to the plane with a prescribed curvature of its boundary.
 *
 * Finds the flat metric in the discrete conformal class of the surface whose boundary turns as asked, by the dynamic
 * Yamabe flow with Newton's method, and lays it out. Without CurvatureArrayName the boundary becomes a circle.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: connected, oriented, manifold, genus 0, one boundary loop |
 * | output 0 | vtkPolyData, the map, as large in area as the surface: see vtkConformalFlowAlgorithm |
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | point | LogScaleFactor | 1 double | u: lengths of the image's metric are l_ij exp((u_i + u_j)/2) |
 * | point | Curvature | 1 double | K reached, radians |
 * | field | Method | 1 string | yamabe |
 *
 * See su2016 and springborn2008 in docs/references.bib, and docs/methods/yamabe-flow.md.
 *
 * @sa vtkRiemannMap vtkCircleDomainMap
 */
#ifndef vtkYamabeMap_h
#define vtkYamabeMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkConformalFlowAlgorithm.h"

#include <string> // for CurvatureArrayName

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkYamabeMap : public vtkConformalFlowAlgorithm
{
public:
  static vtkYamabeMap* New();
  vtkTypeMacro(vtkYamabeMap, vtkConformalFlowAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Point array of target curvatures: 0 at inner vertices, turning angles (radians) along the boundary that sum to
   * 2 pi. Empty: a circle. Default empty.
   */
  vtkSetMacro(CurvatureArrayName, std::string);
  vtkGetMacro(CurvatureArrayName, std::string);
  ///@}

  ///@{
  /** Boundary vertex on the positive x axis; -1 = the one with the smallest id. Default -1. */
  vtkSetMacro(StartVertex, int);
  vtkGetMacro(StartVertex, int);
  ///@}

  ///@{
  /** As vtkUnitDiskConformalAlgorithm::Refine. Default off. */
  vtkSetMacro(Refine, bool);
  vtkGetMacro(Refine, bool);
  vtkBooleanMacro(Refine, bool);
  ///@}

protected:
  vtkYamabeMap() = default;
  ~vtkYamabeMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  std::string CurvatureArrayName;
  int StartVertex = -1;
  bool Refine = false;

private:
  vtkYamabeMap(const vtkYamabeMap&) = delete;
  void operator=(const vtkYamabeMap&) = delete;
};

#endif
