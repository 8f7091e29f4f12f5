/**
 * @class vtkStretchMinimisation
 * @brief Maps a topological disk with little stretch: a barycentric map whose weights are divided by the stretch.
 *
 * The boundary is spread over that of the domain by arc length and stays. Rounds go on until the stretch does not fall
 * any more. A method of the literature, to compare with; vtkAuthalicMap preserves areas. See yoshizawa2004 in
 * docs/references.bib and authalic::stretchMinimisation. Ports and arrays: vtkDiskMapAlgorithm, and
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | Residuals | 1 double each | stretch before each round, and at the end; 1 for an isometry |
 * | field | Stretch | 1 double | L2 stretch of the output |
 * | field | Pockets | 1 int | pieces that an inner edge cuts off at one straight side; they bulge out of it |
 *
 * Status is converged when a round did not lower the stretch and nothing is folded.
 *
 * @sa vtkStretchEnergyMap vtkBarycentricMap vtkAuthalicMap
 */
#ifndef vtkStretchMinimisation_h
#define vtkStretchMinimisation_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkDiskMapAlgorithm.h"

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkStretchMinimisation : public vtkDiskMapAlgorithm
{
public:
  static vtkStretchMinimisation* New();
  vtkTypeMacro(vtkStretchMinimisation, vtkDiskMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum WeightsType
  {
    TUTTE = 0,
    HARMONIC = 1,
    MEAN_VALUE = 2
  };

  ///@{
  /** The weights of the first map. Default: authalic::StretchMinimisationOptions, as below. */
  vtkSetClampMacro(Weights, int, TUTTE, MEAN_VALUE);
  vtkGetMacro(Weights, int);
  void SetWeightsToTutte() { this->SetWeights(TUTTE); }
  void SetWeightsToHarmonic() { this->SetWeights(HARMONIC); }
  void SetWeightsToMeanValue() { this->SetWeights(MEAN_VALUE); }
  ///@}

  ///@{
  /** Boundary vertex that goes to angle 0 of the disk or to corner 0; -1 = the one with the smallest id. */
  vtkSetMacro(StartVertex, int);
  vtkGetMacro(StartVertex, int);
  ///@}

  ///@{
  /** Most rounds, 0 or more. */
  vtkSetClampMacro(MaximumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

protected:
  vtkStretchMinimisation();
  ~vtkStretchMinimisation() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int Weights;
  int StartVertex;
  int MaximumIterations;

private:
  vtkStretchMinimisation(const vtkStretchMinimisation&) = delete;
  void operator=(const vtkStretchMinimisation&) = delete;
};

#endif
