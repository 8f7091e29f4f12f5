#include "MapArrays.h"

#include <cmath>
#include <vector>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "FieldArrays.h"
#include "HistogramArrays.h"
#include "RegionArrays.h"

namespace authalic {
namespace {

void addSummary(vtkPolyData* map, const DistortionSummary& s) {
  const std::pair<const char*, double> numbers[] = {
      {"TotalAreaDistortion", s.areaDistortion},
      {"TotalAngleDistortion", s.angleDistortion},
      {"SymmetricDirichlet", s.symmetricDirichlet},
      {"AsRigidAsPossible", s.asRigidAsPossible},
      {"AreaErrorL2", s.areaErrorL2},
      {"FaceMeanAbsLog", s.faceMeanAbsLog},
      {"FaceMaxAbsLog", s.faceMaxAbsLog},
      {"FaceStandardDeviation", s.faceStandardDeviation},
      {"VertexMeanAbsLog", s.vertexMeanAbsLog},
      {"VertexMaxAbsLog", s.vertexMaxAbsLog},
      {"MeanAngleError", s.meanAngleError},
      {"MeanQuasiConformal", s.meanQuasiConformal},
      {"MeanBeltrami", s.meanBeltrami},
  };
  for (const auto& [name, value] : numbers) addField(map, name, value);
  const std::pair<const char*, const Spread*> spreads[] = {
      {"AngleError", &s.angleError}, {"QuasiConformal", &s.quasiConformal}, {"Beltrami", &s.beltrami}};
  for (const auto& [name, spread] : spreads) {
    addField(map, (std::string(name) + "StandardDeviation").c_str(), spread->standardDeviation);
    addField(map, (std::string(name) + "Percentiles").c_str(),
             std::vector<double>(spread->percentiles.begin(), spread->percentiles.end()));
  }
  addField(map, "FlippedFaces", s.flippedFaces);
  addField(map, "DegenerateFaces", s.degenerateFaces);
}

}  // namespace

void addDistortion(vtkPolyData* map, const Distortion& distortion) {
  const DistortionArrays& a = distortion.arrays;
  addArray(map->GetCellData(), "AreaDistortion", a.logAreaRatio);
  addArray(map->GetCellData(), "AngleDistortion", a.angleDistortion);
  addArray(map->GetCellData(), "BeltramiCoefficient", a.beltrami);
  addArray(map->GetCellData(), "Flipped", std::vector<char>(a.flipped.data(), a.flipped.data() + a.flipped.size()));
  addArray(map->GetPointData(), "VertexAreaDistortion", Eigen::VectorXd(a.vertexLogAreaRatio / std::log(2.0)));
  addSummary(map, distortion.summary);
  addHistograms(map, distortionHistograms(a));
}

Distortion fillMap(vtkPolyData* input, vtkPolyData* map, const TriangleMesh& surface, const Points2& image,
                   const Eigen::VectorXd& target) {
  Distortion distortion = measureDistortion(surface, image, target);
  map->ShallowCopy(input);
  addArray(map->GetPointData(), "OriginalPoints", surface.points());
  setPoints(map, image);
  addDistortion(map, distortion);
  addRegionShares(map, surface, distortion.arrays, target);
  return distortion;
}

SphericalDistortion fillMap(vtkPolyData* input, vtkPolyData* map, const TriangleMesh& surface, const Points3& image,
                            const Eigen::VectorXd& target) {
  SphericalDistortion distortion = measureSphericalDistortion(surface, image, target);
  map->ShallowCopy(input);
  addArray(map->GetPointData(), "OriginalPoints", surface.points());
  setPoints(map, image);
  addDistortion(map, {distortion.arrays, distortion.summary});
  addRegionShares(map, surface, distortion.arrays, target);
  addField(map, "Coverage", distortion.coverage);
  addField(map, "FlatAreaDistortion", distortion.flatSummary.areaDistortion);
  addField(map, "SphericalAngleError", distortion.sphericalAngleError);
  return distortion;
}

Distortion fillOpenedMap(vtkPolyData* input, vtkPolyData* map, const OpenedFaces& opened, const Points2& image,
                         const Eigen::VectorXd& target) {
  const TriangleMesh surface(toPoints(input)(opened.originalPointIds, Eigen::all), opened.faces);
  Distortion distortion = measureDistortion(surface, opened.originalPointIds, image, target);
  setMesh(map, surface);
  gatherArrays(input->GetPointData(), opened.originalPointIds, map->GetPointData());
  map->GetCellData()->ShallowCopy(input->GetCellData());
  passFields(input, map);
  addIds(map->GetPointData(), "OriginalPointIds", opened.originalPointIds);
  addArray(map->GetPointData(), "OriginalPoints", surface.points());
  setPoints(map, image);
  addDistortion(map, distortion);
  addRegionShares(map, surface, distortion.arrays, target);
  return distortion;
}

void imageToTextureCoordinates(vtkPolyData* map) {
  Points3 image = toPoints(map);
  const Eigen::RowVector3d lower = image.colwise().minCoeff(), size = image.colwise().maxCoeff() - lower;
  if (size.maxCoeff() > 0) image = (image.rowwise() - lower) / size.maxCoeff();
  vtkNew<vtkFloatArray> coordinates;  // VTK's glTF exporter leaves out any other type
  coordinates->SetName("TCoords");
  coordinates->SetNumberOfComponents(size[2] > 0 ? 3 : 2);
  coordinates->SetNumberOfTuples(map->GetNumberOfPoints());
  for (vtkIdType v = 0; v < map->GetNumberOfPoints(); ++v) coordinates->SetTuple(v, image.row(v).data());
  setPoints(map, surfaceOfMap(map).points());
  map->GetPointData()->RemoveArray("OriginalPoints");
  map->GetPointData()->SetTCoords(coordinates);
}

TargetMeasure targetMeasureOf(vtkPolyData* surface, const TriangleMesh& mesh, const std::string& densityArray) {
  if (densityArray.empty()) return TargetMeasure(mesh);
  if (vtkDataArray* perFace = surface->GetCellData()->GetArray(densityArray.c_str());
      perFace && !surface->GetPointData()->HasArray(densityArray.c_str())) {
    return TargetMeasure::fromFaceDensity(mesh, toVector(perFace));
  }
  return TargetMeasure::fromVertexDensity(
      mesh, toVector(requireArray(surface->GetPointData(), densityArray, 1, "measure")));
}

TargetMeasure balancedTarget(vtkPolyData* surface, const TriangleMesh& mesh, const TargetMeasure& target,
                             const Eigen::VectorXd& conformalAreas, const Balance& balance) {
  if (balance.array.empty()) return target.blended(mesh, conformalAreas, balance.everywhere);
  return target.blended(mesh, conformalAreas,
                        toVector(requireArray(surface->GetPointData(), balance.array, 1, "balance")));
}

}  // namespace authalic
