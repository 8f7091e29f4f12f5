/// @file
/// Named arrays between plain vectors and VTK: to points, to cells, and to the field data of an output.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "Core/mesh/TriangleMesh.h"
#include "vtkAuthalicFiltersCommonModule.h"

class vtkDataArray;
class vtkDataObject;
class vtkDataSetAttributes;

namespace authalic {

/// One component per tuple; the array replaces one of the same name.
VTKAUTHALICFILTERSCOMMON_EXPORT void addArray(vtkDataSetAttributes* data, const char* name,
                                              const std::vector<double>& values);
VTKAUTHALICFILTERSCOMMON_EXPORT void addArray(vtkDataSetAttributes* data, const char* name,
                                              const std::vector<float>& values);
VTKAUTHALICFILTERSCOMMON_EXPORT void addArray(vtkDataSetAttributes* data, const char* name,
                                              const std::vector<int>& values);
VTKAUTHALICFILTERSCOMMON_EXPORT void addArray(vtkDataSetAttributes* data, const char* name,
                                              const std::vector<char>& values);
VTKAUTHALICFILTERSCOMMON_EXPORT void addArray(vtkDataSetAttributes* data, const char* name,
                                              const Eigen::VectorXd& values);
/// Three components per tuple.
VTKAUTHALICFILTERSCOMMON_EXPORT void addArray(vtkDataSetAttributes* data, const char* name, const Points3& values);
/// Two components per tuple: real and imaginary part.
VTKAUTHALICFILTERSCOMMON_EXPORT void addArray(vtkDataSetAttributes* data, const char* name,
                                              const Eigen::VectorXcd& values);
/// Indices, as vtkIdType.
VTKAUTHALICFILTERSCOMMON_EXPORT void addIds(vtkDataSetAttributes* data, const char* name,
                                            const std::vector<int>& ids);

VTKAUTHALICFILTERSCOMMON_EXPORT void addField(vtkDataObject* object, const char* name, double value);
VTKAUTHALICFILTERSCOMMON_EXPORT void addField(vtkDataObject* object, const char* name, int value);
VTKAUTHALICFILTERSCOMMON_EXPORT void addField(vtkDataObject* object, const char* name, const std::string& value);
VTKAUTHALICFILTERSCOMMON_EXPORT void addField(vtkDataObject* object, const char* name,
                                              const std::vector<double>& values);
/// One tuple per row.
VTKAUTHALICFILTERSCOMMON_EXPORT void addField(vtkDataObject* object, const char* name, const Eigen::MatrixXd& values);
/// One row per tuple of a field array; empty when it is not there.
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT Eigen::MatrixXd matrixField(vtkDataObject* object,
                                                                          const std::string& name);

/// First number of a field array; `otherwise` when it is not there.
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT double numberField(vtkDataObject* object, const std::string& name,
                                                                 double otherwise = 0.0);
/// First text of a field array; empty when it is not there.
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT std::string textField(vtkDataObject* object, const std::string& name);

/// The field data of `input` (name of the structure, coordinate space, file …) on `output`; the arrays are shared.
VTKAUTHALICFILTERSCOMMON_EXPORT void passFields(vtkDataObject* input, vtkDataObject* output);

/// Tuples ids[0], ids[1], … of every array of `from`, in an array of the same name and type of `to`.
VTKAUTHALICFILTERSCOMMON_EXPORT void gatherArrays(vtkDataSetAttributes* from, const std::vector<int>& ids,
                                                  vtkDataSetAttributes* to);

/// The numeric array of that name.
/// @throws InvalidArgument naming the arrays that are there, when it is missing or has other components.
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT vtkDataArray* requireArray(vtkDataSetAttributes* data,
                                                                         const std::string& name, int components,
                                                                         const std::string& role);
/// First component of every tuple.
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT Eigen::VectorXd toVector(vtkDataArray* array);
/// First component of every tuple, rounded.
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT std::vector<int> toIntegers(vtkDataArray* array);

}  // namespace authalic
