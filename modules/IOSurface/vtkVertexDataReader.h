/**
 * @class vtkVertexDataReader
 * @brief Adds the per-vertex data of a file to the surface they belong to.
 *
 * | file | point arrays added |
 * |---|---|
 * | FreeSurfer curv, thickness, sulc, area (new and old), .mgh/.mgz of n×1×1, text | one, float |
 * | .func.gii, .shape.gii, .time.gii … | one per array of the file, float |
 * | .annot, .label.gii | one, int: the id of the region, -1 = none; field data `<array>Names` (text), `<array>Ids` (int), `<array>Colors` (4 unsigned chars) |
 * | FreeSurfer .label | one, int: 1 for the vertices listed, else 0 |
 *
 * Gzip is undone. NaN means no value. Signs are as in the file: FreeSurfer's curv and sulc are positive in sulci.
 * The surface passes through with everything it has. The file must hold one value for each point, otherwise the error
 * says how many there are of either. Where the surface was cut from another (point array OriginalPointIds), a file for
 * that one does too: every point takes the value of its original, and a .label names originals.
 */
#ifndef vtkVertexDataReader_h
#define vtkVertexDataReader_h

#include "vtkAuthalicIOSurfaceModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

class VTKAUTHALICIOSURFACE_EXPORT vtkVertexDataReader : public vtkSurfaceAlgorithm
{
public:
  static vtkVertexDataReader* New();
  vtkTypeMacro(vtkVertexDataReader, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file to read. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** Name of the array. Default empty: the name that GIFTI gives the array, else the name of the file without folder,
   * hemisphere and extension (lh.thickness → thickness). Second and further arrays of a GIFTI file of the same name get
   * their number after it. */
  vtkSetStringMacro(ArrayName);
  vtkGetStringMacro(ArrayName);
  ///@}

protected:
  vtkVertexDataReader() = default;
  ~vtkVertexDataReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  char* FileName = nullptr;
  char* ArrayName = nullptr;

private:
  vtkVertexDataReader(const vtkVertexDataReader&) = delete;
  void operator=(const vtkVertexDataReader&) = delete;
};

#endif
