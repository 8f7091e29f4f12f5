/**
 * @class vtkBarycentricMap
 * @brief Maps a topological disk so that every inner vertex is the weighted mean of its neighbours.
 *
 * The boundary is spread over that of the domain by arc length. TUTTE (weights 1) looks at the connectivity alone and
 * is the safest start; HARMONIC (cotangent weights) has low angle distortion but may fold; MEAN_VALUE is nearly
 * harmonic and, on convex domains, never folds. Ports and arrays: see vtkDiskMapAlgorithm; further field data:
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | Method | 1 string | tutte, harmonic, mean-value |
 * | field | Pockets | 1 int | pieces that an inner edge cuts off at one straight side; they bulge out of it |
 *
 * See tutte1963, pinkall1993, floater2003 in docs/references.bib. Not for closed surfaces: vtkCutToDisk comes first.
 *
 * @sa vtkDiscreteLieFlow vtkCutToDisk vtkMapDistortion
 */
#ifndef vtkBarycentricMap_h
#define vtkBarycentricMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkDiskMapAlgorithm.h"

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkBarycentricMap : public vtkDiskMapAlgorithm
{
public:
  static vtkBarycentricMap* New();
  vtkTypeMacro(vtkBarycentricMap, vtkDiskMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MethodType
  {
    TUTTE = 0,
    HARMONIC = 1,
    MEAN_VALUE = 2
  };

  ///@{
  /** The weights. Default: authalic::BarycentricMapOptions. */
  vtkSetClampMacro(Method, int, TUTTE, MEAN_VALUE);
  vtkGetMacro(Method, int);
  void SetMethodToTutte() { this->SetMethod(TUTTE); }
  void SetMethodToHarmonic() { this->SetMethod(HARMONIC); }
  void SetMethodToMeanValue() { this->SetMethod(MEAN_VALUE); }
  ///@}

  ///@{
  /** Boundary vertex that goes to angle 0 of the disk or to corner 0; -1 = the one with the smallest id. Default -1. */
  vtkSetMacro(StartVertex, int);
  vtkGetMacro(StartVertex, int);
  ///@}

protected:
  vtkBarycentricMap();
  ~vtkBarycentricMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int Method;
  int StartVertex;

private:
  vtkBarycentricMap(const vtkBarycentricMap&) = delete;
  void operator=(const vtkBarycentricMap&) = delete;
};

#endif
