/// @file
/// What a format has no room for, one sentence each. Private to IOSurface/.
#pragma once

#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace authalic {

struct VolumeToWrite;

/// Of a surface written under that name: arrays, space, volume geometry, metadata, digits of the coordinates.
[[nodiscard]] std::vector<std::string> surfaceLosses(const std::string& path, vtkPolyData* surface);

/// Of point arrays written under that name: names, tables of regions, digits, the structure.
[[nodiscard]] std::vector<std::string> vertexDataLosses(const std::string& path, vtkPolyData* surface,
                                                        const std::vector<std::string>& arrays);

/// Of a volume written under that name: digits of values and affine, the kind of space, what the reader passed over.
[[nodiscard]] std::vector<std::string> volumeLosses(const std::string& path, vtkImageData* volume,
                                                    const VolumeToWrite& written);

}  // namespace authalic
