#include "Conversion.h"

#include <cmath>
#include <limits>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "Core/base/Error.h"
#include "FieldArrays.h"

namespace authalic {
namespace {

void requireTrianglesOnly(vtkPolyData* surface, const std::string& role) {
  if (!surface || surface->GetNumberOfPoints() == 0 || surface->GetNumberOfCells() == 0) {
    throw GeometryError("The " + role + " must have triangles; it is empty.");
  }
  const vtkIdType others = surface->GetNumberOfVerts() + surface->GetNumberOfLines() + surface->GetNumberOfStrips();
  if (others > 0) {
    throw GeometryError("The " + role + " must consist of triangles alone; it also has " + std::to_string(others) +
                        " vertex, line or strip cells: run vtkTriangleFilter with PassVerts and PassLines off first.");
  }
  if (surface->GetNumberOfPoints() > std::numeric_limits<int>::max() / 8 ||
      surface->GetNumberOfCells() > std::numeric_limits<int>::max() / 8) {
    throw GeometryError("The " + role + " has too many points or triangles (limit 268 million).");
  }
}

Faces toFaces(vtkPolyData* surface, const std::string& role) {
  Faces faces(surface->GetNumberOfPolys(), 3);
  auto cell = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    const vtkIdType f = cell->GetCurrentCellId();
    if (size != 3) {
      throw GeometryError("The " + role + " must consist of triangles; cell " + std::to_string(f) + " has " +
                          std::to_string(size) + " corners: run vtkTriangleFilter first.");
    }
    for (int k = 0; k < 3; ++k) faces(f, k) = static_cast<int>(ids[k]);
  }
  return faces;
}

vtkDataArray* imageArray(vtkImageData* image, const std::string& name) {
  vtkDataArray* array = nullptr;
  if (image) array = name.empty() ? image->GetPointData()->GetScalars() : image->GetPointData()->GetArray(name.c_str());
  if (!array && image && name.empty() && image->GetPointData()->GetNumberOfArrays() > 0) {
    array = image->GetPointData()->GetArray(0);
  }
  if (!array || array->GetNumberOfTuples() == 0) {
    throw GeometryError("The volume must have voxels" + (name.empty() ? std::string() : " in array '" + name + "'") +
                        "; there are none.");
  }
  return array;
}

Eigen::Matrix4d voxelToWorld(vtkImageData* image) {
  Eigen::Matrix4d affine = Eigen::Matrix4d::Identity();
  const double *spacing = image->GetSpacing(), *origin = image->GetOrigin();
  const int* extent = image->GetExtent();
  for (int r = 0; r < 3; ++r) {
    affine(r, 3) = origin[r];
    for (int c = 0; c < 3; ++c) {
      affine(r, c) = image->GetDirectionMatrix()->GetElement(r, c) * spacing[c];
      affine(r, 3) += affine(r, c) * extent[2 * c];
    }
  }
  return affine;
}

template <class Volume>
Volume emptyVolume(vtkImageData* image) {
  int size[3];
  image->GetDimensions(size);
  return Volume({size[0], size[1], size[2]}, voxelToWorld(image));
}

}  // namespace

TriangleMesh toTriangleMesh(vtkPolyData* surface, const std::string& role) {
  const Faces faces = toTriangles(surface, role);
  return TriangleMesh(toPoints(surface), faces);
}

Faces toTriangles(vtkPolyData* surface, const std::string& role) {
  requireTrianglesOnly(surface, role);
  return toFaces(surface, role);
}

TriangleMesh surfaceOfMap(vtkPolyData* map) {
  const TriangleMesh image = toTriangleMesh(map, "map");
  vtkDataArray* original = requireArray(map->GetPointData(), "OriginalPoints", 3, "map");
  Points3 points(image.vertexCount(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) original->GetTuple(i, points.row(i).data());
  return TriangleMesh(points, image.faces());
}

TriangleMesh surfaceOf(vtkPolyData* surfaceOrMap) {
  const bool isMap = surfaceOrMap && surfaceOrMap->GetPointData()->HasArray("OriginalPoints");
  return isMap ? surfaceOfMap(surfaceOrMap) : toTriangleMesh(surfaceOrMap);
}

void setPoints(vtkPolyData* output, const Points3& points) {
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i) coordinates->SetTuple3(i, points(i, 0), points(i, 1), points(i, 2));
  vtkNew<vtkPoints> result;
  result->SetData(coordinates);
  output->SetPoints(result);
}

void setPoints(vtkPolyData* output, const Points2& points) {
  Points3 lifted = Points3::Zero(points.rows(), 3);
  lifted.leftCols<2>() = points;
  setPoints(output, lifted);
}

void setMesh(vtkPolyData* output, const TriangleMesh& mesh) {
  setPoints(output, mesh.points());
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(mesh.faceCount(), 3 * static_cast<vtkIdType>(mesh.faceCount()));
  for (int f = 0; f < mesh.faceCount(); ++f) {
    cells->InsertNextCell({mesh.faces()(f, 0), mesh.faces()(f, 1), mesh.faces()(f, 2)});
  }
  output->SetPolys(cells);
}

Points3 toPoints(vtkPolyData* surface) {
  Points3 points(surface->GetNumberOfPoints(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) surface->GetPoint(i, points.row(i).data());
  return points;
}

Points2 toPlanarPoints(vtkPolyData* map) {
  const Points3 points = toPoints(map);
  const double extent = (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
  Eigen::Index worst = 0;
  const double height = points.rows() > 0 ? points.col(2).cwiseAbs().maxCoeff(&worst) : 0.0;
  if (height > 1e-9 * extent) {
    throw GeometryError("A planar map must lie in the plane z = 0; point " + std::to_string(worst) +
                        " has z = " + std::to_string(points(worst, 2)) + ". Hand over the output of a map filter.");
  }
  return points.leftCols<2>();
}

ScalarVolume toScalarVolume(vtkImageData* image, const std::string& array) {
  vtkDataArray* values = imageArray(image, array);
  ScalarVolume volume = emptyVolume<ScalarVolume>(image);
  for (std::size_t i = 0; i < volume.size(); ++i) {
    volume.values[i] = static_cast<float>(values->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return volume;
}

LabelVolume toLabelVolume(vtkImageData* image, const std::string& array) {
  vtkDataArray* values = imageArray(image, array);
  LabelVolume volume = emptyVolume<LabelVolume>(image);
  for (std::size_t i = 0; i < volume.size(); ++i) {
    const double value = values->GetComponent(static_cast<vtkIdType>(i), 0);
    volume.values[i] = std::isfinite(value) ? static_cast<std::int32_t>(std::lround(value)) : 0;
  }
  return volume;
}

}  // namespace authalic
