/**
 * @class vtkVolumeFileReader
 * @brief Reads a NIfTI-1, NIfTI-2 or MGH volume so that physical coordinates are scanner RAS mm.
 *
 * Output (port 0, vtkImageData): point scalars `Values`, int when the file holds whole numbers of up to 32 bits without
 * scaling, else float with scl_slope and scl_inter applied and NaN kept. Origin, spacing and direction matrix come from
 * the affine of the file, voxels stay in its order: voxel (i, j, k) has its centre where the file says. The extent
 * starts at 0. AllFrames gives one component per frame. KeepNumbers gives the type of the file, double where it scales,
 * and the fields from which vtkVolumeFileWriter writes the same file again.
 *
 * | field data | type | meaning |
 * |---|---|---|
 * | CoordinateSpace | text | "scanner-ras", or "unknown" when the file does not orient itself |
 * | CoordinateSpaceReason | text | which transform was used |
 * | Frames | int | frames in the file |
 * | TransformCode | int | NIfTI's code of the transform used: 1 scanner, 2 aligned, 3 Talairach, 4 MNI 152, 5 template; 0 none |
 * | StoredType | text | type of the voxels in the file: int16, uint8 with scaling … |
 * | TransformDisagreement | double | mm between where sform and qform put the farthest corner (absent up to 0.001) |
 * | Slope, Intercept | double | of KeepNumbers, where the file scales |
 * | TimeStep | double | of KeepNumbers: s between frames, or the repetition time (absent when not stated) |
 * | NiftiNotes, MghNotes | uchar[] | of KeepNumbers: header, extensions and tags as the format has them |
 * | NotRead | text | what else the file holds: description, extensions, tags (absent when nothing) |
 * | Warnings | text[] | sform and qform disagree, units not stated … (absent when there is none) |
 *
 * The file is read once, when the pipeline asks for its information, and handed on by the request for data. On failure
 * one sentence goes to the error macro, GetErrorKind() and GetErrorCode() are set.
 */
#ifndef vtkVolumeFileReader_h
#define vtkVolumeFileReader_h

#include "vtkAuthalicIOSurfaceModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for the file between the two requests

namespace authalic
{
struct StoredVolume;
}

class VTKAUTHALICIOSURFACE_EXPORT vtkVolumeFileReader : public vtkImageAlgorithm
{
public:
  static vtkVolumeFileReader* New();
  vtkTypeMacro(vtkVolumeFileReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file to read: .nii, .nii.gz, .hdr/.img (also gzipped), .mgh or .mgz. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** Which frame of a file of more than three dimensions, from 0. Default 0. */
  vtkSetClampMacro(Frame, int, 0, VTK_INT_MAX);
  vtkGetMacro(Frame, int);
  ///@}

  ///@{
  /** Every frame, as a component of the scalars, in place of Frame. Default off. */
  vtkSetMacro(AllFrames, bool);
  vtkGetMacro(AllFrames, bool);
  vtkBooleanMacro(AllFrames, bool);
  ///@}

  ///@{
  /** Numbers in the type of the file, 64-bit where it scales, in place of int and float; and its notes as fields, for
   * writing it again without loss. Default off. */
  vtkSetMacro(KeepNumbers, bool);
  vtkGetMacro(KeepNumbers, bool);
  vtkBooleanMacro(KeepNumbers, bool);
  ///@}

  enum TransformType
  {
    AUTOMATIC = 0,
    SFORM = 1,
    QFORM = 2
  };

  ///@{
  /** Which transform of a NIfTI file places its voxels: AUTOMATIC (0; the sform if its code is above 0, else the qform;
   * default), SFORM (1), QFORM (2). One that is not there is an error. */
  vtkSetClampMacro(Transform, int, AUTOMATIC, QFORM);
  vtkGetMacro(Transform, int);
  void SetTransformToAutomatic() { this->SetTransform(AUTOMATIC); }
  void SetTransformToSform() { this->SetTransform(SFORM); }
  void SetTransformToQform() { this->SetTransform(QFORM); }
  ///@}

  /** How the last execution ended, as vtkSurfaceAlgorithm::ErrorKindType: 0 well, 5 the file is at fault. */
  vtkGetMacro(ErrorKind, int);

protected:
  vtkVolumeFileReader();
  ~vtkVolumeFileReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  char* FileName = nullptr;
  int Frame = 0;
  bool AllFrames = false;
  bool KeepNumbers = false;
  int Transform = AUTOMATIC;
  int ErrorKind = 0;

private:
  vtkVolumeFileReader(const vtkVolumeFileReader&) = delete;
  void operator=(const vtkVolumeFileReader&) = delete;

  void ReadFile();

  std::shared_ptr<const authalic::StoredVolume> File;
  vtkMTimeType ReadTime = 0;
};

#endif
