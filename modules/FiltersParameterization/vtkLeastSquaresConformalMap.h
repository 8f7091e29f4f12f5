/**
 * @class vtkLeastSquaresConformalMap
 * @brief Least-squares conformal map of a topological disk: free boundary, one sparse factorisation.
 *
 * Minimises the conformal energy, the Dirichlet energy less the area of the image, with two boundary vertices held or
 * (Spectral) the boundary's spread held. The image has the area of the surface. Faces may fold: see Flipped.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: connected, oriented, manifold, genus 0, one boundary loop |
 * | output 0 | vtkPolyData, the map: see vtkSurfaceMapAlgorithm |
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | Method | 1 string | lscm |
 * | field | ConformalEnergy | 1 double | (Dirichlet energy - area) / area of the image; 0 for a similarity |
 *
 * See levy2002 and mullen2008 in docs/references.bib, and docs/methods/lscm.md.
 *
 * @sa vtkSymmetricDirichletMap vtkRiemannMap
 */
#ifndef vtkLeastSquaresConformalMap_h
#define vtkLeastSquaresConformalMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceMapAlgorithm.h"

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
  /** What keeps the map from shrinking to a point. Default TWO_VERTICES. */
  vtkSetClampMacro(Pins, int, TWO_VERTICES, SPECTRAL);
  vtkGetMacro(Pins, int);
  void SetPinsToTwoVertices() { this->SetPins(TWO_VERTICES); }
  void SetPinsToSpectral() { this->SetPins(SPECTRAL); }
  ///@}

  ///@{
  /** Boundary vertices; -1 (both): the two farthest apart in space. With SPECTRAL they fix the rotation. Default -1. */
  vtkSetMacro(FirstPin, int);
  vtkGetMacro(FirstPin, int);
  vtkSetMacro(SecondPin, int);
  vtkGetMacro(SecondPin, int);
  ///@}

  ///@{
  /** Spectral: change of the boundary in one iteration, relative, > 0. Default: of the Core options, as below. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Spectral: most iterations, 0 or more. */
  vtkSetClampMacro(MaximumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

protected:
  vtkLeastSquaresConformalMap();
  ~vtkLeastSquaresConformalMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int Pins = TWO_VERTICES;
  int FirstPin = -1;
  int SecondPin = -1;
  double Tolerance;
  int MaximumIterations;

private:
  vtkLeastSquaresConformalMap(const vtkLeastSquaresConformalMap&) = delete;
  void operator=(const vtkLeastSquaresConformalMap&) = delete;
};

#endif
