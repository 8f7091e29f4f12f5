#include <gtest/gtest.h>

#include <fstream>

#include "Core/base/Error.h"
#include "Formats/FileContent.h"
#include "Formats/Gifti.h"
#include "Formats/Mz3.h"
#include "Formats/VolumeFile.h"
#include "support/HostileCases.h"
#include "support/TemporaryFolder.h"

namespace {

using namespace authalic;
using authalic::testing::TemporaryFolder;

}  // namespace

TEST(Content, ARowOfVoxelsIsPerVertexData) {
  const TemporaryFolder folder;
  for (const char* name : {"v.nii", "v.nii.gz", "v.mgh", "v.mgz"}) {
    ScalarVolume row({5, 1, 1}, Eigen::Matrix4d::Identity());
    row.values = {1, 2, 3, 4, 5};
    writeVolume(folder / name, row);
    EXPECT_EQ(contentOf(folder / name), FileContent::VertexData) << name;
    EXPECT_EQ(readVertexScalars(folder / name), row.values) << name;
    EXPECT_EQ(readVertexFrames(folder / name).size(), 1U) << name;
    writeVolume(folder / name, ScalarVolume({5, 2, 1}, Eigen::Matrix4d::Identity()));
    EXPECT_EQ(contentOf(folder / name), FileContent::Volume) << name;
    EXPECT_THROW(static_cast<void>(readVertexScalars(folder / name)), FormatError) << name;
  }
}

TEST(Content, OfEveryKindIsFound) {
  const TemporaryFolder folder;
  for (const auto& hostile : authalic::testing::allHostileCases()) {
    const std::string name = hostile.name, path = folder / name;
    hostile.write(path);
    const bool patch = name.find(".patch.") != std::string::npos;
    const bool volume = name.rfind("v.", 0) == 0;
    bool surface = name == "lh.white" || name.rfind("s.", 0) == 0 || name.find("quads") != std::string::npos;
    surface = surface || name == "plain.mz3";
    const FileContent expected = patch     ? FileContent::Patch
                                 : volume  ? FileContent::Volume
                                 : surface ? FileContent::Surface
                                           : FileContent::VertexData;
    if (name != "lh.oldcurv") {  // without magic number and known ending
      EXPECT_EQ(contentOf(path), expected) << name;
    }
  }
  std::ofstream(folder / "empty.off");
  EXPECT_THROW(static_cast<void>(contentOf(folder / "empty.off")), FormatError);
  EXPECT_THROW(static_cast<void>(contentOf(folder / "missing.off")), FormatError);
}
