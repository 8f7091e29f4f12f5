#include "Reports/Version.h"

namespace authalic {

const char* version() noexcept {
  return AUTHALIC_VERSION;
}

}  // namespace authalic
