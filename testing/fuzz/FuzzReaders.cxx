// libFuzzer on one reader, chosen by its name in AUTHALIC_FUZZ_READER (support/HostileCases.h lists them).
// With AUTHALIC_FUZZ_SEEDS set to a folder, writes the reader's own file there as a seed and ends.
//
// What is gzipped is fuzzed inside: the seed is unpacked, and every input is packed before it is read, so that the
// fuzzer meets the reader and not the checksum. With AUTHALIC_FUZZ_RAW set it is not.
//
// Only a FormatError may leave a reader, and what it returns must not contradict itself; libFuzzer's limits of time and
// memory and the sanitizers see the rest.
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "Core/base/Error.h"
#include "Formats/Gzip.h"
#include "Formats/InputFile.h"
#include "VtkSurfaceFormats.h"
#include "support/HostileCases.h"
#include "support/VtkHostileCases.h"

namespace {

namespace fs = std::filesystem;
using authalic::testing::HostileCase;

/// The reader and the file that it reads again and again, in memory where the system has such a folder.
struct Target {
  const HostileCase* hostile = nullptr;
  fs::path folder;
  bool packed = false;
  ~Target() {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  [[nodiscard]] std::string path() const { return (folder / hostile->name).string(); }
};

void readConsistentVtk(const std::string& path) {
  vtkNew<vtkPolyData> surface;
  authalic::readVtkSurface(path, surface);
  authalic::testing::require(surface->GetNumberOfPoints() > 0, "no points");
}

const std::vector<HostileCase>& everyCase() {
  static const std::vector<HostileCase> all = [] {
    std::vector<HostileCase> joined = authalic::testing::allHostileCases();
    for (const auto& hostile : authalic::testing::vtkHostileCases()) {
      joined.push_back({hostile.name, hostile.write, readConsistentVtk});
    }
    return joined;
  }();
  return all;
}

const HostileCase* chosenReader() {
  const char* name = std::getenv("AUTHALIC_FUZZ_READER");
  for (const HostileCase& hostile : everyCase()) {
    if (name && std::string(name) == hostile.name) {
      return &hostile;
    }
  }
  std::fprintf(stderr, "AUTHALIC_FUZZ_READER must name a reader:");
  for (const HostileCase& hostile : everyCase()) {
    std::fprintf(stderr, " %s", hostile.name);
  }
  std::fprintf(stderr, "\n");
  std::exit(2);
}

Target& target() {
  static Target instance = [] {
    Target made;
    made.hostile = chosenReader();
    const fs::path memory = "/dev/shm";
    made.folder = (fs::exists(memory) ? memory : fs::temp_directory_path()) /
                  ("authalic-fuzz-" + std::to_string(::getpid()));
    fs::create_directory(made.folder);
    return made;
  }();
  return instance;
}

}  // namespace

namespace {

std::vector<std::uint8_t> fileBytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void writeBytes(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"), &std::fclose);
  std::fwrite(bytes.data(), 1, bytes.size(), file.get());
}

bool isPackedFile(const std::string& path) {
  const auto bytes = fileBytes(path);
  return !std::getenv("AUTHALIC_FUZZ_RAW") && bytes.size() > 2 && bytes[0] == 0x1F && bytes[1] == 0x8B;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  if (const char* seeds = std::getenv("AUTHALIC_FUZZ_SEEDS")) {
    const HostileCase* hostile = chosenReader();
    const std::string seed = (fs::path(seeds) / hostile->name).string();
    hostile->write(seed);
    if (isPackedFile(seed)) {
      const auto inside = authalic::readBytes(seed, 1U << 24);
      fs::remove(seed);
      writeBytes(seed + ".inside", inside);
    }
    std::exit(0);
  }
  target().hostile->write(target().path());
  target().packed = isPackedFile(target().path());
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string path = target().path();
  const std::vector<std::uint8_t> bytes(data, data + size);
  writeBytes(path, target().packed ? authalic::gzipped(path, bytes) : bytes);
  try {
    target().hostile->read(path);
  } catch (const authalic::FormatError&) {
    return 0;  // refused in words
  }
  return 0;  // any other exception ends the program
}
