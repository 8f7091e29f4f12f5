/// @file
/// The arrays that every map carries (docs/arrays.md). Private to FiltersParameterization/.
#pragma once

#include <string>
#include <vector>

#include "Core/authalic/TargetMeasure.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Core/mesh/TriangleMesh.h"
#include "vtkAuthalicFiltersParameterizationModule.h"

class vtkPolyData;

namespace authalic {

/// Cell arrays AreaDistortion, AngleDistortion, BeltramiCoefficient and Flipped, point array VertexAreaDistortion, one
/// field-data number per metric of DistortionSummary, named as there with a capital first letter, for each of its
/// spreads NAME the numbers NAMEStandardDeviation and NAMEPercentiles (5, 25, 50, 75, 95, 99 %, maximum), and the
/// histograms of HistogramArrays.h.
VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT void addDistortion(vtkPolyData* map, const Distortion& distortion);

/// Makes `map` the image of `input`: the arrays of `input` pass through, points become `image` (z = 0, double),
/// `OriginalPoints` holds the surface, and the distortion arrays are added; where `input` has regions of interest, also
/// their shares (RegionArrays.h).
/// @param target  m target measures, or empty for the surface areas
VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT Distortion fillMap(vtkPolyData* input, vtkPolyData* map,
                                                             const TriangleMesh& surface, const Points2& image,
                                                             const Eigen::VectorXd& target = {});

/// The same for an image on the unit sphere (n×3), with the field data that only a sphere has: Coverage (Σ solid
/// angles / 4π), FlatAreaDistortion (D_area of the flat triangles) and SphericalAngleError (degrees).
VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT SphericalDistortion fillMap(vtkPolyData* input, vtkPolyData* map,
                                                                      const TriangleMesh& surface, const Points3& image,
                                                                      const Eigen::VectorXd& target = {});

/// A surface that a map cuts open: m×3 faces, and for every vertex the one of the input that it is.
struct OpenedFaces {
  const Faces& faces;
  const std::vector<int>& originalPointIds;
};

/// The same for a map that cuts the surface: the points of `map` are those of `opened`, with the point array
/// OriginalPointIds; a vertex has the area distortion of its whole star.
VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT Distortion fillOpenedMap(vtkPolyData* input, vtkPolyData* map,
                                                                   const OpenedFaces& opened, const Points2& image,
                                                                   const Eigen::VectorXd& target = {});

/// Turns a map into its surface with texture coordinates: points become OriginalPoints (whose array goes), the image
/// the active array TCoords, moved and scaled by one factor into [0, 1]², or [0, 1]³ when it is not in the plane z
/// = 0.
VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT void imageToTextureCoordinates(vtkPolyData* map);

/// The measure that the point (else cell) array of that name asks for; surface area when the name is empty.
/// @throws InvalidArgument when there is no such array
[[nodiscard]] VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT TargetMeasure targetMeasureOf(vtkPolyData* surface,
                                                                                      const TriangleMesh& mesh,
                                                                                      const std::string& densityArray);

/// How much the areas weigh against the angles of a conformal map: one number, or a point array.
struct Balance {
  double everywhere = 1;
  std::string array;  ///< empty: `everywhere`
  [[nodiscard]] bool whole() const { return array.empty() && everywhere == 1; }
};

/// TargetMeasure::blended() by that balance.
/// @throws InvalidArgument when there is no such array, or as blended()
[[nodiscard]] VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT TargetMeasure balancedTarget(
    vtkPolyData* surface, const TriangleMesh& mesh, const TargetMeasure& target, const Eigen::VectorXd& conformalAreas,
    const Balance& balance);

}  // namespace authalic
