#include "FieldArrays.h"

#include <cmath>

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include "Core/base/Error.h"

namespace authalic {
namespace {

template <class Array, class Values>
void addScalars(vtkFieldData* data, const char* name, const Values& values) {
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  vtkIdType i = 0;
  for (const auto& value : values) array->SetValue(i++, static_cast<typename Array::ValueType>(value));
  data->AddArray(array);
}

vtkFieldData* fieldsOf(vtkDataObject* object) {
  if (!object->GetFieldData()) object->SetFieldData(vtkNew<vtkFieldData>());
  return object->GetFieldData();
}

std::string arrayNames(vtkDataSetAttributes* data) {
  std::string names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    names += (names.empty() ? "" : ", ") + std::string(data->GetArrayName(i) ? data->GetArrayName(i) : "(unnamed)");
  }
  return names.empty() ? "none" : names;
}

}  // namespace

void addArray(vtkDataSetAttributes* data, const char* name, const std::vector<double>& values) {
  addScalars<vtkDoubleArray>(data, name, values);
}
void addArray(vtkDataSetAttributes* data, const char* name, const std::vector<float>& values) {
  addScalars<vtkFloatArray>(data, name, values);
}
void addArray(vtkDataSetAttributes* data, const char* name, const std::vector<int>& values) {
  addScalars<vtkIntArray>(data, name, values);
}
void addArray(vtkDataSetAttributes* data, const char* name, const std::vector<char>& values) {
  addScalars<vtkUnsignedCharArray>(data, name, values);
}
void addArray(vtkDataSetAttributes* data, const char* name, const Eigen::VectorXd& values) {
  addScalars<vtkDoubleArray>(data, name, values);
}
void addIds(vtkDataSetAttributes* data, const char* name, const std::vector<int>& ids) {
  addScalars<vtkIdTypeArray>(data, name, ids);
}

void addArray(vtkDataSetAttributes* data, const char* name, const Points3& values) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(values.rows());
  for (Eigen::Index i = 0; i < values.rows(); ++i) array->SetTuple3(i, values(i, 0), values(i, 1), values(i, 2));
  data->AddArray(array);
}

void addArray(vtkDataSetAttributes* data, const char* name, const Eigen::VectorXcd& values) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(2);
  array->SetNumberOfTuples(values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) array->SetTuple2(i, values[i].real(), values[i].imag());
  data->AddArray(array);
}

void addField(vtkDataObject* object, const char* name, double value) {
  addField(object, name, std::vector<double>{value});
}

void addField(vtkDataObject* object, const char* name, int value) {
  addScalars<vtkIntArray>(fieldsOf(object), name, std::vector<int>{value});
}

void addField(vtkDataObject* object, const char* name, const std::string& value) {
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  fieldsOf(object)->AddArray(array);
}

void addField(vtkDataObject* object, const char* name, const std::vector<double>& values) {
  addScalars<vtkDoubleArray>(fieldsOf(object), name, values);
}

void addField(vtkDataObject* object, const char* name, const Eigen::MatrixXd& values) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.cols()));
  array->SetNumberOfTuples(values.rows());
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    for (Eigen::Index k = 0; k < values.cols(); ++k) array->SetComponent(i, static_cast<int>(k), values(i, k));
  }
  fieldsOf(object)->AddArray(array);
}

Eigen::MatrixXd matrixField(vtkDataObject* object, const std::string& name) {
  vtkDataArray* array = fieldsOf(object)->GetArray(name.c_str());
  if (!array) return {};
  Eigen::MatrixXd values(array->GetNumberOfTuples(), array->GetNumberOfComponents());
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    for (Eigen::Index k = 0; k < values.cols(); ++k) values(i, k) = array->GetComponent(i, static_cast<int>(k));
  }
  return values;
}

double numberField(vtkDataObject* object, const std::string& name, double otherwise) {
  vtkDataArray* array = fieldsOf(object)->GetArray(name.c_str());
  return array && array->GetNumberOfValues() > 0 ? array->GetComponent(0, 0) : otherwise;
}

std::string textField(vtkDataObject* object, const std::string& name) {
  auto* array = vtkStringArray::SafeDownCast(fieldsOf(object)->GetAbstractArray(name.c_str()));
  return array && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : std::string();
}

void passFields(vtkDataObject* input, vtkDataObject* output) { fieldsOf(output)->ShallowCopy(fieldsOf(input)); }

void gatherArrays(vtkDataSetAttributes* from, const std::vector<int>& ids, vtkDataSetAttributes* to) {
  to->CopyAllOn();
  to->CopyAllocate(from, static_cast<vtkIdType>(ids.size()));
  for (std::size_t i = 0; i < ids.size(); ++i) to->CopyData(from, ids[i], static_cast<vtkIdType>(i));
}

vtkDataArray* requireArray(vtkDataSetAttributes* data, const std::string& name, int components,
                           const std::string& role) {
  vtkDataArray* array = data->GetArray(name.c_str());
  if (!array) {
    throw InvalidArgument("The " + role + " needs an array named '" + name + "'; the arrays there are: " +
                          arrayNames(data) + ".");
  }
  if (array->GetNumberOfComponents() != components) {
    throw InvalidArgument("The " + role + " needs " + std::to_string(components) + " component(s) in array '" + name +
                          "'; it has " + std::to_string(array->GetNumberOfComponents()) + ".");
  }
  return array;
}

Eigen::VectorXd toVector(vtkDataArray* array) {
  Eigen::VectorXd values(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) values[i] = array->GetComponent(i, 0);
  return values;
}

std::vector<int> toIntegers(vtkDataArray* array) {
  std::vector<int> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    const double value = array->GetComponent(i, 0);
    if (!(std::abs(value) < 2147483648.0)) {
      throw InvalidArgument("Labels must be integers below 2^31; entry " + std::to_string(i) + " of array '" +
                            std::string(array->GetName() ? array->GetName() : "") + "' is " +
                            std::to_string(value) + ".");
    }
    values[static_cast<std::size_t>(i)] = static_cast<int>(std::lround(value));
  }
  return values;
}

}  // namespace authalic
