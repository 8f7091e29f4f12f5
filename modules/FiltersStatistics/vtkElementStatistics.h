/**
 * @class vtkElementStatistics
 * @brief Area-weighted statistics of sampled fields per element and per label region, as tables.
 *
 * A vertex weighs in an element by the integral of its hat function over the element: means do not depend on the
 * density of the mesh. Vertices that are NaN (n/a) are left out and lower the coverage.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData: output 0 of vtkElementGrid, with sampled point arrays |
 * | output 0 | vtkTable, one row per element |
 * | output 1 | vtkTable, one row per region; empty without labels |
 *
 * Columns are those of the TSV files: element_id, hemi, u_min … label_fraction, grid_i, grid_j, interior, then
 * FIELD_n, FIELD_mean, FIELD_sd, FIELD_median, FIELD_min, FIELD_max, FIELD_coverage for each field (its name in
 * snake_case); label_id, label_name, hemi, centroid_x_mm … area_fraction and the same for regions.
 *
 * A field X whose point array XCoverage exists takes its coverage from there.
 *
 * @sa vtkElementGrid vtkSampleVolumeOnSurface
 */
#ifndef vtkElementStatistics_h
#define vtkElementStatistics_h

#include "vtkAuthalicFiltersStatisticsModule.h" // for export macro
#include "vtkTableAlgorithm.h"

#include <memory> // for Results
#include <string> // for names
#include <vector> // for fields and regions

namespace authalic
{
class Execution;
}

class VTKAUTHALICFILTERSSTATISTICS_EXPORT vtkElementStatistics : public vtkTableAlgorithm
{
public:
  static vtkElementStatistics* New();
  vtkTypeMacro(vtkElementStatistics, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Point arrays to summarise. None added = every array that has a Coverage companion. Units may be empty. */
  void AddFieldArray(const std::string& name) { this->AddFieldArray(name, ""); }
  void AddFieldArray(const std::string& name, const std::string& units, const std::string& description = "");
  void ClearFieldArrays();
  ///@}

  ///@{
  /** Point array of labels, or empty for no labels. Default empty. */
  vtkSetMacro(LabelArrayName, std::string);
  vtkGetMacro(LabelArrayName, std::string);
  ///@}

  ///@{
  /** Names of the labels. None added = every label other than 0 that occurs, named by its number. */
  void AddRegion(int label, const std::string& name);
  void ClearRegions();
  ///@}

  ///@{
  /** What the column hemi says: L, R or empty (n/a). Default empty. */
  vtkSetMacro(Hemisphere, std::string);
  vtkGetMacro(Hemisphere, std::string);
  ///@}

  ///@{
  /** Writes the table of the last execution as TSV, and its description beside it as .json; whole or not at all.
   * @returns false, after an error message, when there is no table or the file cannot be written */
  bool WriteElements(const std::string& tsvPath);
  bool WriteRegions(const std::string& tsvPath);
  ///@}

  ///@{
  /** Threads to use; 0 = every core. Range 0 to 1024, default 0. */
  vtkSetClampMacro(Threads, int, 0, 1024);
  vtkGetMacro(Threads, int);
  ///@}

  /** How the last execution or writing ended: see vtkSurfaceAlgorithm::ErrorKindType. */
  vtkGetMacro(ErrorKind, int);

protected:
  vtkElementStatistics();
  ~vtkElementStatistics() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  struct FieldName
  {
    std::string Name, Units, Description;
  };
  struct Region
  {
    int Label;
    std::string Name;
  };
  struct Tables;

  std::vector<FieldName> Fields;
  std::vector<Region> Regions;
  std::string LabelArrayName;
  std::string Hemisphere;
  int Threads = 0;
  int ErrorKind = 0;
  std::unique_ptr<Tables> Results;

private:
  void Compute(vtkInformationVector** inputs, vtkInformationVector* outputs, const authalic::Execution& execution);
  bool Write(const std::string& tsvPath, bool regions);

  vtkElementStatistics(const vtkElementStatistics&) = delete;
  void operator=(const vtkElementStatistics&) = delete;
};

#endif
