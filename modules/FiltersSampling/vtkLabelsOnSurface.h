/**
 * @class vtkLabelsOnSurface
 * @brief Carries the labels of a volume to the vertices of a surface: the nearest labelled voxel within reach.
 *
 * A white surface lies inside the grey matter that atlases label, so that reading labels at the vertex misses most of
 * them; 2 to 5 mm is a useful reach. Vertices without a labelled voxel in reach get 0. A map may be given as the
 * surface: its `OriginalPoints` are used.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData: triangles, scanner RAS mm; or a map with the point array `OriginalPoints` |
 * | input 1 | vtkImageData: labels, scanner RAS mm |
 * | output 0 | input 0 with the array below |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | point | the value of ArrayName | 1 int | | label; 0 = none |
 */
#ifndef vtkLabelsOnSurface_h
#define vtkLabelsOnSurface_h

#include "vtkAuthalicFiltersSamplingModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for ArrayName

class VTKAUTHALICFILTERSSAMPLING_EXPORT vtkLabelsOnSurface : public vtkSurfaceAlgorithm
{
public:
  static vtkLabelsOnSurface* New();
  vtkTypeMacro(vtkLabelsOnSurface, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Reach, mm, above 0 and at most 50. Default 5. */
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /** Name of the point array that is made. Default "Label". */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

protected:
  vtkLabelsOnSurface();
  ~vtkLabelsOnSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  double MaximumDistance = 5.0;
  std::string ArrayName = "Label";

private:
  vtkLabelsOnSurface(const vtkLabelsOnSurface&) = delete;
  void operator=(const vtkLabelsOnSurface&) = delete;
};

#endif
