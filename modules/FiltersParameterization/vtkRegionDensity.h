/**
 * @class vtkRegionDensity
 * @brief A density that gives a region of interest a larger or smaller share of a map: exactly Factor times its area.
 *
 * The region is given by a point array (labels by number or by the name of the region, or flags), or by a ball. Put the
 * filter in front of any map and give the map the array RegionDensity as its measure. With s the region's share of the
 * area, its share in the measure is T = f s / (f s + 1 - s); maps that are exact at vertices reach it to rounding.
 * A second one downstream joins the first: both factors hold together, as authalic::densityOfRegions says.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData: triangles, mm |
 * | output 0 | the input with the arrays below |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | cell | RegionDensity | 1 double | | density relative to the native area, > 0 |
 * | point | RegionsOfInterest | 1 unsigned char per region | | 1 in the region |
 * | field | RegionNames | 1 string each | | |
 * | field | RegionFactors, RegionBlends | 1 double each | , mm | as set |
 * | field | RegionSourceShares, RegionTargetShares | 1 double each | | of the area, and of the measure |
 * | field | RegionMeasure | 1 string | | MeasureArrayName of the first |
 *
 * Maps of such a surface add the field RegionImageShares, and `regions` to their report.
 *
 * See su2016 and su2019 in docs/references.bib, and docs/methods/measure-control.md.
 *
 * @sa vtkCurvatureDensity vtkAuthalicMap vtkSphericalAuthalicMap
 */
#ifndef vtkRegionDensity_h
#define vtkRegionDensity_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for RegionArrayName
#include <vector> // for RegionValues

namespace authalic
{
class TriangleMesh;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkRegionDensity : public vtkSurfaceAlgorithm
{
public:
  static vtkRegionDensity* New();
  vtkTypeMacro(vtkRegionDensity, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum RegionModeType
  {
    ARRAY = 0,
    BALL = 1,
    GEODESIC_BALL = 2
  };

  ///@{
  /**
   * What marks the region: a point array; the piece within Radius of Centre in space that is connected to the
   * vertex nearest to Centre; or what is within Radius of that vertex along the surface. Default ARRAY.
   */
  vtkSetClampMacro(RegionMode, int, ARRAY, GEODESIC_BALL);
  vtkGetMacro(RegionMode, int);
  void SetRegionModeToArray() { this->SetRegionMode(ARRAY); }
  void SetRegionModeToBall() { this->SetRegionMode(BALL); }
  void SetRegionModeToGeodesicBall() { this->SetRegionMode(GEODESIC_BALL); }
  ///@}

  ///@{
  /** Point array with one label or flag per vertex (mode ARRAY). Default empty. */
  vtkSetMacro(RegionArrayName, std::string);
  vtkGetMacro(RegionArrayName, std::string);
  ///@}

  ///@{
  /** Values of the array that belong to the region. Neither values nor names = every value but 0. */
  void AddRegionValue(double value);
  void ClearRegionValues();
  int GetNumberOfRegionValues() const { return static_cast<int>(this->RegionValues.size()); }
  ///@}

  ///@{
  /** Names of labels that belong to the region, from the field data `<array>Names` and `<array>Ids`. */
  void AddRegionName(const char* name);
  void ClearRegionNames();
  int GetNumberOfRegionNames() const { return static_cast<int>(this->RegionNames.size()); }
  ///@}

  ///@{
  /** Centre of the ball, mm, in the space of the surface. Default 0 0 0. */
  vtkSetVector3Macro(Centre, double);
  vtkGetVector3Macro(Centre, double);
  ///@}

  ///@{
  /** Radius of the ball, mm, above 0. Default 10. */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /** Times the area of the region relative to the rest, above 0; below 1 it shrinks. Default 4. */
  vtkSetMacro(Factor, double);
  vtkGetMacro(Factor, double);
  ///@}

  ///@{
  /** Width of the transition of the density across the border, mm along the surface, 0 or more. The share stays exact.
   * Default 0: none. */
  vtkSetMacro(Blend, double);
  vtkGetMacro(Blend, double);
  ///@}

  ///@{
  /** A density to multiply: a point or cell array, above 0. Empty = 1, or that of a vtkRegionDensity upstream. Default
   * empty. */
  vtkSetMacro(MeasureArrayName, std::string);
  vtkGetMacro(MeasureArrayName, std::string);
  ///@}

  ///@{
  /** The region's name in reports. Default empty: made of what marks it. */
  vtkSetMacro(RegionLabel, std::string);
  vtkGetMacro(RegionLabel, std::string);
  ///@}

protected:
  vtkRegionDensity() = default;
  ~vtkRegionDensity() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int RegionMode = ARRAY;
  std::string RegionArrayName, MeasureArrayName, RegionLabel;
  std::vector<double> RegionValues;
  std::vector<std::string> RegionNames;
  double Centre[3] = { 0, 0, 0 };
  double Radius = 10;
  double Factor = 4;
  double Blend = 0;

private:
  std::vector<char> Inside(vtkPolyData* input, const authalic::TriangleMesh& mesh) const;
  std::string Label() const;

  vtkRegionDensity(const vtkRegionDensity&) = delete;
  void operator=(const vtkRegionDensity&) = delete;
};

#endif
