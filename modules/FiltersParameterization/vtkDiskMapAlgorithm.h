/**
 * @class vtkDiskMapAlgorithm
 * @brief What the maps of a topological disk to a planar domain share: the domain.
 *
 * Input 0 must be connected, oriented, manifold, of genus 0 and have one boundary loop. Ports and arrays: see
 * vtkSurfaceMapAlgorithm.
 */
#ifndef vtkDiskMapAlgorithm_h
#define vtkDiskMapAlgorithm_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceMapAlgorithm.h"

#include <vector> // for PolygonCorners

namespace authalic
{
class Json;
class PlanarDomain;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkDiskMapAlgorithm : public vtkSurfaceMapAlgorithm
{
public:
  vtkTypeMacro(vtkDiskMapAlgorithm, vtkSurfaceMapAlgorithm);
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

protected:
  vtkDiskMapAlgorithm() = default;
  ~vtkDiskMapAlgorithm() override = default;

  /** The domain that the properties describe. @throws InvalidArgument */
  authalic::PlanarDomain MakeDomain() const;

  /** Domain and measure as the options of a report. */
  authalic::Json DescribeOptions() const;

  int Domain = DISK;
  double Aspect = 2.0;
  std::vector<double> PolygonCorners;

private:
  vtkDiskMapAlgorithm(const vtkDiskMapAlgorithm&) = delete;
  void operator=(const vtkDiskMapAlgorithm&) = delete;
};

#endif
