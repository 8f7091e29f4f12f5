/**
 * @class vtkCircleDomainAuthalicMap
 * @brief Area-preserving, or measure-controlled, map of a surface with holes to the unit disk without round holes.
 *
 * As vtkAuthalicMap, for any number of boundary loops: every vertex star gets exactly its share, every hole
 * exactly its area, every loop lies on a circle. Centres of the circles are unknowns, radii follow from the areas
 * or are unknowns, too; on the ANNULUS the one hole is in the middle. Ears on inner loops bulge into the hole. A
 * surface with two loops, such as a tube, may also go to the PERIODIC_RECTANGLE [0, 1] x [0, h], h found by the
 * method: loops slide along its sides, the output is cut open (vertices of the input first, then the copies), and
 * ears lie outside. Input 0 must be connected, oriented, manifold, of genus 0 and have a boundary. Ports and
 * arrays: see vtkAreaSolveAlgorithm; also
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | field | Circles | 3 double each | | x, y of the centre and radius of every loop, in the order of the loops' smallest ids |
 * | field | OuterLoop | 1 int | | which of them is the unit circle, or y = 0 |
 * | field | HoleAreas | 1 double each | mm² | prescribed, or found where radii are free, in the order of the other loops |
 * | field | HoleResidual | 1 double | | max of the absolute logarithm of image share / prescribed share of holes |
 * | field | Pockets | 1 int | | ears of the surface that lie in holes, or outside of the rectangle |
 * | point | OriginalPointIds | 1 vtkIdType | | rectangle: point of the input |
 * | field | Height, Circumference | 1 double | mm | rectangle: of the cylinder that is as large as the surface |
 * | field | Cut | 1 double each | | rectangle: vertices of the cut, from the outer loop to the other one |
 *
 * See zou2011 and su2016 in docs/references.bib, and docs/methods/authalic-with-holes.md.
 *
 * @sa vtkCircleDomainMap vtkAuthalicMap
 */
#ifndef vtkCircleDomainAuthalicMap_h
#define vtkCircleDomainAuthalicMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkAreaSolveAlgorithm.h"

#include <vector> // for hole areas

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkCircleDomainAuthalicMap : public vtkAreaSolveAlgorithm
{
public:
  static vtkCircleDomainAuthalicMap* New();
  vtkTypeMacro(vtkCircleDomainAuthalicMap, vtkAreaSolveAlgorithm);
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

  ///@{
  /** CIRCLE_DOMAIN: holes keep the centres that the conformal map gives them; else they move. Default off. */
  vtkSetMacro(HoldCentres, bool);
  vtkGetMacro(HoldCentres, bool);
  vtkBooleanMacro(HoldCentres, bool);
  ///@}

  ///@{
  /**
   * CIRCLE_DOMAIN and ANNULUS: radii of holes are found with the map, for good angles, instead of following from
   * their areas, of which there must be none then. Default off.
   */
  vtkSetMacro(FreeRadii, bool);
  vtkGetMacro(FreeRadii, bool);
  vtkBooleanMacro(FreeRadii, bool);
  ///@}

protected:
  vtkCircleDomainAuthalicMap();
  ~vtkCircleDomainAuthalicMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int Domain = CIRCLE_DOMAIN;
  int OuterVertex = -1;
  std::vector<double> HoleAreas;
  bool HoldCentres;
  bool FreeRadii;

private:
  authalic::MapReport MapToCircles(vtkPolyData* input, vtkPolyData* output, const authalic::Execution& execution);
  authalic::MapReport MapToRectangle(vtkPolyData* input, vtkPolyData* output, const authalic::Execution& execution);

  vtkCircleDomainAuthalicMap(const vtkCircleDomainAuthalicMap&) = delete;
  void operator=(const vtkCircleDomainAuthalicMap&) = delete;
};

#endif
