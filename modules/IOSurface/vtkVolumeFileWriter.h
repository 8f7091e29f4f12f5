/**
 * @class vtkVolumeFileWriter
 * @brief Writes a volume as NIfTI-1 or MGH, whole or not at all.
 *
 * | name ends in | format | voxels | space |
 * |---|---|---|---|
 * | .nii, .nii.gz | NIfTI-1 | integers, floats of 8 to 64 bits, scaled or not | sform; qform when the axes are orthogonal |
 * | .mgh, .mgz | MGH | uint8, int16, int32, float | direction cosines and centre (goodRAS) |
 *
 * NIfTI's code of the transform is that of field TransformCode, else 1 (scanner).
 *
 * The type is the narrowest of these that gives every value back exactly: that of field StoredType with its scaling
 * (Slope, Intercept), int32, that of the scalars, float; where the format has none that does, float, with rounding that
 * GetLoss() tells. The point scalars have one component, or one per frame (field Frames). Fields TimeStep, NiftiNotes
 * and MghNotes are those of vtkVolumeFileReader with KeepNumbers.
 *
 * Physical coordinates (origin, spacing, direction matrix) are taken to be scanner RAS mm; a volume whose field
 * CoordinateSpace says "unknown" is refused, because the file would claim to know. GetLoss() says in words what the
 * format had no room for.
 *
 * Write() returns 1 on success; otherwise 0, one sentence goes to the error macro and GetErrorKind() says the kind.
 */
#ifndef vtkVolumeFileWriter_h
#define vtkVolumeFileWriter_h

#include "vtkAuthalicIOSurfaceModule.h" // for export macro
#include "vtkWriter.h"

#include <string> // for the losses
#include <vector>

class VTKAUTHALICIOSURFACE_EXPORT vtkVolumeFileWriter : public vtkWriter
{
public:
  static vtkVolumeFileWriter* New();
  vtkTypeMacro(vtkVolumeFileWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file to write. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
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
  vtkVolumeFileWriter() = default;
  ~vtkVolumeFileWriter() override;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  char* FileName = nullptr;
  std::vector<std::string> Losses;
  int ErrorKind = 0;

private:
  vtkVolumeFileWriter(const vtkVolumeFileWriter&) = delete;
  void operator=(const vtkVolumeFileWriter&) = delete;
};

#endif
