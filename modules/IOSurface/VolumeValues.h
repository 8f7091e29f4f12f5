/// @file
/// Voxels between files and VTK's arrays. Private to IOSurface/.
#pragma once

#include <string>

#include <vtkSmartPointer.h>

#include "Formats/StoredVolume.h"

class vtkDataArray;
class vtkImageData;

namespace authalic {

/// VTK's type of valuesOf().
[[nodiscard]] int scalarTypeOf(const StoredVolume& volume, bool keepNumbers);

/// Scalars `Values`, one component per frame, with slope and intercept applied. With `keepNumbers` in the type of the
/// file, 64-bit floats where it scales; else int where that is exact, float otherwise.
[[nodiscard]] vtkSmartPointer<vtkDataArray> valuesOf(const StoredVolume& volume, bool keepNumbers);

/// Slope, intercept, time step and notes as field data, from which toStored() takes them.
void setNotes(vtkImageData* output, const StoredVolume& volume);

/// What is written to a file of that name, and by how much its values are rounded.
struct VolumeToWrite {
  StoredVolume volume;
  double rounding = 0;
};

/// The scalars in the narrowest of these types that the format holds and that gives every value back exactly: field
/// `StoredType` with its scaling, int32, the array's own, float32; float32 with rounding where none does.
[[nodiscard]] VolumeToWrite toStored(const std::string& path, vtkImageData* volume);

}  // namespace authalic
