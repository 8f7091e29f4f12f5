/// @file
/// The version that every report and provenance record names.
#pragma once

namespace authalic {

/// "MAJOR.MINOR.PATCH" of the library that runs; AUTHALIC_VERSION is that of the headers that were compiled.
[[nodiscard]] const char* version() noexcept;

}  // namespace authalic
