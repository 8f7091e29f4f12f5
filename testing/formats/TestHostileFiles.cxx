#include <gtest/gtest.h>

#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <random>

#include "Core/base/Error.h"
#include "Formats/Gzip.h"
#include "Formats/InputFile.h"
#include "support/HostileCases.h"
#include "support/TemporaryFolder.h"

namespace {

using namespace authalic;
using authalic::testing::allHostileCases;
using authalic::testing::HostileCase;
using authalic::testing::isPacked;
using authalic::testing::TemporaryFolder;

class HostileFiles : public ::testing::TestWithParam<int> {
 protected:
  const HostileCase hostile = allHostileCases()[static_cast<std::size_t>(GetParam())];
  const TemporaryFolder folder;
  const std::string path = folder / hostile.name;

  std::string whole() const {
    hostile.write(path);
    std::ifstream input(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(input), {}};
  }
  /// Only a FormatError may leave a reader, in less than a second. Returns whether the file was accepted.
  bool accepts(const std::string& bytes) const {
    std::filesystem::remove(path);  // some file systems wait for the disk when a file is cut and written again
    std::ofstream(path, std::ios::binary) << bytes;
    const std::clock_t begin = std::clock();
    const bool accepted = isRead();
    EXPECT_LT(std::clock() - begin, CLOCKS_PER_SEC) << hostile.name;
    return accepted;
  }
  bool isRead() const {
    try {
      hostile.read(path);
      return true;
    } catch (const FormatError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(error.path(), 0), 0U);
      return false;
    } catch (const std::exception& error) {
      ADD_FAILURE() << hostile.name << ": " << error.what();
    }
    return false;
  }
  /// Formats without counts, and one whose footer may be missing: a part of such a file is a file.
  bool hasNoEnd() const {
    return hostile.name == std::string("t.txt") || hostile.name == std::string("s.obj") ||
           hostile.name == std::string("lh.white");
  }
  /// What is inside a gzip file.
  std::string unpacked() const {
    const auto bytes = readBytes(path, 1U << 24);
    return {bytes.begin(), bytes.end()};
  }
  std::string packed(const std::string& bytes) const {
    const auto file = gzipped(path, {bytes.begin(), bytes.end()});
    return {file.begin(), file.end()};
  }
  void alter(unsigned seed, int mutations) const {
    const std::string original = whole();
    const std::string inside = isPacked(original) ? unpacked() : "";
    std::mt19937 random(seed);
    for (int i = 0; i < mutations; ++i) {
      const bool deep = !inside.empty() && i % 4 != 0;
      std::string bytes = deep ? inside : original;
      // Every other mutation hits the header, where the counts are.
      const std::size_t range = i % 2 == 0 ? bytes.size() : std::min<std::size_t>(bytes.size(), 400);
      for (int k = 0; k <= i % 3; ++k) {
        bytes[random() % range] = static_cast<char>(i % 5 == 0 ? 0xFF : random());
      }
      accepts(deep ? packed(bytes) : bytes);
    }
  }
};

class HostileFilesSlow : public HostileFiles {};

long peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

}  // namespace

TEST_P(HostileFiles, TruncatedAnywhereAreRefused) {
  const std::string bytes = whole();
  ASSERT_TRUE(accepts(bytes)) << hostile.name;
  const std::string inside = isPacked(bytes) ? unpacked() : "";
  for (std::size_t part = 0; part < 37; ++part) {
    EXPECT_FALSE(accepts(bytes.substr(0, bytes.size() * part / 37)) && !hasNoEnd()) << part;
    if (!inside.empty()) {
      EXPECT_FALSE(accepts(packed(inside.substr(0, inside.size() * part / 37)))) << part;
    }
  }
  EXPECT_FALSE(accepts(""));
}

TEST_P(HostileFiles, AlteredBytesAreRefusedOrConsistentWithoutTheMemory) {
  const long before = peakMegabytes();
  alter(static_cast<unsigned>(GetParam()) + 1, 1000);
  EXPECT_LT(peakMegabytes() - before, 300);  // a sanitizer keeps what is freed
}

TEST_P(HostileFilesSlow, TenThousandAlteredFilesAreRefusedOrConsistent) {
  alter(static_cast<unsigned>(GetParam()) + 1001, 10000);
}

TEST_P(HostileFiles, OtherKindsAreRefused) {
  for (const std::string& junk : {std::string(5000, '\0'), std::string(5000, '\xFF'), std::string("PK\3\4 not this"),
                                 std::string("\x1F\x8B\x08 broken gzip"), std::string(3, '\xFF')}) {
    EXPECT_FALSE(accepts(junk)) << hostile.name << " of " << junk.size();
  }
}

namespace {

std::string caseName(const ::testing::TestParamInfo<int>& hostile) {
  std::string name = allHostileCases()[static_cast<std::size_t>(hostile.param)].name;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

}  // namespace

const auto everyCase = ::testing::Range(0, static_cast<int>(allHostileCases().size()));
INSTANTIATE_TEST_SUITE_P(Readers, HostileFiles, everyCase, caseName);
INSTANTIATE_TEST_SUITE_P(Readers, HostileFilesSlow, everyCase, caseName);
