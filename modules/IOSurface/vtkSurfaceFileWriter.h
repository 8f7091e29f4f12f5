/**
 * @class vtkSurfaceFileWriter
 * @brief Writes a triangle surface in the format that its file name asks for, whole or not at all.
 *
 * | name ends in | format | space | lost |
 * |---|---|---|---|
 * | .gii | GIFTI, compressed base64, little endian | scanner RAS, stated | arrays; coordinates become 32-bit |
 * | .vtp | VTK XML, compressed | scanner RAS, in field data | nothing |
 * | .vtk | legacy VTK 4.2, binary | scanner RAS, in field data | nothing |
 * | .ply | binary, double | comment SPACE=RAS | arrays, field data |
 * | .obj | text, all digits | comment SPACE=RAS | arrays, field data |
 * | .off | text, all digits | not stated | arrays, field data |
 * | .stl | binary | SPACE=RAS in the header | arrays, field data, vertex order; coordinates become 32-bit |
 * | .mz3 | gzipped | not stated | names of arrays, arrays of several components, field data; 32-bit |
 * | .patch.3d, .patch.flat | FreeSurfer patch of the point array OriginalPointIds | that of the whole surface | faces, arrays; coordinates become 32-bit |
 * | none, .white, .pial, .inflated, .sphere … (anything else) | FreeSurfer | tkRAS with the volume geometry, or useRealRAS without | arrays; coordinates become 32-bit |
 *
 * Field data CoordinateSpace, VolumeGeometry, AnatomicalStructurePrimary, AnatomicalStructureSecondary and
 * GeometricType, as vtkSurfaceFileReader gives them, are stored where the format has room. A surface of unknown space
 * is written as it is, and marked unknown where the format can say so.
 *
 * The border of a patch is point array PatchBorder, or without it the ends of the edges of one face. A patch in
 * space is stored in tkRAS when the volume geometry is known, a flat one (every z = 0) as it is. GetLoss() says in
 * words what the format had no room for. Names that end in .gz are refused.
 *
 * Write() returns 1 on success; otherwise 0, one sentence goes to the error macro and GetErrorKind() says the kind.
 */
#ifndef vtkSurfaceFileWriter_h
#define vtkSurfaceFileWriter_h

#include "vtkAuthalicIOSurfaceModule.h" // for export macro
#include "vtkWriter.h"

#include <string> // for the losses
#include <vector>

class vtkPolyData;

class VTKAUTHALICIOSURFACE_EXPORT vtkSurfaceFileWriter : public vtkWriter
{
public:
  static vtkSurfaceFileWriter* New();
  vtkTypeMacro(vtkSurfaceFileWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum WriteSpaceType
  {
    SCANNER_RAS = 0,
    LPS = 1
  };

  ///@{
  /** The file to write. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** The coordinates of the file: SCANNER_RAS (0, default), which FreeSurfer's files turn into tkRAS, or LPS
   * (1), as ITK and 3D Slicer have them: .vtp, .vtk, .ply, .obj and .stl alone, of a surface of known space.
   * In LPS the arrays of three floating-point components (normals, other coordinates) are turned too. */
  vtkSetClampMacro(WriteSpace, int, SCANNER_RAS, LPS);
  vtkGetMacro(WriteSpace, int);
  void SetWriteSpaceToScannerRAS() { this->SetWriteSpace(SCANNER_RAS); }
  void SetWriteSpaceToLPS() { this->SetWriteSpace(LPS); }
  ///@}

  ///@{
  /** What the last Write() could not keep, one sentence each. */
  int GetNumberOfLosses() const { return static_cast<int>(this->Losses.size()); }
  const char* GetLoss(int index) const;
  ///@}

  /** How the last Write() ended, as vtkSurfaceAlgorithm::ErrorKindType. */
  vtkGetMacro(ErrorKind, int);

  /** 1 when the file is there, 0 otherwise. */
  int Write() override;

protected:
  vtkSurfaceFileWriter() = default;
  ~vtkSurfaceFileWriter() override;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  char* FileName = nullptr;
  int WriteSpace = SCANNER_RAS;
  std::vector<std::string> Losses;
  int ErrorKind = 0;

private:
  vtkSurfaceFileWriter(const vtkSurfaceFileWriter&) = delete;
  void operator=(const vtkSurfaceFileWriter&) = delete;
};

#endif
