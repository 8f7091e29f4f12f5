/**
 * @class vtkAnnulusMap
 * @brief Conformal map of a surface with two boundary loops onto a ring, or onto a periodic rectangle.
 *
 * Finds the flat metric with straight loops in the discrete conformal class of the surface, a cylinder, cuts it along a
 * shortest path, and lays it out: the exponential makes the ring. The rectangle is periodic in x with period 1 and has
 * the modulus as its height; its sides follow the cut and differ by a shift of 1. The vertices of the input come first,
 * then the copies on the other side of the cut.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: connected, oriented, manifold, genus 0, two boundary loops |
 * | output 0 | vtkPolyData, the map: see vtkConformalFlowAlgorithm |
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | point | OriginalPointIds (as RECTANGLE) | 1 vtkIdType | point of the input |
 * | point | LogScaleFactor | 1 double | u: image lengths are l_ij exp((u_i + u_j)/2), on the ring to second order |
 * | field | Method | 1 string | annulus |
 * | field | ConformalModulus | 1 double | (1/2 pi) ln(R/r) = height / circumference of the cylinder |
 * | field | Height, Circumference | 1 double | mm, of the flat cylinder that is as large as the surface |
 * | field | InnerRadius | 1 double | r, with R = 1 |
 * | field | Straightness | 1 double | how far loops were from circles, in circumferences, before they were put there |
 * | field | Pockets | 1 int | pockets of the boundary that were bulged out |
 * | field | Cut | 1 int each | vertices of the cut, from the outer loop to the inner one |
 *
 * See nadeem2017 in docs/references.bib, and docs/methods/annulus-map.md.
 *
 * @sa vtkCircleDomainMap vtkRiemannMap
 */
#ifndef vtkAnnulusMap_h
#define vtkAnnulusMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkConformalFlowAlgorithm.h"

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkAnnulusMap : public vtkConformalFlowAlgorithm
{
public:
  static vtkAnnulusMap* New();
  vtkTypeMacro(vtkAnnulusMap, vtkConformalFlowAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum DomainType
  {
    RING = 0,
    RECTANGLE = 1
  };

  ///@{
  /** The concentric ring with the unit circle outside, or the periodic rectangle. Default RING. */
  vtkSetClampMacro(Domain, int, RING, RECTANGLE);
  vtkGetMacro(Domain, int);
  void SetDomainToRing() { this->SetDomain(RING); }
  void SetDomainToRectangle() { this->SetDomain(RECTANGLE); }
  ///@}

  ///@{
  /** A vertex of the loop that becomes the outer circle; -1 = the longer loop. Default -1. */
  vtkSetMacro(OuterVertex, int);
  vtkGetMacro(OuterVertex, int);
  ///@}

  ///@{
  /** Vertex of the outer loop at angle 0; -1 = the one with the smallest id. Default -1. */
  vtkSetMacro(StartVertex, int);
  vtkGetMacro(StartVertex, int);
  ///@}

protected:
  vtkAnnulusMap() = default;
  ~vtkAnnulusMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int Domain = RING;
  int OuterVertex = -1;
  int StartVertex = -1;

private:
  vtkAnnulusMap(const vtkAnnulusMap&) = delete;
  void operator=(const vtkAnnulusMap&) = delete;
};

#endif
