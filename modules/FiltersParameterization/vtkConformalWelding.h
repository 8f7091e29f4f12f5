/**
 * @class vtkConformalWelding
 * @brief Glues two maps to the unit disk along their circles into one map to the unit sphere.
 *
 * The boundary vertices that belong together (the welding signature) are those with the same number in the point
 * array SignatureArrayName, or, without it, those at the same place of the surfaces: the two halves of one cut. Both
 * images are followed by the conformal maps of the welding, so that conformal maps of the halves give a conformal map
 * of the whole surface.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, a map of a disk to the unit disk, with the point array OriginalPoints |
 * | input 1 | vtkPolyData, another one; its boundary has as many vertices |
 * | output 0 | vtkPolyData, the closed surface on the unit sphere: vertices and faces of input 0, then those that input 1 adds |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | point | OriginalPoints | 3 double | mm | the surface |
 * | point | OriginalPointIds | 1 id | | vertex of its input; of input 0 on the seam |
 * | point | Disk | 1 int | | 1, 2: the input; 0 on the seam |
 * | cell | OriginalCellIds | 1 id | | face of its input |
 * | cell | Disk | 1 int | | 1, 2: the input |
 * | field | BoundaryMismatch, MidpointMismatch | 1 double | | largest distance of the two images of a seam point, and between seam points, on the unit sphere |
 * | field | SeamPoints | 1 int | | |
 * | field | CentreOfMass | 1 double | | see vtkSphericalConformalMap |
 *
 * and every distortion array of vtkSurfaceMapAlgorithm. See sharon2006, marshall2007 and nadeem2017 in
 * docs/references.bib, and docs/methods/conformal-welding.md.
 *
 * @sa vtkSphericalConformalMap, which cuts, maps and welds by itself
 */
#ifndef vtkConformalWelding_h
#define vtkConformalWelding_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for SignatureArrayName and Report

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkConformalWelding : public vtkSurfaceAlgorithm
{
public:
  static vtkConformalWelding* New();
  vtkTypeMacro(vtkConformalWelding, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Point array of whole numbers of both inputs: boundary vertices with the same number are glued; inner vertices
   * may have any. Empty = boundary vertices at the same place of the surfaces. Default empty.
   */
  vtkSetMacro(SignatureArrayName, std::string);
  vtkGetMacro(SignatureArrayName, std::string);
  ///@}

  ///@{
  /**
   * Whether the centre of mass of the surface is moved to 0 and the sphere turned closest to the surface; else the
   * centre of disk 1 is the north and that of disk 2 the south pole. Default on.
   */
  vtkSetMacro(Normalise, bool);
  vtkGetMacro(Normalise, bool);
  vtkBooleanMacro(Normalise, bool);
  ///@}

  /** What the last execution did, as JSON, like that of vtkSurfaceMapAlgorithm; empty before it and after an error. */
  vtkGetMacro(Report, std::string);

protected:
  vtkConformalWelding();
  ~vtkConformalWelding() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  std::string SignatureArrayName;
  std::string Report;
  bool Normalise = true;

private:
  vtkConformalWelding(const vtkConformalWelding&) = delete;
  void operator=(const vtkConformalWelding&) = delete;
};

#endif
