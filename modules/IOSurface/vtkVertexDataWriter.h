/**
 * @class vtkVertexDataWriter
 * @brief Writes point arrays of a surface as per-vertex data, whole or not at all.
 *
 * | name ends in | format | arrays |
 * |---|---|---|
 * | .func.gii, .shape.gii | GIFTI metrics, 32-bit float | those named, or every array of one component |
 * | .label.gii | GIFTI labels with the table from field data `<array>Names`, `<array>Ids`, `<array>Colors` | one |
 * | .annot | FreeSurfer annotation with that table; two regions of one colour are refused | one |
 * | .label | FreeSurfer label: the vertices whose value is 1 (not 0), with `<array>Values` when there | one |
 * | .w | FreeSurfer's list of vertices and values; NaN is not listed | one |
 * | .mgh, .mgz | MGH of n×1×1, 32-bit float | one |
 * | .txt | one number per line, "n/a" for NaN | one |
 * | anything else | FreeSurfer morphometry (curv), 32-bit float | one |
 *
 * Field data AnatomicalStructurePrimary (CortexLeft, CortexRight …) goes to the file, where Workbench looks for it.
 * .label.gii and .annot take whole numbers (NaN and -1 = no region); without a table they get one made up from the
 * numbers. GetLoss() says in words what the format had no room for. Names that end in .gz and CIFTI's (.dscalar.nii
 * …) are refused.
 *
 * Write() returns 1 on success; otherwise 0, one sentence goes to the error macro and GetErrorKind() says the kind.
 */
#ifndef vtkVertexDataWriter_h
#define vtkVertexDataWriter_h

#include "vtkAuthalicIOSurfaceModule.h" // for export macro
#include "vtkWriter.h"

#include <string> // for the names of the arrays
#include <vector>

class VTKAUTHALICIOSURFACE_EXPORT vtkVertexDataWriter : public vtkWriter
{
public:
  static vtkVertexDataWriter* New();
  vtkTypeMacro(vtkVertexDataWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file to write. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** The point arrays to write, in this order. None = every array of one component, which must be one alone where the
   * format has room for one. */
  void AddArrayName(const char* name);
  void ClearArrayNames();
  int GetNumberOfArrayNames() const { return static_cast<int>(this->ArrayNames.size()); }
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
  vtkVertexDataWriter() = default;
  ~vtkVertexDataWriter() override;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  char* FileName = nullptr;
  std::vector<std::string> ArrayNames;
  std::vector<std::string> Losses;
  int ErrorKind = 0;

private:
  vtkVertexDataWriter(const vtkVertexDataWriter&) = delete;
  void operator=(const vtkVertexDataWriter&) = delete;
};

#endif
