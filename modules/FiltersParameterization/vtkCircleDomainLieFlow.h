/**
 * @class vtkCircleDomainLieFlow
 * @brief Area-preserving, or measure-controlled, map of a surface with holes by the discrete Lie flow.
 *
 * As vtkDiscreteLieFlow, for any number of boundary loops, onto the unit disk without round holes: every hole gets
 * exactly its area, the vertices of every loop slide on its circle. Holes stay where the start has their centres
 * (the conformal map, where that is near enough), or, on the ANNULUS, the one hole is in the middle. Ears on inner
 * loops bulge into the hole. A surface with two loops, such as a tube, may also go to the PERIODIC_RECTANGLE [0,
 * 1] x [0, h], h found by the method: loops slide along its sides, the output is cut open (vertices of the input
 * first, then the copies), and ears lie outside. Input 0 must be connected, oriented, manifold, of genus 0 and
 * have a boundary. Ports and arrays: see vtkLieFlowAlgorithm; also
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | field | Circles | 3 double each | | x, y of the centre and radius of every loop, in the order of the loops' smallest ids |
 * | field | OuterLoop | 1 int | | which of them is the unit circle, or y = 0 |
 * | field | HoleAreas | 1 double each | mm² | prescribed, in the order of the other loops |
 * | field | HoleResidual | 1 double | | max of the absolute logarithm of image share / prescribed share of holes |
 * | field | Pockets | 1 int | | ears of the surface that lie in holes, or outside of the rectangle |
 * | point | OriginalPointIds | 1 vtkIdType | | rectangle: point of the input |
 * | field | Height, Circumference | 1 double | mm | rectangle: of the cylinder that is as large as the surface |
 * | field | Cut | 1 double each | | rectangle: vertices of the cut, from the outer loop to the other one |
 *
 * See su2019 in docs/references.bib, and docs/methods/discrete-lie-flow.md.
 *
 * @sa vtkCircleDomainMap vtkCircleDomainAuthalicMap
 */
#ifndef vtkCircleDomainLieFlow_h
#define vtkCircleDomainLieFlow_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkLieFlowAlgorithm.h"

#include <vector> // for hole areas

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkCircleDomainLieFlow : public vtkLieFlowAlgorithm
{
public:
  static vtkCircleDomainLieFlow* New();
  vtkTypeMacro(vtkCircleDomainLieFlow, vtkLieFlowAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum DomainType
  {
    CIRCLE_DOMAIN = 0,
    ANNULUS = 1,
    PERIODIC_RECTANGLE = 2
  };

  ///@{
  /**
   * The unit disk without round holes; for two loops also the same with the hole in
   * the middle, or a rectangle that is periodic in x. Default CIRCLE_DOMAIN.
   */
  vtkSetClampMacro(Domain, int, CIRCLE_DOMAIN, PERIODIC_RECTANGLE);
  vtkGetMacro(Domain, int);
  void SetDomainToCircleDomain() { this->SetDomain(CIRCLE_DOMAIN); }
  void SetDomainToAnnulus() { this->SetDomain(ANNULUS); }
  void SetDomainToPeriodicRectangle() { this->SetDomain(PERIODIC_RECTANGLE); }
  ///@}

  ///@{
  /** A vertex of the loop that becomes the unit circle, or the side y = 0; -1 = the longest loop. Default -1. */
  vtkSetMacro(OuterVertex, int);
  vtkGetMacro(OuterVertex, int);
  ///@}

  ///@{
  /**
   * Area of a hole, mm² > 0, as against the area of the surface; one for each loop but the outer one, in the order of
   * their smallest vertex ids; not for the rectangle. None: the areas of the cones that close the holes on the surface.
   * Default none.
   */
  void AddHoleArea(double area);
  void ClearHoleAreas();
  int GetNumberOfHoleAreas() const { return static_cast<int>(this->HoleAreas.size()); }
  ///@}

protected:
  vtkCircleDomainLieFlow() = default;
  ~vtkCircleDomainLieFlow() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int Domain = CIRCLE_DOMAIN;
  int OuterVertex = -1;
  std::vector<double> HoleAreas;

private:
  authalic::MapReport MapToCircles(vtkPolyData* input, vtkPolyData* output, const authalic::Execution& execution);
  authalic::MapReport MapToRectangle(vtkPolyData* input, vtkPolyData* output, const authalic::Execution& execution);

  vtkCircleDomainLieFlow(const vtkCircleDomainLieFlow&) = delete;
  void operator=(const vtkCircleDomainLieFlow&) = delete;
};

#endif
