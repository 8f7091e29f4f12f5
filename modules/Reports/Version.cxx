#include "Reports/Version.h"

#include "Core/base/VersionMacros.h"

namespace authalic {

const char* version() noexcept {
  return AUTHALIC_VERSION;
}

}  // namespace authalic
