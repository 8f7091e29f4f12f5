/**
 * @class vtkSurfaceFileReader
 * @brief Reads a triangle surface of any known format, in scanner RAS mm where the file says how.
 *
 * FreeSurfer, GIFTI (.gii, .gii.gz), MZ3, OFF, PLY and OBJ are read by Authalic's own readers, .vtp, legacy .vtk and
 * .stl by VTK's. Polygons and strips become triangles, lines and vertices are dropped, equal points of STL are
 * merged. A FreeSurfer patch takes its faces from the surface it was cut from, WholeFileName.
 *
 * Output (port 0, vtkPolyData): points in double precision, triangles in the order of the file, the arrays of .vtp
 * and .vtk, overlays of .mz3 as `Overlay`, `Overlay2` … (float) and its colours as `Colors` (4 unsigned chars), of a
 * patch `OriginalPointIds` and `PatchBorder` (int, 1 on the border). Points are brought to scanner RAS mm when the
 * file states its space or AssumeSpace asserts it, tkRAS by the full formula x = D P⁻¹ x_tk + c_ras; otherwise they
 * stay as they are and CoordinateSpace is "unknown". The words of 3D Slicer (SPACE=LPS or RAS in the header, the field
 * SPACE of .vtp) go before a field CoordinateSpace of the file: Slicer leaves that when it turns the coordinates.
 *
 * | field data | type | meaning |
 * |---|---|---|
 * | CoordinateSpace | text | "scanner-ras" or "unknown" |
 * | CoordinateSpaceReason | text | how that was decided |
 * | VolumeGeometry | double[18] | FreeSurfer's volume geometry, when known: dimensions, voxel size, xras, yras, zras, c_ras |
 * | VolumeGeometryFile | text | its file name |
 * | AnatomicalStructurePrimary, AnatomicalStructureSecondary, GeometricType, TopologicalType, Name | text | from GIFTI |
 *
 * On failure one sentence goes to the error macro, the output is empty, GetErrorKind() and GetErrorCode() are set.
 */
#ifndef vtkSurfaceFileReader_h
#define vtkSurfaceFileReader_h

#include "vtkAuthalicIOSurfaceModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for what was not read

class VTKAUTHALICIOSURFACE_EXPORT vtkSurfaceFileReader : public vtkSurfaceAlgorithm
{
public:
  static vtkSurfaceFileReader* New();
  vtkTypeMacro(vtkSurfaceFileReader, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum AssumeSpaceType
  {
    AS_STATED = 0,
    SCANNER_RAS = 1,
    TK_RAS = 2,
    LPS = 3,
    VOXEL = 4
  };

  ///@{
  /** The file to read. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** The space to take the coordinates to be in whatever the file says: AS_STATED (0, believe the file; default),
   * SCANNER_RAS (1), TK_RAS (2), LPS (3), VOXEL (4; indices, whole numbers at the middles of voxels). TK_RAS and VOXEL
   * need the volume geometry: of VolumeFileName, else the one that the file carries. */
  vtkSetClampMacro(AssumeSpace, int, AS_STATED, VOXEL);
  vtkGetMacro(AssumeSpace, int);
  void SetAssumeSpaceToAsStated() { this->SetAssumeSpace(AS_STATED); }
  void SetAssumeSpaceToScannerRAS() { this->SetAssumeSpace(SCANNER_RAS); }
  void SetAssumeSpaceToTkRAS() { this->SetAssumeSpace(TK_RAS); }
  void SetAssumeSpaceToLPS() { this->SetAssumeSpace(LPS); }
  void SetAssumeSpaceToVoxel() { this->SetAssumeSpace(VOXEL); }
  ///@}

  ///@{
  /** The volume that the surface belongs to (NIfTI or MGH): its geometry goes before the one that the file carries.
   * Default none. */
  vtkSetFilePathMacro(VolumeFileName);
  vtkGetFilePathMacro(VolumeFileName);
  ///@}

  ///@{
  /** The surface that a FreeSurfer patch was cut from; not used for other files. Default none. */
  vtkSetFilePathMacro(WholeFileName);
  vtkGetFilePathMacro(WholeFileName);
  ///@}

  /** What else the last file held that the output does not: tags, further arrays, metadata of other names. Empty when
   * nothing. */
  const char* GetNotRead() const { return this->NotRead.c_str(); }

protected:
  vtkSurfaceFileReader();
  ~vtkSurfaceFileReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  char* FileName = nullptr;
  char* WholeFileName = nullptr;
  char* VolumeFileName = nullptr;
  int AssumeSpace = AS_STATED;
  std::string NotRead;

private:
  vtkSurfaceFileReader(const vtkSurfaceFileReader&) = delete;
  void operator=(const vtkSurfaceFileReader&) = delete;
};

#endif
