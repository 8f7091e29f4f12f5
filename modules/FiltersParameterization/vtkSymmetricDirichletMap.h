/**
 * @class vtkSymmetricDirichletMap
 * @brief Locally injective map of a topological disk that is as isometric as it can be.
 *
 * Minimises the symmetric Dirichlet energy, that of scalable locally injective mappings (SLIM), by projected Newton
 * steps from an unfolded map of the disk; no face of the image is ever folded.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: connected, oriented, manifold, genus 0, one boundary loop |
 * | input 1, optional | vtkPolyData, an unfolded planar map to start from: same vertices in the same order |
 * | output 0 | vtkPolyData, the map: see vtkSurfaceMapAlgorithm |
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | Method | 1 string | slim |
 * | field | Energy | 1 double | symmetric Dirichlet energy at the image's own scale; 4 for an isometry |
 *
 * See rabinovich2017 and smith2019 in docs/references.bib, and docs/methods/slim.md.
 *
 * @sa vtkLeastSquaresConformalMap vtkAuthalicMap
 */
#ifndef vtkSymmetricDirichletMap_h
#define vtkSymmetricDirichletMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceMapAlgorithm.h"

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkSymmetricDirichletMap : public vtkSurfaceMapAlgorithm
{
public:
  static vtkSymmetricDirichletMap* New();
  vtkTypeMacro(vtkSymmetricDirichletMap, vtkSurfaceMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BoundaryType
  {
    FREE = 0,
    FIXED = 1
  };
  enum InitialMethodType
  {
    TUTTE = 0,
    MEAN_VALUE = 1
  };

  ///@{
  /** Whether the boundary moves with the rest, or stays where the start has it. Default FREE. */
  vtkSetClampMacro(Boundary, int, FREE, FIXED);
  vtkGetMacro(Boundary, int);
  void SetBoundaryToFree() { this->SetBoundary(FREE); }
  void SetBoundaryToFixed() { this->SetBoundary(FIXED); }
  ///@}

  ///@{
  /** The map to the unit disk from which it starts when input port 1 is empty. Default TUTTE. */
  vtkSetClampMacro(InitialMethod, int, TUTTE, MEAN_VALUE);
  vtkGetMacro(InitialMethod, int);
  void SetInitialMethodToTutte() { this->SetInitialMethod(TUTTE); }
  void SetInitialMethodToMeanValue() { this->SetInitialMethod(MEAN_VALUE); }
  ///@}

  ///@{
  /** Of the Newton decrement relative to the energy, > 0. Default: of the Core options, as below. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Most Newton steps, 0 or more. */
  vtkSetClampMacro(MaximumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

protected:
  vtkSymmetricDirichletMap();
  ~vtkSymmetricDirichletMap() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int Boundary = FREE;
  int InitialMethod = TUTTE;
  double Tolerance;
  int MaximumIterations;

private:
  vtkSymmetricDirichletMap(const vtkSymmetricDirichletMap&) = delete;
  void operator=(const vtkSymmetricDirichletMap&) = delete;
};

#endif
