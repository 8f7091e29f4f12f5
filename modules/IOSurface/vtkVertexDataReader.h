/**
 * @class vtkVertexDataReader
 * @brief Adds the per-vertex data of a file to the surface they belong to.
 *
 * | file | point arrays added |
 * |---|---|
 * | FreeSurfer curv, thickness, sulc, area (new and old), .w, text | one, float; .w is NaN where nothing is listed |
 * | .mgh, .mgz, .nii, .nii.gz of n×1×1 | one per frame, float |
 * | .func.gii, .shape.gii, .time.gii … | one per array of the file, float; sparse ones (NODE_INDEX) are NaN where nothing is listed |
 * | .mz3 | one per overlay, float |
 * | .dscalar.nii, .dtseries.nii (CIFTI-2) | one per map, float; NaN where the map has no value |
 * | .dlabel.nii | one per map, int, with its regions as below; -1 where the map has no value |
 * | .annot, .label.gii | one, int: the id of the region, -1 = none; field data `<array>Names` (text), `<array>Ids` (int), `<array>Colors` (4 unsigned chars) |
 * | FreeSurfer .label | one, int: 1 for the vertices listed, else 0; `<array>Values` (float) when the file has values other than 0 |
 *
 * Gzip is undone. NaN means no value. Signs are as in the file: FreeSurfer's curv and sulc are positive in sulci.
 * The surface passes through with everything it has. The file must hold one value for each point, otherwise the error
 * says how many there are of either. Where the surface was cut from another (point array OriginalPointIds), a file
 * for that one does too: every point takes the value of its original, and a .label names originals.
 *
 * The surface may be left out. Then the output has one point for each value, all at the origin, and no faces; files
 * that list some vertices only (.w, .label, NODE_INDEX) are refused, because they do not say how many there are.
 */
#ifndef vtkVertexDataReader_h
#define vtkVertexDataReader_h

#include "vtkAuthalicIOSurfaceModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for what was not read

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
   * hemisphere and extension (lh.thickness → thickness). Second and further arrays of a GIFTI file of the same name
   * get their number after it. */
  vtkSetStringMacro(ArrayName);
  vtkGetStringMacro(ArrayName);
  ///@}

  ///@{
  /** Which surface of a CIFTI file to take, by GIFTI's name: CortexLeft, CortexRight, Cerebellum … Default empty: the
   * one that field AnatomicalStructurePrimary of the input names, else the only one of its number of vertices. */
  vtkSetStringMacro(Structure);
  vtkGetStringMacro(Structure);
  ///@}

  /** What else the last file held that the output does not: other surfaces of a CIFTI file and its voxels. Empty when
   * nothing. */
  const char* GetNotRead() const { return this->NotRead.c_str(); }

protected:
  vtkVertexDataReader() = default;
  ~vtkVertexDataReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  char* FileName = nullptr;
  char* ArrayName = nullptr;
  char* Structure = nullptr;
  std::string NotRead;

private:
  vtkVertexDataReader(const vtkVertexDataReader&) = delete;
  void operator=(const vtkVertexDataReader&) = delete;
};

#endif
