/**
 * @class vtkCutToDisk
 * @brief Opens a closed surface by removing a region (the medial wall), so that what is left is a disk.
 *
 * The region is given by a point array of labels or flags, or by a plane. Faces that touch a marked vertex go; what
 * the region encloses goes with it; pinched rim vertices are opened. For a genus-0 surface and one region the result
 * is a disk by construction; otherwise an error says what was found and where. Order of vertices and faces is kept.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, triangles, mm |
 * | output 0 | the disk, with the arrays of the input on what is left, and the arrays below |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | point | OriginalPointIds | 1 vtkIdType | | point of the input |
 * | cell | OriginalCellIds | 1 vtkIdType | | triangle of the input |
 * | field | RemovedArea, KeptArea | 1 double | mm² | |
 * | field | LoopLength | 1 double | mm | of the boundary loop |
 * | field | RemovedRegions, IgnoredRegions, FilledIslands | 1 int | | see authalic::CutToDiskResult |
 *
 * @sa vtkCorticalSurface vtkBarycentricMap
 */
#ifndef vtkCutToDisk_h
#define vtkCutToDisk_h

#include "vtkAuthalicFiltersSegmentationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for RegionArrayName
#include <vector> // for RegionValues

class VTKAUTHALICFILTERSSEGMENTATION_EXPORT vtkCutToDisk : public vtkSurfaceAlgorithm
{
public:
  static vtkCutToDisk* New();
  vtkTypeMacro(vtkCutToDisk, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum RegionModeType
  {
    ARRAY = 0,
    PLANE = 1
  };

  ///@{
  /** What marks the region to remove: a point array, or the side of a plane its normal points to. Default ARRAY. */
  vtkSetClampMacro(RegionMode, int, ARRAY, PLANE);
  vtkGetMacro(RegionMode, int);
  void SetRegionModeToArray() { this->SetRegionMode(ARRAY); }
  void SetRegionModeToPlane() { this->SetRegionMode(PLANE); }
  ///@}

  ///@{
  /** Point array with one label or flag per vertex (mode ARRAY). Default "MedialWall". */
  vtkSetMacro(RegionArrayName, std::string);
  vtkGetMacro(RegionArrayName, std::string);
  ///@}

  ///@{
  /** Labels that belong to the region (mode ARRAY). None given = every label but 0. */
  void AddRegionValue(int value);
  void ClearRegionValues();
  int GetNumberOfRegionValues() const { return static_cast<int>(this->RegionValues.size()); }
  ///@}

  ///@{
  /** Whether the region is what to keep (a cortex label) rather than what to remove. Default off. */
  vtkSetMacro(KeepRegion, bool);
  vtkGetMacro(KeepRegion, bool);
  vtkBooleanMacro(KeepRegion, bool);
  ///@}

  ///@{
  /** A point of the plane (mode PLANE), mm. Default 0 0 0. */
  vtkSetVector3Macro(PlaneOrigin, double);
  vtkGetVector3Macro(PlaneOrigin, double);
  ///@}

  ///@{
  /** Normal of the plane, towards the side to remove (mode PLANE); need not be unit. Default 1 0 0. */
  vtkSetVector3Macro(PlaneNormal, double);
  vtkGetVector3Macro(PlaneNormal, double);
  ///@}

  ///@{
  /** Whether only the largest connected piece of the region opens the surface. Default: CutToDiskOptions. */
  vtkSetMacro(LargestRegionOnly, bool);
  vtkGetMacro(LargestRegionOnly, bool);
  vtkBooleanMacro(LargestRegionOnly, bool);
  ///@}

  ///@{
  /** Averaging passes over the region before it is cut, 0 or more: takes spikes and bays off the loop. Points never
   * move. Default: CutToDiskOptions. */
  vtkSetClampMacro(LoopSmoothing, int, 0, VTK_INT_MAX);
  vtkGetMacro(LoopSmoothing, int);
  ///@}

protected:
  vtkCutToDisk();
  ~vtkCutToDisk() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int RegionMode = ARRAY;
  std::string RegionArrayName = "MedialWall";
  std::vector<int> RegionValues;
  bool KeepRegion = false;
  double PlaneOrigin[3] = { 0, 0, 0 };
  double PlaneNormal[3] = { 1, 0, 0 };
  bool LargestRegionOnly;
  int LoopSmoothing;

private:
  std::vector<char> MarkedByArray(vtkPolyData* input) const;

  vtkCutToDisk(const vtkCutToDisk&) = delete;
  void operator=(const vtkCutToDisk&) = delete;
};

#endif
