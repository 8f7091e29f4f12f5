/// @file
/// Running a filter from the command line: progress, warnings, and failures as exceptions.
#pragma once

#include <functional>

#include "Console.h"
#include "Verb.h"

class vtkAlgorithm;

namespace authalic::cli {

/// Runs `action` on an algorithm whose errors are collected.
/// @param kind  asked afterwards, as below
/// @throws Failure when the algorithm failed
void runAlgorithm(vtkAlgorithm* algorithm, const std::function<void()>& action, const std::function<int()>& kind);

/// Updates one algorithm: shows its progress, aborts it on SIGINT, prints its warnings, collects its error.
/// @param kind  asked after the run: 0, or the exit code of what went wrong (see vtkSurfaceAlgorithm::GetErrorKind)
/// @returns what `kind` returned when the output is usable all the same: 0 or NotConverged
/// @throws Failure in every other case
int updateAlgorithm(vtkAlgorithm* algorithm, const Session& session, const std::function<int()>& kind);

/// The same for the filters of Authalic, with the session's thread count.
template <class Filter>
int update(Filter* filter, const Session& session) {
  filter->SetThreads(session.threads);
  return updateAlgorithm(filter, session, [filter] { return filter->GetErrorKind(); });
}

}  // namespace authalic::cli
