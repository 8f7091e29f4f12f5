/// @file
/// How an iterative method ended. Not an exception: the best iterate and its history come back with it.
#pragma once

namespace authalic {

enum class Status {
  NotRun,        ///< nothing was computed
  Converged,     ///< the stopping criterion was met
  NotConverged,  ///< the iteration limit was reached first; the best iterate is returned
  Stalled,       ///< no further progress was possible; the best iterate is returned
  Cancelled,     ///< the caller asked to stop; the last valid iterate is returned
};

/// "not-run", "converged", "not-converged", "stalled", "cancelled".
[[nodiscard]] const char* statusName(Status status) noexcept;

}  // namespace authalic
