/**
 * @class vtkAuthalicMap
 * @brief Area-preserving, or measure-controlled, map of a topological disk: exact at every vertex, no face folded.
 *
 * Starts from Tutte's map (or a given one), matches the areas of the faces by damped Gauss–Newton steps, and then
 * those of the vertex stars to machine precision by Newton steps. Every vertex has exactly its share of the domain;
 * faces have theirs up to Tolerance. When the tolerances are not reached the best map comes with Status
 * not-converged or stalled, a warning, and ErrorKind NOT_CONVERGED.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: see vtkDiskMapAlgorithm |
 * | input 1, optional | vtkPolyData, an initial map to the same domain: same vertices in the same order |
 * | output 0 | vtkPolyData, the map: see vtkSurfaceMapAlgorithm |
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | Method | 1 string | authalic |
 * | field | Balance | 1 double | as set; without BalanceArrayName |
 * | field | FaceResidual | 1 double | (Σ m (r + 1/r − 2))^½ over faces, r = image share / target share |
 * | field | VertexResidual | 1 double | max of the absolute logarithm of r over vertex stars |
 *
 * See zou2011 and su2019 in docs/references.bib, and docs/methods/authalic-map.md.
 *
 * @sa vtkDiscreteLieFlow vtkBarycentricMap vtkElementGrid
 */
#ifndef vtkAuthalicMap_h
#define vtkAuthalicMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkDiskMapAlgorithm.h"

#include <string> // for BalanceArrayName

namespace authalic
{
struct AuthalicMapOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkAuthalicMap : public vtkDiskMapAlgorithm
{
public:
  static vtkAuthalicMap* New();
  vtkTypeMacro(vtkAuthalicMap, vtkDiskMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum InitialMethodType
  {
    TUTTE = 0,
    HARMONIC = 1,
    MEAN_VALUE = 2
  };

  ///@{
  /** The initial map when input port 1 is empty. Default TUTTE. */
  vtkSetClampMacro(InitialMethod, int, TUTTE, MEAN_VALUE);
  vtkGetMacro(InitialMethod, int);
  void SetInitialMethodToTutte() { this->SetInitialMethod(TUTTE); }
  void SetInitialMethodToHarmonic() { this->SetInitialMethod(HARMONIC); }
  void SetInitialMethodToMeanValue() { this->SetInitialMethod(MEAN_VALUE); }
  ///@}

  ///@{
  /**
   * Weight of the areas, 0 to 1: the target is (1 - Balance) × the areas of the Riemann map + Balance × the
   * measure, and below 1 the solve starts from that map. 1 = area-preserving, 0 = conformal. Domain DISK only when
   * below 1. Default 1.
   */
  vtkSetClampMacro(Balance, double, 0.0, 1.0);
  vtkGetMacro(Balance, double);
  ///@}

  ///@{
  /**
   * Point array of weights, 0 to 1 at every vertex, that takes the place of Balance: the balance from place to place.
   * Empty = Balance everywhere. Domain DISK only. Default empty.
   */
  vtkSetMacro(BalanceArrayName, std::string);
  vtkGetMacro(BalanceArrayName, std::string);
  ///@}

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
  vtkAuthalicMap();
  ~vtkAuthalicMap() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int InitialMethod = TUTTE;
  double Balance = 1.0;
  std::string BalanceArrayName;
  double Tolerance;
  double VertexTolerance;
  int MaximumIterations;

private:
  authalic::AuthalicMapOptions Options() const;

  vtkAuthalicMap(const vtkAuthalicMap&) = delete;
  void operator=(const vtkAuthalicMap&) = delete;
};

#endif
