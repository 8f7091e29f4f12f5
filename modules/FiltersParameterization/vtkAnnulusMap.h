/**
 * @class vtkAnnulusMap
 * @brief Conformal map of a surface with two boundary loops onto a ring, or onto a periodic rectangle.
 *
 * The flow makes the surface a flat cylinder; it is cut along a shortest path and laid out. ANNULUS: the exponential of
 * it, a ring with the unit circle outside. RECTANGLE: periodic in x with period 1, y from 0 on the outer loop to the
 * modulus on the inner one. The rectangle is open along the cut: the vertices of the input come first, then those on
 * the other side of the cut, shifted by exactly 1. A long tube has a tiny inner circle: look at its rectangle.
 *
 * Folded faces and non-convergence: as in vtkYamabeMap; pockets of the boundary bulge out of circles and lines. Input 0
 * must be connected, oriented, manifold, of genus 0 and have two boundary loops. Ports and arrays: see
 * vtkCurvatureFlowMapAlgorithm (the factors of LogScale hold to second order in the edge length on the ring; Refine is
 * for the ring only) and vtkSurfaceMapAlgorithm; also
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | point | OriginalPointIds (as RECTANGLE) | 1 vtkIdType | | vertex of the input |
 * | field | ConformalModulus | 1 double | | (1/2π) ln(R/r) = Height / Circumference |
 * | field | Height, Circumference | 1 double | mm | of a flat cylinder of the modulus and as large as the surface |
 * | field | InnerRadius | 1 double | | r, with R = 1 |
 * | field | Straightness | 1 double | | how far loops were from circles, in circumferences, before they were put there |
 * | field | Cut | 1 vtkIdType each | | vertices of the cut, from the outer loop to the inner one |
 *
 * See nadeem2017 and springborn2008 in docs/references.bib, and docs/methods/annulus-map.md.
 *
 * @sa vtkCircleDomainMap vtkRiemannMap
 */
#ifndef vtkAnnulusMap_h
#define vtkAnnulusMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkCurvatureFlowMapAlgorithm.h"

#include <vector> // for loops

namespace authalic
{
struct AnnulusMapOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkAnnulusMap : public vtkCurvatureFlowMapAlgorithm
{
public:
  static vtkAnnulusMap* New();
  vtkTypeMacro(vtkAnnulusMap, vtkCurvatureFlowMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum DomainType
  {
    ANNULUS = 0,
    RECTANGLE = 1
  };

  ///@{
  /** The concentric ring, or the periodic rectangle. Default ANNULUS. */
  vtkSetClampMacro(Domain, int, ANNULUS, RECTANGLE);
  vtkGetMacro(Domain, int);
  void SetDomainToAnnulus() { this->SetDomain(ANNULUS); }
  void SetDomainToRectangle() { this->SetDomain(RECTANGLE); }
  ///@}

  ///@{
  /** A vertex of the loop that becomes the outer circle; -1 = the longer loop. Default -1. */
  vtkSetMacro(OuterVertex, int);
  vtkGetMacro(OuterVertex, int);
  ///@}

protected:
  vtkAnnulusMap() = default;
  ~vtkAnnulusMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int Domain = ANNULUS;
  int OuterVertex = -1;

private:
  authalic::AnnulusMapOptions Options(const std::vector<std::vector<int>>& loops) const;

  vtkAnnulusMap(const vtkAnnulusMap&) = delete;
  void operator=(const vtkAnnulusMap&) = delete;
};

#endif
