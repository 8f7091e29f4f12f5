/**
 * @class vtkStretchEnergyMap
 * @brief Area-preserving, or measure-controlled, map of a topological disk as the fixed point of the stretch energy.
 *
 * Each round solves a Laplace equation with weights from the map before it. A method of the literature, to compare
 * with: vtkAuthalicMap is exact and never folds. See yueh2019 in docs/references.bib and authalic::stretchEnergyMap.
 * Ports and arrays: vtkDiskMapAlgorithm, and
 *
 * | port | what |
 * |---|---|
 * | input 1, optional | vtkPolyData: an initial map to the same domain, vertices in the order of input 0 |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | field | Residuals | 1 double each | | sqrt(sum m (r - 1)^2) over faces before each round, and at the end |
 *
 * Status is converged when a round lowered the residual by less than the tolerance and nothing is folded, stalled when
 * a round raised it.
 *
 * @sa vtkStretchMinimisation vtkAuthalicMap
 */
#ifndef vtkStretchEnergyMap_h
#define vtkStretchEnergyMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkDiskMapAlgorithm.h"

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkStretchEnergyMap : public vtkDiskMapAlgorithm
{
public:
  static vtkStretchEnergyMap* New();
  vtkTypeMacro(vtkStretchEnergyMap, vtkDiskMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum InitialMethodType
  {
    TUTTE = 0,
    HARMONIC = 1,
    MEAN_VALUE = 2
  };
  enum BoundaryType
  {
    INVERTED = 0,
    HELD = 1
  };

  ///@{
  /** The initial map when input port 1 is empty. Default HARMONIC, as in the paper. */
  vtkSetClampMacro(InitialMethod, int, TUTTE, MEAN_VALUE);
  vtkGetMacro(InitialMethod, int);
  void SetInitialMethodToTutte() { this->SetInitialMethod(TUTTE); }
  void SetInitialMethodToHarmonic() { this->SetInitialMethod(HARMONIC); }
  void SetInitialMethodToMeanValue() { this->SetInitialMethod(MEAN_VALUE); }
  ///@}

  ///@{
  /** Whether the boundary follows from the inversion of the inner vertices, which only a disk has, or stays where the
   * initial map has it. Default: authalic::StretchEnergyMapOptions, as below. */
  vtkSetClampMacro(Boundary, int, INVERTED, HELD);
  vtkGetMacro(Boundary, int);
  void SetBoundaryToInverted() { this->SetBoundary(INVERTED); }
  void SetBoundaryToHeld() { this->SetBoundary(HELD); }
  ///@}

  ///@{
  /** Part by which a round must lower the residual to be followed by another one, > 0. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Most rounds, 0 or more. */
  vtkSetClampMacro(MaximumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

protected:
  vtkStretchEnergyMap();
  ~vtkStretchEnergyMap() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int InitialMethod = HARMONIC;
  int Boundary;
  double Tolerance;
  int MaximumIterations;

private:
  vtkStretchEnergyMap(const vtkStretchEnergyMap&) = delete;
  void operator=(const vtkStretchEnergyMap&) = delete;
};

#endif
