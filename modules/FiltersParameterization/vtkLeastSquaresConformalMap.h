/**
 * @class vtkLeastSquaresConformalMap
 * @brief Maps a topological disk with a free boundary so that the conformal energy is least (LSCM).
 *
 * Minimises E_D − A, the Dirichlet energy less the area of the image. The boundary takes the shape that distorts
 * angles least; parts of it may overlap, and faces may fold: they are counted. The image has the area of the surface
 * (mm²), its centroid at 0, and the second pin to the right of the first. Ports and arrays: see
 * vtkSurfaceMapAlgorithm; further field data:
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | Method | 1 string | lscm |
 * | field | Residuals | 1 double each | SPECTRAL: change of the boundary per iteration, of its mean radius |
 * | field | ConformalEnergy | 1 double | (E_D − A)/A of the image: 0 for a similarity on every face |
 * | field | FirstPin, SecondPin | 1 int | boundary vertices that were held (SPECTRAL: that fix the rotation) |
 *
 * See levy2002 and mullen2008 in docs/references.bib, and docs/methods/lscm.md.
 *
 * @sa vtkSymmetricDirichletMap vtkRiemannMap vtkBarycentricMap
 */
#ifndef vtkLeastSquaresConformalMap_h
#define vtkLeastSquaresConformalMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceMapAlgorithm.h"

namespace authalic
{
struct LeastSquaresConformalMapOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkLeastSquaresConformalMap : public vtkSurfaceMapAlgorithm
{
public:
  static vtkLeastSquaresConformalMap* New();
  vtkTypeMacro(vtkLeastSquaresConformalMap, vtkSurfaceMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PinsType
  {
    TWO_VERTICES = 0,
    SPECTRAL = 1
  };

  ///@{
  /**
   * What keeps the map from shrinking to a point: two boundary vertices held at their distance (one linear solve), or a
   * boundary of mean 0 and mean square 1 (an eigenproblem; no vertex is special). Default:
   * authalic::LeastSquaresConformalMapOptions, as below.
   */
  vtkSetClampMacro(Pins, int, TWO_VERTICES, SPECTRAL);
  vtkGetMacro(Pins, int);
  void SetPinsToTwoVertices() { this->SetPins(TWO_VERTICES); }
  void SetPinsToSpectral() { this->SetPins(SPECTRAL); }
  ///@}

  ///@{
  /** Boundary vertices; -1 (both) = the two that are farthest apart in space. SPECTRAL: they only fix the rotation. */
  vtkSetMacro(FirstPin, int);
  vtkGetMacro(FirstPin, int);
  vtkSetMacro(SecondPin, int);
  vtkGetMacro(SecondPin, int);
  ///@}

  ///@{
  /** SPECTRAL: change of the boundary in one iteration, of its mean radius, > 0. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** SPECTRAL: most iterations, 0 or more. */
  vtkSetClampMacro(MaximumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

protected:
  vtkLeastSquaresConformalMap();
  ~vtkLeastSquaresConformalMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int Pins;
  int FirstPin;
  int SecondPin;
  double Tolerance;
  int MaximumIterations;

private:
  authalic::LeastSquaresConformalMapOptions Options() const;

  vtkLeastSquaresConformalMap(const vtkLeastSquaresConformalMap&) = delete;
  void operator=(const vtkLeastSquaresConformalMap&) = delete;
};

#endif
