#include "Formats/AtomicFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "Core/base/Error.h"

namespace authalic {

namespace {

namespace fs = std::filesystem;

/// Where the links lead, whether a file is there or not.
std::string targetOf(const std::string& path) {
  std::error_code error;
  fs::path target(path);
  constexpr int most = 40;  // as the system follows
  for (int links = 0; links < most; ++links) {
    if (!fs::is_symlink(fs::symlink_status(target, error))) {
      return target.string();
    }
    const fs::path next = fs::read_symlink(target, error);
    if (error) {
      break;
    }
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  throw FormatError(path, "A file is to be written, but that name is a link that leads nowhere; choose another name.");
}

void checkTarget(const std::string& path, const std::string& target) {
  if (path.empty()) {
    throw FormatError("(no name)", "A name is needed for the file to write.");
  }
  std::error_code error;
  const auto status = fs::status(target, error);
  if (fs::is_directory(status)) {
    throw FormatError(path,
                      "A file is to be written, but there is a folder of that name; choose another name.");
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw FormatError(path,
                      "A file is to be written, but that name is a device or pipe; choose another name.");
  }
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path), target_(targetOf(path)) {
  checkTarget(path_, target_);
  const fs::path target(target_);
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const std::string name = "." + target.filename().string() + "." + std::to_string(::getpid()) + "-" +
                             std::to_string(attempt) + ".tmp";
    temporary_ = (target.parent_path() / name).string();
    descriptor_ = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (descriptor_ >= 0 || errno != EEXIST) {
      break;
    }
  }
  if (descriptor_ < 0) {
    temporary_.clear();
    fail("created (check that its folder exists and can be written)");
  }
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
  if (!temporary_.empty()) {
    ::unlink(temporary_.c_str());
  }
}

void AtomicFile::fail(const char* action) const {
  throw FormatError(path_, std::string("The file cannot be ") + action + ": " +
                               std::error_code(errno, std::generic_category()).message() + ".");
}

void AtomicFile::write(const void* bytes, std::size_t count) {
  const char* from = static_cast<const char*>(bytes);
  while (count > 0) {
    const ::ssize_t written = ::write(descriptor_, from, std::min<std::size_t>(count, 1U << 30));
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written <= 0) {
      fail("written");
    }
    from += written;
    count -= static_cast<std::size_t>(written);
  }
}

void AtomicFile::commit() {
  // Some file systems do not support fsync; the rename is still all or nothing.
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) {
    fail("flushed to the disk");
  }
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0) {
    fail("closed");
  }
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
    fail("put in place");
  }
  temporary_.clear();
}

void writeFileAtomically(const std::string& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

void writeFileAtomically(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace authalic
