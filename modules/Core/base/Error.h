/// @file
/// The exceptions of Authalic, one class per kind of failure, so that a filter or the command line
/// can map a failure to its exit code without reading the words.
///
/// Every message is one sentence: what was required, what was found, where, and what to do.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace authalic {

/// Base of all failures that Authalic reports by exception. Non-convergence is a Status, not an Error.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An option is outside its range, or two options contradict each other (exit code 2).
class InvalidArgument : public Error {
 public:
  using Error::Error;
};

/// The surface has the wrong topology for the method (exit code 3).
class TopologyError : public Error {
 public:
  using Error::Error;
};

/// Degenerate geometry, NaN coordinates, lengths of arrays that do not match the mesh (exit code 3).
class GeometryError : public Error {
 public:
  using Error::Error;
};

/// A matrix could not be factorised (exit code 1).
class SolverError : public Error {
 public:
  using Error::Error;
};

/// The caller asked to stop (exit code 130).
class CancelledError : public Error {
 public:
  CancelledError() : Error("Cancelled on request; no result was produced.") {}
};

/// A file is missing, unreadable or malformed (exit code 5).
class FormatError : public Error {
 public:
  /// @param path    the file
  /// @param what    required, found, what to do
  /// @param offset  byte offset of the offending item, or -1 when the file as a whole is meant
  FormatError(std::string path, const std::string& what, std::int64_t offset = -1)
      : Error(path + (offset >= 0 ? " (byte " + std::to_string(offset) + ")" : std::string()) + ": " + what),
        path_(std::move(path)),
        offset_(offset) {}

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  [[nodiscard]] std::int64_t offset() const noexcept { return offset_; }

 private:
  std::string path_;
  std::int64_t offset_;
};

}  // namespace authalic
