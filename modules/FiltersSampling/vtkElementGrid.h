/**
 * @class vtkElementGrid
 * @brief Cortical elements: an isotropic grid on the image of a map, pulled back to the surface.
 *
 * The preimage of a grid cell is an element. On an area-preserving map all interior elements have the same native
 * area; ElementAreaRatio says how nearly. Faces that straddle a grid line are split exactly. See zou2011 in
 * docs/references.bib.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, a map: triangles in the plane z = 0 with the point array `OriginalPoints` (mm) |
 * | output 0 | the map with the arrays below |
 * | output 1 | vtkPolyData, lines: the borders between elements on the surface (mm), point array `ImagePoints` |
 * | output 2 | vtkPolyData, quadrilaterals: the cells of the grid in the domain, with one row of arrays per element |
 *
 * | port | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|---|
 * | 0 | point, cell | ElementId | 1 int | | element of the largest part of the vertex or face, from 1; 0 = none |
 * | 0 | field | ElementGridOptions | 4 double | | what vtkElementStatistics needs to repeat the grid |
 * | 0 | field | Elements, GridColumns, GridRows, InteriorElements | 1 int | | |
 * | 0 | field | InteriorMaximumDeviation, InteriorMeanDeviation, MaximumDeviation, MeanDeviation | 1 double | | of area / target - 1, absolute |
 * | 1 | cell | ElementIds | 2 int | | the elements on the two sides |
 * | 2 | cell | ElementId | 1 int | | from 1 |
 * | 2 | cell | ElementArea, TargetArea | 1 double | mm² | |
 * | 2 | cell | ElementAreaRatio | 1 double | | area / target |
 * | 2 | cell | Interior | 1 unsigned char | | 1 = one whole cell |
 * | 2 | cell | Centroid | 3 double | mm | |
 *
 * @sa vtkElementStatistics vtkDiscreteLieFlow
 */
#ifndef vtkElementGrid_h
#define vtkElementGrid_h

#include "vtkAuthalicFiltersSamplingModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

class VTKAUTHALICFILTERSSAMPLING_EXPORT vtkElementGrid : public vtkSurfaceAlgorithm
{
public:
  static vtkElementGrid* New();
  vtkTypeMacro(vtkElementGrid, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FrameType
  {
    AUTOMATIC = 0,
    UNIT_DISK = 1,
    BOUNDING_BOX = 2
  };

  ///@{
  /** How many elements are wanted; the nearest grid is taken. Default: authalic::ElementGridOptions, as below. */
  vtkSetClampMacro(NumberOfElements, int, 1, 4000000);
  vtkGetMacro(NumberOfElements, int);
  ///@}

  ///@{
  /** Wanted native area of an element, mm²; above 0 it decides instead of NumberOfElements. */
  vtkSetClampMacro(ElementArea, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ElementArea, double);
  ///@}

  ///@{
  /** The rectangle that is divided: [-1, 1]² for maps to the unit disk, else the bounding box. */
  vtkSetClampMacro(Frame, int, AUTOMATIC, BOUNDING_BOX);
  vtkGetMacro(Frame, int);
  void SetFrameToAutomatic() { this->SetFrame(AUTOMATIC); }
  void SetFrameToUnitDisk() { this->SetFrame(UNIT_DISK); }
  void SetFrameToBoundingBox() { this->SetFrame(BOUNDING_BOX); }
  ///@}

  ///@{
  /** A cell covered by less than this fraction joins a neighbour, 0 to 0.5. */
  vtkSetClampMacro(MergeBelow, double, 0.0, 0.5);
  vtkGetMacro(MergeBelow, double);
  ///@}

protected:
  vtkElementGrid();
  ~vtkElementGrid() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int NumberOfElements;
  double ElementArea;
  int Frame;
  double MergeBelow;

private:
  vtkElementGrid(const vtkElementGrid&) = delete;
  void operator=(const vtkElementGrid&) = delete;
};

#endif
