/// @file
/// Sequential and whole-file reading with transparent gzip and bounded memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace authalic {

/// A regular file opened for sequential reading; gzip is recognised by content and undone on the way.
///
/// Memory grows with the bytes that are really there: a header that claims more than the file holds costs
/// nothing but a FormatError. Every failure is a FormatError that names the path and the byte.
class InputFile {
 public:
  /// @throws FormatError when the path is missing, a folder or device, empty, or cannot be opened
  explicit InputFile(std::string path);

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  /// Whether the bytes on disk are gzip.
  [[nodiscard]] bool compressed() const noexcept { return compressed_; }
  /// Position in the uncompressed bytes.
  [[nodiscard]] std::uint64_t position() const noexcept { return position_; }

  /// The next `count` bytes, no fewer; `what` names them in the message of the FormatError.
  [[nodiscard]] std::vector<std::uint8_t> read(std::uint64_t count, const char* what);
  /// Passes over `count` bytes, no fewer.
  void skip(std::uint64_t count, const char* what);
  /// The next `count` bytes, or as many as there are.
  [[nodiscard]] std::vector<std::uint8_t> readUpTo(std::size_t count);
  /// Everything that is left, at most `limit` bytes.
  [[nodiscard]] std::vector<std::uint8_t> readRest(std::uint64_t limit);
  /// Passes over the rest and checks the checksum of a gzip stream; returns the uncompressed length.
  std::uint64_t drain();

 private:
  struct Closer {
    void operator()(void* file) const noexcept;
  };
  [[nodiscard]] std::size_t readSome(void* destination, std::size_t count);
  [[noreturn]] void failTruncated(std::uint64_t needed, const char* what) const;

  std::string path_;
  std::unique_ptr<void, Closer> file_;
  std::uint64_t position_ = 0;
  std::uint64_t sizeOnDisk_ = 0;
  bool compressed_ = false;
};

/// The uncompressed bytes of a file.
/// @throws FormatError as InputFile does, and when more than `limit` bytes come out
[[nodiscard]] std::vector<std::uint8_t> readBytes(const std::string& path, std::uint64_t limit = 1ULL << 31);

}  // namespace authalic
