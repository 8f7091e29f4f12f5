/**
 * @class vtkBalanceCurve
 * @brief Angle distortion against area distortion of the maps between conformal and area-preserving, as a table.
 *
 * For every balance t the surface is mapped as by vtkOptimalTransportMap (a disk, to the unit disk) or
 * vtkSphericalTransportMap (a closed surface of genus 0) with that Balance and Finish AUTHALIC, to tolerances that are
 * enough to choose a t by. One conformal map serves all. When a map does not converge the table is complete, its
 * column status says which, and the filter warns with ErrorKind NOT_CONVERGED.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, a topological disk or a closed surface of genus 0 |
 * | output 0 | vtkTable, one row per t |
 *
 * | column | type | unit | meaning |
 * |---|---|---|---|
 * | balance | double | – | t |
 * | angle_distortion, area_distortion | double | – | D_angle, D_area (to the measure) of the map, ideal 2 |
 * | angle_error_mean_degrees | double | degrees | of its corners |
 * | flipped_faces | int64 | – | of it |
 * | transport_angle_distortion … transport_flipped_faces | | | the same four before the finish |
 * | status | string | – | converged, not-converged, stalled |
 *
 * See nadeem2017 in docs/references.bib, and docs/methods/balanced-map.md.
 *
 * @sa vtkOptimalTransportMap vtkSphericalTransportMap
 */
#ifndef vtkBalanceCurve_h
#define vtkBalanceCurve_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkTableAlgorithm.h"

#include <string> // for MeasureArrayName
#include <vector> // for Balances

namespace authalic
{
struct BalanceCurve;
struct BalanceCurveOptions;
class Execution;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkBalanceCurve : public vtkTableAlgorithm
{
public:
  static vtkBalanceCurve* New();
  vtkTypeMacro(vtkBalanceCurve, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** How many t, from 0 to 1 in equal steps, where none are added. Range 2 to 1001, default 11. */
  vtkSetClampMacro(NumberOfBalances, int, 2, 1001);
  vtkGetMacro(NumberOfBalances, int);
  ///@}

  ///@{
  /** A t of the table, 0 to 1; those that are added take the place of equal steps. Best in order: each map starts from
   * the transport of the one before. */
  void AddBalance(double balance);
  void ClearBalances();
  ///@}

  ///@{
  /** Point or cell array of densities > 0: the measure at t = 1. Empty = surface area. Default empty. */
  vtkSetMacro(MeasureArrayName, std::string);
  vtkGetMacro(MeasureArrayName, std::string);
  ///@}

  ///@{
  /** Threads to use; 0 = every core. The result does not depend on it. Range 0 to 1024, default 0. */
  vtkSetClampMacro(Threads, int, 0, 1024);
  vtkGetMacro(Threads, int);
  ///@}

  /** How the last execution ended: see vtkSurfaceAlgorithm::ErrorKindType. */
  vtkGetMacro(ErrorKind, int);

  /** The table of the last execution as TSV; empty before it and after an error. */
  vtkGetMacro(Text, std::string);

  /** Options, version, status, seconds (of the conformal map and of each row) and the meaning of every column as JSON,
   * to stand beside Text; empty before it and after an error. */
  vtkGetMacro(Report, std::string);

protected:
  vtkBalanceCurve();
  ~vtkBalanceCurve() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int NumberOfBalances;
  std::vector<double> Balances;
  std::string MeasureArrayName, Text, Report;
  int Threads = 0;
  int ErrorKind = 0;

private:
  void Compute(vtkInformationVector** inputs, vtkInformationVector* outputs, const authalic::Execution& execution);
  void Publish(vtkTable* table, const authalic::BalanceCurve& curve, const authalic::BalanceCurveOptions& options);

  vtkBalanceCurve(const vtkBalanceCurve&) = delete;
  void operator=(const vtkBalanceCurve&) = delete;
};

#endif
