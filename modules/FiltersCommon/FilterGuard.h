/// @file
/// The one place where exceptions of Core become what a VTK pipeline understands.
#pragma once

#include <functional>
#include <string>

#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "vtkAuthalicFiltersCommonModule.h"

class vtkAlgorithm;
class vtkDataObject;
class vtkInformationVector;

namespace authalic {

/// Kinds of failure of a filter. The numbers are the exit codes of the command line.
enum FilterErrorKind : int {
  NoFailure = 0,
  SolverFailure = 1,        ///< SolverError, out of memory, anything unforeseen
  ArgumentFailure = 2,      ///< InvalidArgument
  SurfaceFailure = 3,       ///< TopologyError, GeometryError
  NotConvergedFailure = 4,  ///< the output holds the best iterate; a warning, not an error
  FormatFailure = 5,        ///< FormatError
  CancelledFailure = 130,   ///< the pipeline was aborted
};

/// Runs `body` with progress going to the filter's ProgressEvent and its abort flag read as the cancel request.
///
/// When `body` throws, the sentence goes to vtkErrorMacro (not for a cancellation), every output is emptied, `kind`
/// says what happened, and 0 is returned; otherwise `kind` is what `body` left there (NoFailure at its start) and 1 is
/// returned. No exception leaves this function.
///
/// @param filter   whose RequestData this is
/// @param outputs  the output vector of RequestData; may be null
/// @param threads  0 = every core
/// @param kind     a FilterErrorKind, for the filter's GetErrorKind()
VTKAUTHALICFILTERSCOMMON_EXPORT int runGuarded(vtkAlgorithm* filter, vtkInformationVector* outputs, int threads,
                                               int& kind, const std::function<void(const Execution&)>& body);

/// Writes `Status` (a string, see statusName) and `Iterations` to the field data of `output`. A status other than
/// converged also gives a warning in words; the output stays.
/// @returns NoFailure, NotConvergedFailure or CancelledFailure
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT FilterErrorKind reportStatus(vtkAlgorithm* filter, vtkDataObject* output,
                                                                           Status status, int iterations);

}  // namespace authalic
