/// @file
/// Files that appear whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace authalic {

/// Writes beside the target under a temporary name and renames on commit().
///
/// Guarantees: until commit() returns, a file that was at `path` is untouched; without commit() (an
/// exception on the way, for instance) the temporary file is removed. commit() flushes to the disk first.
/// A symbolic link at `path` is followed: the file it names is replaced, the link stays.
///
/// Writers that open files by name themselves may write to temporaryPath() instead of calling write().
class AtomicFile {
 public:
  /// @throws FormatError when the folder is missing or not writable, or `path` is a folder or a device
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  [[nodiscard]] const std::string& temporaryPath() const noexcept { return temporary_; }

  /// @throws FormatError when the disk is full or fails
  void write(const void* bytes, std::size_t count);
  void write(std::string_view text) { write(text.data(), text.size()); }
  void write(const std::vector<std::uint8_t>& bytes) { write(bytes.data(), bytes.size()); }

  /// Makes the file appear at its path.
  /// @throws FormatError when flushing or renaming fails; nothing is left behind then
  void commit();

 private:
  [[noreturn]] void fail(const char* action) const;

  std::string path_;
  std::string target_;
  std::string temporary_;
  int descriptor_ = -1;
};

/// Writes text or bytes as one file, whole or not at all.
/// @throws FormatError as AtomicFile does
void writeFileAtomically(const std::string& path, std::string_view text);
void writeFileAtomically(const std::string& path, const std::vector<std::uint8_t>& bytes);

}  // namespace authalic
