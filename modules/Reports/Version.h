/// @file
/// The version that every report and provenance record names.
#pragma once

namespace authalic {

/// "MAJOR.MINOR.PATCH".
[[nodiscard]] const char* version() noexcept;

}  // namespace authalic
