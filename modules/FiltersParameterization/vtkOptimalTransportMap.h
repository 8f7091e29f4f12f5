/**
 * @class vtkOptimalTransportMap
 * @brief Area-preserving, or measure-controlled, map of a topological disk by optimal transport.
 *
 * Starts from a map that keeps angles (harmonic, Riemann's, or a given one); its images y_i of the vertices are sites
 * with heights such that the power cell of each has the area that its vertex shall have, exactly, at the least
 * transport cost. Vertex i goes to the middle of its cell; boundary vertices stay on the boundary. Cells are exact,
 * faces are not, and some may fold: Flipped says which, and Finish AUTHALIC removes folds and area errors with the
 * solve of vtkAuthalicMap, started from the map. When the tolerance is not reached the best map comes with Status
 * not-converged or stalled, a warning, and ErrorKind NOT_CONVERGED.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: see vtkDiskMapAlgorithm; the domain must be convex |
 * | input 1, optional | vtkPolyData, an initial map to the same domain: same vertices in the same order |
 * | input 2, optional | vtkPolyData, mesh of the source density: a planar disk (z constant) that covers the domain |
 * | output 0 | vtkPolyData, the map: see vtkSurfaceMapAlgorithm |
 * | output 1 | vtkPolyData, the cells: one polygon per vertex, arcs of the disk with a corner every 0.02 radians |
 *
 * | port | association | name | components, type | meaning |
 * |---|---|---|---|---|
 * | 0 | point | Site | 3 double | y_i: the initial map |
 * | 0 | point | CellArea | 1 double | area of the cell |
 * | 0 | point | CellMass | 1 double | with a source density: its integral over the cell |
 * | 0 | point | Potential | 1 double | u at the image, u(x) = max over i of ⟨x, y_i⟩ + h_i |
 * | 0 | field | Method | 1 string | transport; balanced with a balance |
 * | 0 | field | Balance | 1 double | as set; without BalanceArrayName |
 * | 0 | field | TransportResidual | 1 double | max of the absolute difference of cell mass and target / mean target |
 * | 0 | field | TransportCost | 1 double | W₂² = Σ ∫ over cells of the squared distance to the site, times the density |
 * | 0 | field | SourceMass | 1 double | with a source density: its integral over the domain |
 * | 0 | field | DisplacementCost | 1 double | Σ ν times squared distance of image and site, before the finish |
 * | 0 | field | FinishedCost | 1 double | the same after it, when there is one |
 * | 0 | field | FlippedBeforeFinish | 1 int | folded faces before it, when there is one |
 * | 0 | field | EmptyCells | 1 int | 0 |
 * | 1 | cell | SiteIds | 1 id | vertex of the cell |
 * | 1 | cell | Area | 1 double | exact, arcs included |
 * | 1 | cell | Mass | 1 double | with a source density: its integral over the cell |
 * | 1 | point | Potential | 1 double | u at the corners |
 *
 * The source is the uniform measure of the domain, or the density that a point array of input 2 gives: linear in every
 * triangle, continued between the chords of its boundary and the circle. Cells then have equal shares of that density,
 * not of the area, and AreaDistortion, which compares areas, is not what the map controls.
 *
 * See gu2016, kitagawa2019 and su2016 in docs/references.bib, and docs/methods/optimal-transport.md.
 *
 * @sa vtkAuthalicMap vtkDiscreteLieFlow
 */
#ifndef vtkOptimalTransportMap_h
#define vtkOptimalTransportMap_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkDiskMapAlgorithm.h"

#include <string> // for BalanceArrayName, SourceDensityArrayName

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkOptimalTransportMap : public vtkDiskMapAlgorithm
{
public:
  static vtkOptimalTransportMap* New();
  vtkTypeMacro(vtkOptimalTransportMap, vtkDiskMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum InitialMethodType
  {
    HARMONIC = 0,
    RIEMANN = 1
  };
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
  /** The map that gives the sites when input port 1 is empty; RIEMANN to the DISK only. Default HARMONIC. */
  vtkSetClampMacro(InitialMethod, int, HARMONIC, RIEMANN);
  vtkGetMacro(InitialMethod, int);
  void SetInitialMethodToHarmonic() { this->SetInitialMethod(HARMONIC); }
  void SetInitialMethodToRiemann() { this->SetInitialMethod(RIEMANN); }
  ///@}

  ///@{
  /** Of max |cell area − target| / mean target, > 0. Default: authalic::SemiDiscreteTransportOptions, as below. */
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
  /** AUTHALIC: remove folds and area errors afterwards, with the defaults of vtkAuthalicMap. Default
   * NO_FINISH. */
  vtkSetClampMacro(Finish, int, NO_FINISH, AUTHALIC);
  vtkGetMacro(Finish, int);
  void SetFinishToNone() { this->SetFinish(NO_FINISH); }
  void SetFinishToAuthalic() { this->SetFinish(AUTHALIC); }
  ///@}

  ///@{
  /**
   * Weight of the areas, 0 to 1: the masses are (1 - Balance) × the areas of the conformal map + Balance × the measure,
   * and below 1 the sites are that map. 1 = area-preserving, 0 = conformal. Domain DISK only when below 1. Default 1.
   */
  vtkSetClampMacro(Balance, double, 0.0, 1.0);
  vtkGetMacro(Balance, double);
  ///@}

  ///@{
  /**
   * Point array of weights, 0 to 1 at every vertex, that takes the place of Balance: the balance from place to place.
   * Empty = Balance everywhere. Domain DISK only. Default empty.
   */
  vtkSetMacro(BalanceArrayName, std::string);
  vtkGetMacro(BalanceArrayName, std::string);
  ///@}

  ///@{
  /**
   * Point array of input 2, one number > 0 at every vertex: the source density. Not with a Finish, nor with a balance.
   * Required with input 2, empty without it. Default empty.
   */
  vtkSetMacro(SourceDensityArrayName, std::string);
  vtkGetMacro(SourceDensityArrayName, std::string);
  ///@}

protected:
  vtkOptimalTransportMap();
  ~vtkOptimalTransportMap() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int InitialMethod = HARMONIC;
  double Tolerance;
  int MaximumIterations;
  int Start;
  int Finish = NO_FINISH;
  double Balance = 1.0;
  std::string BalanceArrayName;
  std::string SourceDensityArrayName;

private:
  void CheckSource(bool meshGiven) const;
  authalic::Json DescribeAllOptions(bool initialMapGiven) const;

  vtkOptimalTransportMap(const vtkOptimalTransportMap&) = delete;
  void operator=(const vtkOptimalTransportMap&) = delete;
};

#endif
