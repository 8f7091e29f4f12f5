/**
 * @class vtkLieAdvection
 * @brief Area-preserving, or measure-controlled, map of a topological disk by Lie advection in a given number of
 * steps.
 *
 * Advects the area form of the plane to that of the surface in NumberOfSteps steps, each of which takes an equal
 * part of what is left of the error; then unfolds faces of the input that are folded. A method of the literature:
 * vtkAuthalicMap is exact. See zou2011 in docs/references.bib and authalic::lieAdvection. Ports and arrays:
 * vtkDiskMapAlgorithm, and
 *
 * | port | what |
 * |---|---|
 * | input 1, optional | vtkPolyData: an initial map to the same domain, vertices in the order of input 0 |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | field | Residuals | 1 double each | | sqrt(sum m (r - 1)^2) over vertex stars before each step, and at the end |
 * | field | ShortenedSteps, FlippedBeforeUnfolding, EdgeFlips | 1 int | | |
 *
 * Status is converged when every step was taken in full and nothing is folded.
 *
 * @sa vtkDiscreteLieFlow vtkAuthalicMap
 */
#ifndef vtkLieAdvection_h
#define vtkLieAdvection_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkDiskMapAlgorithm.h"

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkLieAdvection : public vtkDiskMapAlgorithm
{
public:
  static vtkLieAdvection* New();
  vtkTypeMacro(vtkLieAdvection, vtkDiskMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum InitialMethodType
  {
    TUTTE = 0,
    HARMONIC = 1,
    MEAN_VALUE = 2
  };

  ///@{
  /** The initial map when input port 1 is empty. Default HARMONIC, nearly conformal as in the paper. */
  vtkSetClampMacro(InitialMethod, int, TUTTE, MEAN_VALUE);
  vtkGetMacro(InitialMethod, int);
  void SetInitialMethodToTutte() { this->SetInitialMethod(TUTTE); }
  void SetInitialMethodToHarmonic() { this->SetInitialMethod(HARMONIC); }
  void SetInitialMethodToMeanValue() { this->SetInitialMethod(MEAN_VALUE); }
  ///@}

  ///@{
  /** Steps, 1 or more. Default: authalic::LieAdvectionOptions, as below. */
  vtkSetClampMacro(NumberOfSteps, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfSteps, int);
  ///@}

  ///@{
  /** Whether faces of the input that are folded at the end are unfolded. */
  vtkSetMacro(Unfold, bool);
  vtkGetMacro(Unfold, bool);
  vtkBooleanMacro(Unfold, bool);
  ///@}

protected:
  vtkLieAdvection();
  ~vtkLieAdvection() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int InitialMethod = HARMONIC;
  int NumberOfSteps;
  bool Unfold;

private:
  vtkLieAdvection(const vtkLieAdvection&) = delete;
  void operator=(const vtkLieAdvection&) = delete;
};

#endif
