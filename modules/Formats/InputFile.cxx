#include "Formats/InputFile.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include "Core/base/Error.h"

namespace authalic {

namespace {

constexpr std::uint64_t kChunk = 1U << 24;

gzFile handle(void* file) {
  return static_cast<gzFile>(file);
}

std::uint64_t checkedSize(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    throw FormatError(path, "The file does not exist or its folder cannot be searched; check the path.");
  }
  if (std::filesystem::is_directory(status)) {
    throw FormatError(path, "A file is needed, but this is a folder; name a file inside it.");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw FormatError(path, "A regular file is needed, but this is a device, pipe or socket.");
  }
  const auto size = std::filesystem::file_size(path, error);
  if (error) {
    throw FormatError(path, "The size of the file cannot be read: " + error.message() + ".");
  }
  if (size == 0) {
    throw FormatError(path, "The file is empty.");
  }
  return size;
}

}  // namespace

void InputFile::Closer::operator()(void* file) const noexcept {
  gzclose(handle(file));
}

InputFile::InputFile(std::string path) : path_(std::move(path)), sizeOnDisk_(checkedSize(path_)) {
  file_.reset(gzopen(path_.c_str(), "rb"));
  if (!file_) {
    throw FormatError(path_, "The file cannot be opened for reading; check its permissions.");
  }
  gzbuffer(handle(file_.get()), 1U << 18);
  compressed_ = gzdirect(handle(file_.get())) == 0;
}

std::size_t InputFile::readSome(void* destination, std::size_t count) {
  const int got = gzread(handle(file_.get()), destination, static_cast<unsigned>(count));
  int code = Z_OK;
  const char* words = gzerror(handle(file_.get()), &code);
  if (got < 0 || (code != Z_OK && code != Z_STREAM_END)) {
    const std::string reason = code == Z_BUF_ERROR ? "it ends in the middle of the stream"
                               : code == Z_ERRNO   ? "the system reports a read error"
                                                   : std::string(words ? words : "unknown reason");
    throw FormatError(path_, "The compressed file is damaged (" + reason + "); fetch or write it again.",
                      static_cast<std::int64_t>(position_));
  }
  position_ += static_cast<std::uint64_t>(got);
  return static_cast<std::size_t>(got);
}

void InputFile::failTruncated(std::uint64_t needed, const char* what) const {
  throw FormatError(path_,
                    "The file ends where " + std::string(what) + " should go on (" + std::to_string(needed) +
                        " more bytes needed); it is truncated or not what its header claims.",
                    static_cast<std::int64_t>(position_));
}

std::vector<std::uint8_t> InputFile::read(std::uint64_t count, const char* what) {
  if (!compressed_ && count > sizeOnDisk_ - std::min(sizeOnDisk_, position_)) {
    failTruncated(count, what);
  }
  std::vector<std::uint8_t> bytes;
  bytes.reserve(compressed_ ? static_cast<std::size_t>(std::min(count, kChunk)) : count);
  while (bytes.size() < count) {
    const std::size_t have = bytes.size();
    bytes.resize(have + static_cast<std::size_t>(std::min(count - have, kChunk)));
    const std::size_t got = readSome(bytes.data() + have, bytes.size() - have);
    bytes.resize(have + got);
    if (got == 0) {
      failTruncated(count - have, what);
    }
  }
  return bytes;
}

void InputFile::skip(std::uint64_t count, const char* what) {
  if (!compressed_ && count > sizeOnDisk_ - std::min(sizeOnDisk_, position_)) {
    failTruncated(count, what);
  }
  std::vector<std::uint8_t> scratch(static_cast<std::size_t>(std::min<std::uint64_t>(count, 1U << 20)));
  while (count > 0) {
    const auto got =
        readSome(scratch.data(), static_cast<std::size_t>(std::min<std::uint64_t>(count, scratch.size())));
    if (got == 0) {
      failTruncated(count, what);
    }
    count -= got;
  }
}

std::vector<std::uint8_t> InputFile::readUpTo(std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  std::size_t have = 0;
  for (std::size_t got = 1; got > 0 && have < count; have += got) {
    got = readSome(bytes.data() + have, count - have);
  }
  bytes.resize(have);
  return bytes;
}

std::vector<std::uint8_t> InputFile::readRest(std::uint64_t limit) {
  std::vector<std::uint8_t> bytes;
  if (!compressed_) {
    bytes.reserve(static_cast<std::size_t>(std::min(limit, sizeOnDisk_ - std::min(sizeOnDisk_, position_))));
  }
  while (true) {
    const std::size_t have = bytes.size();
    bytes.resize(have + (1U << 18));
    const std::size_t got = readSome(bytes.data() + have, 1U << 18);
    bytes.resize(have + got);
    if (got == 0) {
      return bytes;
    }
    if (bytes.size() > limit) {
      throw FormatError(path_, "The file unpacks to more than the " + std::to_string(limit) +
                                   " bytes accepted for its kind.");
    }
  }
}

std::uint64_t InputFile::drain() {
  std::vector<std::uint8_t> scratch(1U << 18);
  while (compressed_ && readSome(scratch.data(), scratch.size()) > 0) {
  }
  return compressed_ ? position_ : sizeOnDisk_;
}

std::vector<std::uint8_t> readBytes(const std::string& path, std::uint64_t limit) {
  InputFile file(path);
  return file.readRest(limit);
}

}  // namespace authalic
