// libFuzzer on one reader, chosen by its name in AUTHALIC_FUZZ_READER (support/HostileCases.h lists them).
// With AUTHALIC_FUZZ_SEEDS set to a folder, writes the reader's own file there as a seed and ends.
//
// Only a FormatError may leave a reader, and what it returns must not contradict itself; libFuzzer's limits of time and
// memory and the sanitizers see the rest.
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "Core/base/Error.h"
#include "support/HostileCases.h"

namespace {

namespace fs = std::filesystem;
using authalic::testing::HostileCase;

/// The reader and the file that it reads again and again, in memory where the system has such a folder.
struct Target {
  const HostileCase* hostile = nullptr;
  fs::path folder;
  ~Target() {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  [[nodiscard]] std::string path() const { return (folder / hostile->name).string(); }
};

const HostileCase* chosenReader() {
  const char* name = std::getenv("AUTHALIC_FUZZ_READER");
  for (const HostileCase& hostile : authalic::testing::allHostileCases()) {
    if (name && std::string(name) == hostile.name) {
      return &hostile;
    }
  }
  std::fprintf(stderr, "AUTHALIC_FUZZ_READER must name a reader:");
  for (const HostileCase& hostile : authalic::testing::allHostileCases()) {
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

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  if (const char* seeds = std::getenv("AUTHALIC_FUZZ_SEEDS")) {
    const HostileCase* hostile = chosenReader();
    hostile->write((fs::path(seeds) / hostile->name).string());
    std::exit(0);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string path = target().path();
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"), &std::fclose);
  std::fwrite(data, 1, size, file.get());
  file.reset();
  try {
    target().hostile->read(path);
  } catch (const authalic::FormatError&) {
    return 0;  // refused in words
  }
  return 0;  // any other exception ends the program
}
