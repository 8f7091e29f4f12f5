#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <random>

#include <vtkSurfaceFileReader.h>

#include "support/TemporaryFolder.h"
#include "support/VtkHostileCases.h"
#include "support/VtkWords.h"

namespace {

using authalic::testing::TemporaryFolder;
using authalic::testing::vtkHostileCases;
using authalic::testing::VtkWords;

class HostileVtkFiles : public ::testing::TestWithParam<int> {
 protected:
  const authalic::testing::VtkHostileCase& hostile = vtkHostileCases()[static_cast<std::size_t>(GetParam())];
  const TemporaryFolder folder;
  const std::string path = folder / hostile.name;

  std::string whole() const {
    hostile.write(path);
    std::ifstream input(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(input), {}};
  }
  /// The file or the surface is refused, or what is read is consistent, in less than a second.
  int kindOf(const std::string& bytes) const {
    std::filesystem::remove(path);
    std::ofstream(path, std::ios::binary) << bytes;
    vtkNew<vtkSurfaceFileReader> reader;
    const VtkWords words(reader);
    reader->SetFileName(path.c_str());
    const std::clock_t begin = std::clock();
    reader->Update();
    EXPECT_LT(std::clock() - begin, CLOCKS_PER_SEC) << hostile.name;
    const int kind = reader->GetErrorKind();
    EXPECT_TRUE(kind == 0 || kind == vtkSurfaceAlgorithm::FORMAT || kind == vtkSurfaceAlgorithm::SURFACE) << kind;
    vtkPolyData* surface = reader->GetOutput();
    EXPECT_EQ(kind == 0, surface->GetNumberOfPoints() > 0);
    for (vtkIdType i = 0; i < surface->GetPolys()->GetConnectivityArray()->GetNumberOfValues(); ++i) {
      const double id = surface->GetPolys()->GetConnectivityArray()->GetComponent(i, 0);
      EXPECT_TRUE(id >= 0 && id < static_cast<double>(surface->GetNumberOfPoints()));
    }
    return kind;
  }
  void alter(unsigned seed, int mutations) const {
    const std::string original = whole();
    ASSERT_EQ(kindOf(original), 0) << hostile.name;
    std::mt19937 random(seed);
    for (int i = 0; i < mutations; ++i) {
      std::string bytes = original;
      const std::size_t at = random() % bytes.size();
      if (i % 7 == 0) {
        bytes.insert(at, bytes.substr(random() % bytes.size(), random() % 40));
      } else if (i % 7 == 1) {
        bytes.erase(at, random() % 20);
      } else {
        for (int k = 0; k <= i % 3; ++k) {
          const char digit = static_cast<char>('0' + random() % 10);
          bytes[random() % bytes.size()] = i % 2 == 0 ? digit : static_cast<char>(i % 5 == 0 ? 0xFF : random());
        }
      }
      kindOf(bytes);
    }
  }
};

class HostileVtkFilesSlow : public HostileVtkFiles {};

std::string caseName(const ::testing::TestParamInfo<int>& hostile) {
  std::string name = vtkHostileCases()[static_cast<std::size_t>(hostile.param)].name;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

long peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

}  // namespace

TEST_P(HostileVtkFiles, TruncatedAnywhereAreRefused) {
  const std::string bytes = whole();
  const bool hasNoEnd = path.substr(path.size() - 4) == ".vtk";  // some whole sections are a file too
  for (std::size_t part = 0; part < 37; ++part) {
    EXPECT_TRUE(kindOf(bytes.substr(0, bytes.size() * part / 37)) != 0 || hasNoEnd) << part;
  }
  EXPECT_NE(kindOf(""), 0);
}

TEST_P(HostileVtkFiles, AlteredBytesAreRefusedOrConsistentWithoutTheMemory) {
  const long before = peakMegabytes();
  alter(static_cast<unsigned>(GetParam()) + 1, 400);
  EXPECT_LT(peakMegabytes() - before, 256);
}

TEST_P(HostileVtkFilesSlow, TenThousandAlteredFilesAreRefusedOrConsistent) {
  alter(static_cast<unsigned>(GetParam()) + 1001, 10000);
}

const auto everyVtkCase = ::testing::Range(0, static_cast<int>(vtkHostileCases().size()));
INSTANTIATE_TEST_SUITE_P(Readers, HostileVtkFiles, everyVtkCase, caseName);
INSTANTIATE_TEST_SUITE_P(Readers, HostileVtkFilesSlow, everyVtkCase, caseName);
