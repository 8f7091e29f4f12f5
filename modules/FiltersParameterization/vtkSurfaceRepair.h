/**
 * @class vtkSurfaceRepair
 * @brief Makes a clean oriented manifold of a broken surface, and lists everything it changed.
 *
 * In rounds, until a round changes nothing: isolated vertices, degenerate and duplicate faces, seams of coincident
 * boundary edges, T-junctions, non-manifold edges and vertices, stray components, flipped faces, small holes, and
 * handles (cut along their shortest loop and capped). A clean surface comes back unchanged. What cannot be repaired
 * (a one-sided surface, triangles that do not meet, coordinates that are not finite) is an error that says why.
 * What is left that some maps refuse (several components, handles above LargestHandle) is a warning.
 *
 * Points never move; the two caps of a handle lie on each other. See barequet1995, erickson2005 in
 * docs/references.bib.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, triangles, mm, however broken |
 * | output 0 | the repaired surface, with the arrays of the input and those below; what is new has the values beside it |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | point | OriginalPointIds | 1 vtkIdType | | point of the input; copies name the same one; -1 = new |
 * | cell | OriginalCellIds | 1 vtkIdType | | triangle of the input that it is or is a part of; -1 = new |
 * | field | RepairChanges | 1 int | | how many there were |
 * | field | HandlePlaces | 3 double each | mm | mean of the loop along which a handle was cut |
 * | field | HandleLengths | 1 double each | mm | of the loop |
 * | field | Status | 1 string | | converged: repairing the output changes nothing |
 *
 * @sa vtkSurfaceTopologyReport vtkCutToDisk
 */
#ifndef vtkSurfaceRepair_h
#define vtkSurfaceRepair_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for Summary and Report

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkSurfaceRepair : public vtkSurfaceAlgorithm
{
public:
  static vtkSurfaceRepair* New();
  vtkTypeMacro(vtkSurfaceRepair, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Whether boundary edges with the same end points are joined. Off: a surface that was cut open stays open. Default:
   * SurfaceRepairOptions. */
  vtkSetMacro(SewSeams, bool);
  vtkGetMacro(SewSeams, bool);
  vtkBooleanMacro(SewSeams, bool);
  ///@}

  ///@{
  /** A boundary vertex closer to a boundary edge than this fraction of its length is a T-junction; 0 to 0.1. Default:
   * SurfaceRepairOptions. */
  vtkSetClampMacro(JunctionTolerance, double, 0.0, 0.1);
  vtkGetMacro(JunctionTolerance, double);
  ///@}

  ///@{
  /** Components with less than this fraction of the largest component's area are removed; 0 to 1. Default:
   * SurfaceRepairOptions. */
  vtkSetClampMacro(StrayShare, double, 0.0, 1.0);
  vtkGetMacro(StrayShare, double);
  ///@}

  ///@{
  /** Boundary loops up to this length are filled, mm; 0 = none, negative = a tenth of the square root of the area.
   * Default: SurfaceRepairOptions. */
  vtkSetMacro(LargestHole, double);
  vtkGetMacro(LargestHole, double);
  ///@}

  ///@{
  /** Handles whose shortest loop is at most this long are cut, mm; 0 = none, negative = all. Default:
   * SurfaceRepairOptions. */
  vtkSetMacro(LargestHandle, double);
  vtkGetMacro(LargestHandle, double);
  ///@}

  /** What the last execution changed, one line per kind; empty when nothing was. */
  vtkGetMacro(Summary, std::string);

  /** All of it as JSON; empty before the first execution and after an error. */
  vtkGetMacro(Report, std::string);

protected:
  vtkSurfaceRepair();
  ~vtkSurfaceRepair() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  bool SewSeams;
  double JunctionTolerance, StrayShare, LargestHole, LargestHandle;
  std::string Summary, Report;

private:
  vtkSurfaceRepair(const vtkSurfaceRepair&) = delete;
  void operator=(const vtkSurfaceRepair&) = delete;
};

#endif
