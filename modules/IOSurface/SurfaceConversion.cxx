#include "SurfaceConversion.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include "Conversion.h"
#include "FieldArrays.h"

namespace authalic {

namespace {

constexpr const char* kSpace = "CoordinateSpace";
constexpr const char* kReason = "CoordinateSpaceReason";
constexpr const char* kGeometry = "VolumeGeometry";
constexpr const char* kGeometryFile = "VolumeGeometryFile";
/// The metadata that travel with a surface, by their GIFTI names.
constexpr const char* kMetadata[] = {"AnatomicalStructurePrimary", "AnatomicalStructureSecondary",
                                     "GeometricType", "TopologicalType", "Name"};

CoordinateSpace spaceNamed(const std::string& name) {
  for (const auto space : {CoordinateSpace::ScannerRAS, CoordinateSpace::TkRAS, CoordinateSpace::LPS}) {
    if (name == coordinateSpaceName(space)) {
      return space;
    }
  }
  return CoordinateSpace::Unknown;
}

std::vector<double> packed(const VolumeGeometry& geometry) {
  std::vector<double> numbers(geometry.dimensions.begin(), geometry.dimensions.end());
  numbers.insert(numbers.end(), geometry.voxelSize.begin(), geometry.voxelSize.end());
  numbers.insert(numbers.end(), geometry.directions.begin(), geometry.directions.end());
  numbers.insert(numbers.end(), geometry.center.begin(), geometry.center.end());
  return numbers;
}

VolumeGeometry unpackedGeometry(vtkDataObject* object) {
  VolumeGeometry geometry;
  vtkDataArray* array = object->GetFieldData()->GetArray(kGeometry);
  if (!array || array->GetNumberOfValues() != 18) {
    return geometry;
  }
  const auto number = [array](std::size_t i) {
    return array->GetVariantValue(static_cast<vtkIdType>(i)).ToDouble();
  };
  for (std::size_t i = 0; i < 3; ++i) {
    geometry.dimensions[i] = static_cast<int>(number(i));
    geometry.voxelSize[i] = number(3 + i);
    geometry.center[i] = number(15 + i);
  }
  for (std::size_t i = 0; i < 9; ++i) {
    geometry.directions[i] = number(6 + i);
  }
  geometry.fileName = textField(object, kGeometryFile);
  geometry.valid = true;
  return geometry;
}

}  // namespace

void setSpaceFields(vtkDataObject* output, const SurfaceFile& surface) {
  addField(output, kSpace, std::string(coordinateSpaceName(surface.space)));
  addField(output, kReason, surface.spaceReason);
  for (const char* name : kMetadata) {
    const auto found = surface.metadata.find(name);
    if (found != surface.metadata.end()) {
      addField(output, name, found->second);
    }
  }
  if (surface.geometry.valid) {
    addField(output, kGeometry, packed(surface.geometry));
    addField(output, kGeometryFile, surface.geometry.fileName);
  }
}

void copyPoints(vtkPolyData* from, SurfaceFile& to) {
  const Points3 points = toPoints(from);
  to.points.assign(points.data(), points.data() + points.size());
}

void setPoints(vtkPolyData* output, const SurfaceFile& surface) {
  const auto n = static_cast<Eigen::Index>(surface.vertexCount());
  setPoints(output, Points3(Eigen::Map<const Points3>(surface.points.data(), n, 3)));
}

void setSurface(vtkPolyData* output, const SurfaceFile& surface) {
  setPoints(output, surface);
  const auto m = static_cast<vtkIdType>(surface.faceCount());
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(3 * m);
  std::copy(surface.faces.begin(), surface.faces.end(), corners->GetPointer(0));
  vtkNew<vtkCellArray> cells;
  cells->SetData(3, corners);
  output->SetPolys(cells);
  setSpaceFields(output, surface);
}

SurfaceFile spaceFields(vtkDataObject* object) {
  SurfaceFile surface;
  surface.space = spaceNamed(textField(object, kSpace));
  surface.spaceReason = textField(object, kReason);
  surface.geometry = unpackedGeometry(object);
  for (const char* name : kMetadata) {
    const std::string value = textField(object, name);
    if (!value.empty()) {
      surface.metadata[name] = value;
    }
  }
  return surface;
}

SurfaceFile toSurfaceFile(vtkPolyData* polyData) {
  const TriangleMesh mesh = toTriangleMesh(polyData);
  SurfaceFile surface = spaceFields(polyData);
  surface.points.assign(mesh.points().data(), mesh.points().data() + mesh.points().size());
  surface.faces.assign(mesh.faces().data(), mesh.faces().data() + mesh.faces().size());
  return surface;
}

void setRegions(vtkDataObject* output, const std::string& array, const std::vector<Region>& regions) {
  vtkNew<vtkStringArray> names;
  vtkNew<vtkUnsignedCharArray> colors;
  vtkNew<vtkIntArray> ids;
  names->SetName((array + "Names").c_str());
  colors->SetName((array + "Colors").c_str());
  colors->SetNumberOfComponents(4);
  ids->SetName((array + "Ids").c_str());
  for (const Region& region : regions) {
    names->InsertNextValue(region.name);
    colors->InsertNextTypedTuple(region.rgba.data());
    ids->InsertNextValue(region.id);
  }
  for (vtkAbstractArray* field :
       {static_cast<vtkAbstractArray*>(names), static_cast<vtkAbstractArray*>(colors),
        static_cast<vtkAbstractArray*>(ids)}) {
    output->GetFieldData()->AddArray(field);
  }
}

std::vector<Region> toRegions(vtkDataObject* object, const std::string& array) {
  vtkFieldData* fields = object->GetFieldData();
  auto* names = vtkStringArray::SafeDownCast(fields->GetAbstractArray((array + "Names").c_str()));
  vtkDataArray* ids = fields->GetArray((array + "Ids").c_str());
  vtkDataArray* colors = fields->GetArray((array + "Colors").c_str());
  std::vector<Region> regions;
  if (!names || !ids || ids->GetNumberOfTuples() != names->GetNumberOfTuples()) {
    return regions;
  }
  const bool coloured = colors && colors->GetNumberOfComponents() == 4 &&
                        colors->GetNumberOfTuples() == names->GetNumberOfTuples();
  for (vtkIdType i = 0; i < names->GetNumberOfTuples(); ++i) {
    Region region;
    region.id = static_cast<int>(ids->GetComponent(i, 0));
    region.name = names->GetValue(i).c_str();
    for (int k = 0; coloured && k < 4; ++k) {
      region.rgba[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(colors->GetComponent(i, k));
    }
    regions.push_back(std::move(region));
  }
  return regions;
}

void mirrorVectors(vtkPolyData* surface) {
  for (vtkDataSetAttributes* data : {static_cast<vtkDataSetAttributes*>(surface->GetPointData()),
                                     static_cast<vtkDataSetAttributes*>(surface->GetCellData())}) {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
      vtkDataArray* array = data->GetArray(i);
      if (!array || array->GetNumberOfComponents() != 3 ||
          (array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE)) {
        continue;
      }
      const auto mirrored = vtk::TakeSmartPointer(array->NewInstance());
      mirrored->DeepCopy(array);
      for (vtkIdType t = 0; t < array->GetNumberOfTuples(); ++t) {
        mirrored->SetComponent(t, 0, -array->GetComponent(t, 0));
        mirrored->SetComponent(t, 1, -array->GetComponent(t, 1));
      }
      data->AddArray(mirrored);
    }
  }
}

Eigen::Matrix4d affineOf(vtkImageData* volume) {
  Eigen::Matrix4d affine = Eigen::Matrix4d::Identity();
  for (int axis = 0; axis < 3; ++axis) {
    for (int row = 0; row < 3; ++row) {
      affine(row, axis) = volume->GetDirectionMatrix()->GetElement(row, axis) * volume->GetSpacing()[axis];
    }
    affine(axis, 3) = volume->GetOrigin()[axis];
  }
  const int* extent = volume->GetExtent();
  const Eigen::Vector4d first(extent[0], extent[2], extent[4], 1);
  affine.col(3) = affine * first;
  return affine;
}

void setLattice(vtkImageData* output, const std::array<int, 3>& dimensions, const Eigen::Matrix4d& affine) {
  output->Initialize();
  output->SetDimensions(dimensions[0], dimensions[1], dimensions[2]);
  double spacing[3];
  for (int axis = 0; axis < 3; ++axis) {
    spacing[axis] = affine.col(axis).head<3>().norm();
    for (int row = 0; row < 3; ++row) {
      output->GetDirectionMatrix()->SetElement(row, axis, affine(row, axis) / spacing[axis]);
    }
  }
  output->SetSpacing(spacing);
  output->SetOrigin(affine(0, 3), affine(1, 3), affine(2, 3));
}

}  // namespace authalic
