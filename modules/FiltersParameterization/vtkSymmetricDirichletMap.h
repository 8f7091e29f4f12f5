/**
 * @class vtkSymmetricDirichletMap
 * @brief Locally injective map of a topological disk that is as isometric as it can be (the energy of SLIM).
 *
 * Minimises the symmetric Dirichlet energy Σ ρ (σ1² + σ1⁻² + σ2² + σ2⁻²), 4 for an isometry, from a start without
 * folded faces: a barycentric map to Domain, or a given map. No face of the image is folded; distant parts of a free
 * boundary may overlap. FREE: the image is in mm, its centroid at 0, the two boundary vertices that are farthest
 * apart along x. FIXED: the boundary stays where the start has it, on that of Domain or of the given map. Where the
 * tolerance is not reached the best map comes with Status not-converged or stalled, a warning, and ErrorKind
 * NOT_CONVERGED.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: see vtkDiskMapAlgorithm |
 * | input 1, optional | vtkPolyData, an initial map in the plane without folded faces: same vertices in the same order; Domain and InitialMethod are not read then |
 * | output 0 | vtkPolyData, the map: see vtkSurfaceMapAlgorithm |
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | Method | 1 string | slim |
 * | field | Residuals | 1 double each | Newton decrement √(gᵀH⁻¹g / E) per iteration |
 * | field | IsometricEnergy | 1 double | E of the image |
 *
 * See rabinovich2017 and smith2019 in docs/references.bib, and docs/methods/slim.md.
 *
 * @sa vtkLeastSquaresConformalMap vtkBarycentricMap
 */
#ifndef vtkSymmetricDirichletMap_h
#define vtkSymmetricDirichletMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkDiskMapAlgorithm.h"

namespace authalic
{
struct BarycentricMapResult;
class DiskMesh;
struct SymmetricDirichletMapOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkSymmetricDirichletMap : public vtkDiskMapAlgorithm
{
public:
  static vtkSymmetricDirichletMap* New();
  vtkTypeMacro(vtkSymmetricDirichletMap, vtkDiskMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BoundaryType
  {
    FREE = 0,
    FIXED = 1
  };
  enum InitialMethodType
  {
    TUTTE = 0,
    HARMONIC = 1,
    MEAN_VALUE = 2
  };

  ///@{
  /** What the boundary may do. Default: authalic::SymmetricDirichletMapOptions, as below. */
  vtkSetClampMacro(Boundary, int, FREE, FIXED);
  vtkGetMacro(Boundary, int);
  void SetBoundaryToFree() { this->SetBoundary(FREE); }
  void SetBoundaryToFixed() { this->SetBoundary(FIXED); }
  ///@}

  ///@{
  /** The start when input port 1 is empty. HARMONIC may fold and is then refused. Default TUTTE. */
  vtkSetClampMacro(InitialMethod, int, TUTTE, MEAN_VALUE);
  vtkGetMacro(InitialMethod, int);
  void SetInitialMethodToTutte() { this->SetInitialMethod(TUTTE); }
  void SetInitialMethodToHarmonic() { this->SetInitialMethod(HARMONIC); }
  void SetInitialMethodToMeanValue() { this->SetInitialMethod(MEAN_VALUE); }
  ///@}

  ///@{
  /** Of the Newton decrement √(gᵀH⁻¹g / E), > 0. */
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

  int Boundary;
  int InitialMethod = TUTTE;
  double Tolerance;
  int MaximumIterations;

private:
  authalic::SymmetricDirichletMapOptions Options() const;
  authalic::BarycentricMapResult Start(const authalic::DiskMesh& disk, const authalic::Execution& execution) const;

  vtkSymmetricDirichletMap(const vtkSymmetricDirichletMap&) = delete;
  void operator=(const vtkSymmetricDirichletMap&) = delete;
};

#endif
