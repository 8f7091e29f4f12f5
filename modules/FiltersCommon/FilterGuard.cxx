#include "FilterGuard.h"

#include <exception>
#include <new>

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkInformationVector.h>

#include "Core/base/Error.h"
#include "FieldArrays.h"

namespace authalic {
namespace {

struct Failure {
  FilterErrorKind kind;
  std::string sentence;
};

/// Call only inside a catch block.
Failure describeCurrentException() {
  try {
    throw;
  } catch (const CancelledError& e) {
    return {CancelledFailure, e.what()};
  } catch (const InvalidArgument& e) {
    return {ArgumentFailure, e.what()};
  } catch (const TopologyError& e) {
    return {SurfaceFailure, e.what()};
  } catch (const GeometryError& e) {
    return {SurfaceFailure, e.what()};
  } catch (const FormatError& e) {
    return {FormatFailure, e.what()};
  } catch (const std::bad_alloc&) {
    return {SolverFailure, "Not enough memory; use a coarser surface or a machine with more memory."};
  } catch (const std::exception& e) {
    return {SolverFailure, e.what()};
  } catch (...) {
    return {SolverFailure, "An unknown exception was thrown."};
  }
}

void emptyOutputs(vtkInformationVector* outputs) {
  for (int port = 0; outputs && port < outputs->GetNumberOfInformationObjects(); ++port) {
    if (vtkDataObject* output = vtkDataObject::GetData(outputs, port)) output->Initialize();
  }
}

}  // namespace

int runGuarded(vtkAlgorithm* filter, vtkInformationVector* outputs, int threads, int& kind,
               const std::function<void(const Execution&)>& body) {
  kind = NoFailure;
  const Execution execution(
      [filter](double fraction, const std::string& stage) {
        filter->SetProgressText(stage.c_str());
        filter->UpdateProgress(fraction);
      },
      [filter] { return filter->GetAbortExecute() != 0; }, threads);
  try {
    body(execution);
    return 1;
  } catch (...) {
    const Failure failure = describeCurrentException();
    emptyOutputs(outputs);
    kind = failure.kind;
    if (failure.kind != CancelledFailure) vtkErrorWithObjectMacro(filter, << failure.sentence);
    return 0;
  }
}

FilterErrorKind reportStatus(vtkAlgorithm* filter, vtkDataObject* output, Status status, int iterations) {
  addField(output, "Status", std::string(statusName(status)));
  addField(output, "Iterations", iterations);
  if (status == Status::Cancelled) return CancelledFailure;
  if (status != Status::NotConverged && status != Status::Stalled) return NoFailure;
  vtkWarningWithObjectMacro(filter, << "Not converged (" << statusName(status) << ") after " << iterations
                                    << " iterations; the output is the best iterate. Raise the iteration limit or "
                                       "loosen the tolerance.");
  return NotConvergedFailure;
}

}  // namespace authalic
