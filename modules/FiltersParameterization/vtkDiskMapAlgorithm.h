/**
 * @class vtkDiskMapAlgorithm
 * @brief What the maps of a topological disk share: the planar domain, the measure, the arrays of the output.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData: triangles, mm; connected, oriented, manifold, genus 0, one boundary loop |
 * | output 0 | vtkPolyData, the map: the points are the image (z = 0, double), triangles and vertices in the order of the input, every array of the input, and the arrays below |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | point | OriginalPoints | 3 double | mm | the surface |
 * | point | VertexAreaDistortion | 1 double | log2 | log2 of image share / target share of one-third stars |
 * | cell | AreaDistortion | 1 double | log2 | log2 of image share / target share |
 * | cell | AngleDistortion | 1 double | | σ1/σ2 + σ2/σ1; 2 = angles preserved |
 * | cell | Flipped | 1 unsigned char | | 1 where the face is folded or has no area in the image |
 * | field | Status | 1 string | | converged, not-converged, stalled, cancelled |
 * | field | Iterations | 1 int | | |
 * | field | Residuals | 1 double each | | history of what the method drives to 0 |
 * | field | TotalAreaDistortion … | 1 | | one number per metric of authalic::DistortionSummary |
 */
#ifndef vtkDiskMapAlgorithm_h
#define vtkDiskMapAlgorithm_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for MeasureArrayName
#include <vector> // for PolygonCorners

namespace authalic
{
class Json;
class PlanarDomain;
struct MapReport;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkDiskMapAlgorithm : public vtkSurfaceAlgorithm
{
public:
  vtkTypeMacro(vtkDiskMapAlgorithm, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum DomainType
  {
    DISK = 0,
    SQUARE = 1,
    RECTANGLE = 2,
    POLYGON = 3
  };

  ///@{
  /** Where to: the unit disk, the unit square, [0, Aspect] × [0, 1], or the polygon. Default DISK. */
  vtkSetClampMacro(Domain, int, DISK, POLYGON);
  vtkGetMacro(Domain, int);
  void SetDomainToDisk() { this->SetDomain(DISK); }
  void SetDomainToSquare() { this->SetDomain(SQUARE); }
  void SetDomainToRectangle() { this->SetDomain(RECTANGLE); }
  void SetDomainToPolygon() { this->SetDomain(POLYGON); }
  ///@}

  ///@{
  /** Width / height of the rectangle, 0.01 to 100. Default 2. */
  vtkSetMacro(Aspect, double);
  vtkGetMacro(Aspect, double);
  ///@}

  ///@{
  /** Corners of the polygon in order, either way round; at least 3. Default none. */
  void AddPolygonCorner(double x, double y);
  void ClearPolygonCorners();
  int GetNumberOfPolygonCorners() const { return static_cast<int>(this->PolygonCorners.size() / 2); }
  ///@}

  ///@{
  /**
   * Target measure: a density relative to the native area, one number per point or per cell, at least 0; a region
   * with 4 gets four times the share that its area has. The point array of that name is taken before the cell array.
   * Empty = 1 everywhere. Default empty.
   */
  vtkSetMacro(MeasureArrayName, std::string);
  vtkGetMacro(MeasureArrayName, std::string);
  ///@}

  ///@{
  /**
   * What the last execution said in field data: how the method ended (converged, not-converged, stalled, cancelled),
   * iterations, D_area and D_angle (2 = preserved), and folded faces. Empty or 0 before it and after an error.
   */
  std::string GetStatus();
  int GetIterations();
  double GetTotalAreaDistortion();
  double GetTotalAngleDistortion();
  int GetFlippedFaces();
  ///@}

  /**
   * What the last execution did, as JSON: status, iterations, residual history, seconds per stage, metrics, flips,
   * topology, options, version. Empty before it and after an error.
   */
  vtkGetMacro(Report, std::string);

protected:
  vtkDiskMapAlgorithm() = default;
  ~vtkDiskMapAlgorithm() override = default;

  /** The domain that the properties describe. @throws InvalidArgument */
  authalic::PlanarDomain MakeDomain() const;

  /** Domain and measure as the options of a report. */
  authalic::Json DescribeOptions() const;

  /** Arrays from `report` (method, status, residuals), Report and ErrorKind; the image is on `map` already. */
  void Publish(vtkPolyData* map, const authalic::MapReport& report);

  int Domain = DISK;
  double Aspect = 2.0;
  std::vector<double> PolygonCorners;
  std::string MeasureArrayName;
  std::string Report;

private:
  vtkDiskMapAlgorithm(const vtkDiskMapAlgorithm&) = delete;
  void operator=(const vtkDiskMapAlgorithm&) = delete;
};

#endif
