/// @file
/// VTK's error code for a kind of failure. Private to IOSurface/.
#pragma once

#include <vtkErrorCode.h>

#include <filesystem>

#include "FilterGuard.h"

namespace authalic {

/// NoError, FileNotFoundError, FileFormatError or UserError.
[[nodiscard]] inline unsigned long readerErrorCode(int kind, const char* path) {
  if (kind == NoFailure) {
    return vtkErrorCode::NoError;
  }
  std::error_code ignored;
  if (!path || !std::filesystem::exists(path, ignored)) {
    return path ? vtkErrorCode::FileNotFoundError : vtkErrorCode::NoFileNameError;
  }
  return kind == FormatFailure ? vtkErrorCode::FileFormatError : vtkErrorCode::UserError;
}

/// NoError, CannotOpenFileError or UserError.
[[nodiscard]] inline unsigned long writerErrorCode(int kind) {
  if (kind == NoFailure) {
    return vtkErrorCode::NoError;
  }
  return kind == FormatFailure ? vtkErrorCode::CannotOpenFileError : vtkErrorCode::UserError;
}

}  // namespace authalic
