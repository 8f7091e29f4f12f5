#include "Core/base/Status.h"

namespace authalic {

const char* statusName(Status status) noexcept {
  switch (status) {
    case Status::NotRun: return "not-run";
    case Status::Converged: return "converged";
    case Status::NotConverged: return "not-converged";
    case Status::Stalled: return "stalled";
    case Status::Cancelled: return "cancelled";
  }
  return "not-run";
}

}  // namespace authalic
