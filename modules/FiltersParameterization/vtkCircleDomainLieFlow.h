/**
 * @class vtkCircleDomainLieFlow
 * @brief Area-preserving, or measure-controlled, map of a surface with holes by the discrete Lie flow.
 *
 * As vtkDiscreteLieFlow, for any number of boundary loops, onto the unit disk without round holes: every hole gets
 * exactly its area, the vertices of every loop slide on its circle. Holes stay where the conformal map has their
 * centres, or, with Concentric, the one hole is in the middle (an annulus). Ears on inner loops bulge into the hole.
 * Input 0 must be connected, oriented, manifold, of genus 0 and have a boundary. Ports and arrays: see
 * vtkLieFlowAlgorithm; also
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | field | Circles | 3 double each | | x, y of the centre and radius of every loop, in the order of the loops' smallest ids |
 * | field | OuterLoop | 1 int | | which of them is the unit circle |
 * | field | HoleAreas | 1 double each | mm² | prescribed, in the order of the other loops |
 * | field | HoleResidual | 1 double | | max of the absolute logarithm of image share / prescribed share of holes |
 * | field | Pockets | 1 int | | ears of the surface that lie in holes |
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

namespace authalic
{
struct CircleDomainLieFlowOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkCircleDomainLieFlow : public vtkLieFlowAlgorithm
{
public:
  static vtkCircleDomainLieFlow* New();
  vtkTypeMacro(vtkCircleDomainLieFlow, vtkLieFlowAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Whether the hole of a surface with two loops is in the middle of the disk. Default off. */
  vtkSetMacro(Concentric, bool);
  vtkGetMacro(Concentric, bool);
  vtkBooleanMacro(Concentric, bool);
  ///@}

  ///@{
  /** A vertex of the loop that becomes the unit circle; -1 = the longest loop. Default -1. */
  vtkSetMacro(OuterVertex, int);
  vtkGetMacro(OuterVertex, int);
  ///@}

  ///@{
  /**
   * Area of a hole, mm² > 0, as against the area of the surface; one for each loop but the outer one, in the order of
   * their smallest vertex ids. None: the areas of the cones that close the holes on the surface. Default none.
   */
  void AddHoleArea(double area);
  void ClearHoleAreas();
  int GetNumberOfHoleAreas() const { return static_cast<int>(this->HoleAreas.size()); }
  ///@}

protected:
  vtkCircleDomainLieFlow();
  ~vtkCircleDomainLieFlow() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  bool Concentric;
  int OuterVertex = -1;
  std::vector<double> HoleAreas;

private:
  authalic::CircleDomainLieFlowOptions Options(const std::vector<std::vector<int>>& loops) const;

  vtkCircleDomainLieFlow(const vtkCircleDomainLieFlow&) = delete;
  void operator=(const vtkCircleDomainLieFlow&) = delete;
};

#endif
