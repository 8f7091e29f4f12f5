/**
 * @class vtkPolyAnnulusTransportMap
 * @brief Area-preserving, or measure-controlled, map of a surface with holes by optimal transport.
 *
 * As vtkOptimalTransportMap, for any number of boundary loops: the conformal map to the unit disk without round holes
 * gives the sites, every hole is filled with a mass of its own at its centre, and the power cell of every vertex and of
 * every hole has exactly its share. The cell of a hole is the hole of the map: convex, not round. Cells are exact,
 * faces are not, and some may fold: Flipped says which. Finish AUTHALIC makes holes round, around the middles of their
 * cells, and removes folds and area errors with the solve of vtkCircleDomainAuthalicMap. Input 0 must be connected,
 * oriented, manifold, of genus 0 and have a boundary.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface |
 * | output 0 | vtkPolyData, the map: see vtkSurfaceMapAlgorithm |
 * | output 1 | vtkPolyData, the cells: one polygon per vertex, then one per hole; arcs of the disk with a corner every 0.02 radians |
 *
 * | port | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|---|
 * | 0 | point | Site | 3 double | | y_i: the conformal map |
 * | 0 | point | CellArea | 1 double | | area of the cell |
 * | 0 | point | Potential | 1 double | | u at the image, u(x) = max over i of ⟨x, y_i⟩ + h_i |
 * | 0 | field | Circles | 3 double each | | x, y of the centre and radius of every loop: in the conformal map, after the finish in the map |
 * | 0 | field | OuterLoop | 1 int | | which of them is the unit circle |
 * | 0 | field | HoleAreas | 1 double each | mm² | mass of each hole per mass of a mm² of the surface, in the order of the other loops |
 * | 0 | field | HoleResidual | 1 double | | max of the absolute logarithm of share / share that it should have: of the cells, after the finish of the holes |
 * | 0 | field | Pockets | 1 int | | vertices of ears of the surface that lie in holes |
 * | 0 | field | TransportResidual | 1 double | | max of the absolute difference of cell area and target / mean target |
 * | 0 | field | TransportCost | 1 double | | W₂² = Σ ∫ over cells of the squared distance to the site, holes included |
 * | 0 | field | DisplacementCost | 1 double | | Σ ν times squared distance of image and site over the vertices, before the finish |
 * | 0 | field | FinishedCost | 1 double | | the same after it, when there is one |
 * | 0 | field | FlippedBeforeFinish | 1 int | | folded faces before it, when there is one |
 * | 0 | field | EmptyCells | 1 int | | 0 |
 * | 1 | cell | SiteIds | 1 id | | vertex of the cell; number of vertices + number of the hole for a hole |
 * | 1 | cell | Area | 1 double | | exact, arcs included |
 * | 1 | point | Potential | 1 double | | u at the corners |
 *
 * See su2016 and kitagawa2019 in docs/references.bib, and docs/methods/optimal-transport.md.
 *
 * @sa vtkOptimalTransportMap vtkCircleDomainAuthalicMap vtkCircleDomainMap
 */
#ifndef vtkPolyAnnulusTransportMap_h
#define vtkPolyAnnulusTransportMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceMapAlgorithm.h"

#include <vector> // for hole areas

namespace authalic
{
class Json;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkPolyAnnulusTransportMap : public vtkSurfaceMapAlgorithm
{
public:
  static vtkPolyAnnulusTransportMap* New();
  vtkTypeMacro(vtkPolyAnnulusTransportMap, vtkSurfaceMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum StartType
  {
    AUTOMATIC = 0,
    VORONOI = 1,
    COARSE_TO_FINE = 2
  };
  enum FinishType
  {
    NO_FINISH = 0,
    AUTHALIC = 1
  };

  ///@{
  /** A vertex of the loop that becomes the unit circle; -1 = the longest loop. Default -1. */
  vtkSetMacro(OuterVertex, int);
  vtkGetMacro(OuterVertex, int);
  ///@}

  ///@{
  /**
   * Area of a hole, mm² > 0, as against the area of the surface; one for each loop but the outer one, in the order of
   * their smallest vertex ids. None: the areas of the cones that close the holes on the surface, or, with a HoleShare,
   * of the disks that the conformal map leaves out. Default none.
   */
  void AddHoleArea(double area);
  void ClearHoleAreas();
  int GetNumberOfHoleAreas() const { return static_cast<int>(this->HoleAreas.size()); }
  ///@}

  ///@{
  /**
   * Part of the disk that all holes get together, in [0, 1), divided in proportion to their areas; 0 = as large as
   * these are. Default: authalic::PolyAnnulusTransportOptions, as below.
   */
  vtkSetMacro(HoleShare, double);
  vtkGetMacro(HoleShare, double);
  ///@}

  ///@{
  /** Of max |cell area − target| / mean target, > 0. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Most Newton steps, 0 or more. */
  vtkSetClampMacro(MaximumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  ///@{
  /**
   * Where Newton's method begins: at the Voronoi cells of the sites, or at heights of a transport to fewer sites.
   * AUTOMATIC: COARSE_TO_FINE for large surfaces, where it gains. The result is the same to the tolerance.
   */
  vtkSetClampMacro(Start, int, AUTOMATIC, COARSE_TO_FINE);
  vtkGetMacro(Start, int);
  void SetStartToAutomatic() { this->SetStart(AUTOMATIC); }
  void SetStartToVoronoi() { this->SetStart(VORONOI); }
  void SetStartToCoarseToFine() { this->SetStart(COARSE_TO_FINE); }
  ///@}

  ///@{
  /** AUTHALIC: round holes, no folds, exact areas afterwards, with the defaults of vtkCircleDomainAuthalicMap. Default
   * NO_FINISH. */
  vtkSetClampMacro(Finish, int, NO_FINISH, AUTHALIC);
  vtkGetMacro(Finish, int);
  void SetFinishToNone() { this->SetFinish(NO_FINISH); }
  void SetFinishToAuthalic() { this->SetFinish(AUTHALIC); }
  ///@}

protected:
  vtkPolyAnnulusTransportMap();
  ~vtkPolyAnnulusTransportMap() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int OuterVertex = -1;
  std::vector<double> HoleAreas;
  double HoleShare;
  double Tolerance;
  int MaximumIterations;
  int Start;
  int Finish = NO_FINISH;

private:
  authalic::Json DescribeOptions() const;

  vtkPolyAnnulusTransportMap(const vtkPolyAnnulusTransportMap&) = delete;
  void operator=(const vtkPolyAnnulusTransportMap&) = delete;
};

#endif
