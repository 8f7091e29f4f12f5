/// @file
/// The measure that a verb takes: a density, regions of interest, and curvature, as flags.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>

#include "Files.h"

class vtkPolyData;

namespace authalic::cli {

/// What --measure, --roi, --roi-blend, --curvature-measure and --curvature-weight were given.
struct DensityOptions {
  std::string measure, curvature;
  std::vector<std::string> regions;
  std::optional<double> blend, curvatureWeight;

  void declare(CLI::App* verb);

  /// Adds the arrays that were asked for to the surface.
  /// @returns the name of the array that a map shall take as its measure; empty for none
  /// @throws Failure
  [[nodiscard]] std::string apply(vtkSmartPointer<vtkPolyData>& surface, const Session& session) const;
};

/// Says on stderr what every region of interest of a surface or map has of the area, of the measure, and of the image.
void sayRegions(vtkPolyData* surfaceOrMap, const Session& session);

}  // namespace authalic::cli
