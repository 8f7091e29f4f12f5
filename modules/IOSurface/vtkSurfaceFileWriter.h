/**
 * @class vtkSurfaceFileWriter
 * @brief Writes a triangle surface in the format that its file name asks for, whole or not at all.
 *
 * | name ends in | format | space | lost |
 * |---|---|---|---|
 * | .gii | GIFTI, compressed base64, little endian | scanner RAS, stated | arrays; coordinates become 32-bit |
 * | .vtp | VTK XML, compressed | scanner RAS, in field data | nothing |
 * | .vtk | legacy VTK 4.2, binary | scanner RAS, in field data | nothing |
 * | .ply | binary, double | not stated | arrays, field data |
 * | .off, .obj | text, all digits | not stated | arrays, field data |
 * | .stl | binary | not stated | arrays, field data, vertex order; coordinates become 32-bit |
 * | none, .white, .pial, .inflated, .sphere … (anything else) | FreeSurfer | tkRAS with the volume geometry, or useRealRAS without | arrays; coordinates become 32-bit |
 *
 * Field data CoordinateSpace, VolumeGeometry, AnatomicalStructurePrimary, AnatomicalStructureSecondary and
 * GeometricType, as vtkSurfaceFileReader gives them, are stored where the format has room. A surface of unknown space
 * is written as it is, and marked unknown where the format can say so.
 *
 * Write() returns 1 on success; otherwise 0, one sentence goes to the error macro and GetErrorKind() says the kind.
 */
#ifndef vtkSurfaceFileWriter_h
#define vtkSurfaceFileWriter_h

#include "vtkAuthalicIOSurfaceModule.h" // for export macro
#include "vtkWriter.h"

class vtkPolyData;

class VTKAUTHALICIOSURFACE_EXPORT vtkSurfaceFileWriter : public vtkWriter
{
public:
  static vtkSurfaceFileWriter* New();
  vtkTypeMacro(vtkSurfaceFileWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file to write. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
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
  int ErrorKind = 0;

private:
  vtkSurfaceFileWriter(const vtkSurfaceFileWriter&) = delete;
  void operator=(const vtkSurfaceFileWriter&) = delete;
};

#endif
