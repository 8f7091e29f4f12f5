#include <gtest/gtest.h>

#include "Core/imaging/SimplePoint.h"

using namespace authalic;

TEST(SimplePoint, LinkIsATriangulatedSphereOfFourteenVerticesAndTwentyFourTriangles) {
  int edges = 0, triangles = 0;
  const auto& link = latticeLinkAdjacency();
  for (std::size_t a = 0; a < 14; ++a) {
    for (std::size_t b = a + 1; b < 14; ++b) {
      if (!(link[a] >> b & 1)) continue;
      ++edges;
      for (std::size_t c = b + 1; c < 14; ++c) triangles += (link[a] >> c & 1) && (link[b] >> c & 1);
    }
  }
  EXPECT_EQ(edges, 36);
  EXPECT_EQ(triangles, 24);
  EXPECT_EQ(14 - edges + triangles, 2);
}

TEST(SimplePoint, NeighboursComeInOppositePairs) {
  for (std::size_t k = 0; k < 14; ++k) {
    for (std::size_t a = 0; a < 3; ++a) EXPECT_EQ(kLatticeNeighbours[k][a], -kLatticeNeighbours[13 - k][a]);
  }
}

TEST(SimplePoint, IsolatedAndInteriorVoxelsAreNotSimple) {
  EXPECT_FALSE(isSimplePoint(0));
  EXPECT_FALSE(isSimplePoint((1u << 14) - 1));
}

TEST(SimplePoint, EndOfALineIsSimpleAndItsMiddleIsNot) {
  EXPECT_TRUE(isSimplePoint(1u << 6));
  EXPECT_FALSE(isSimplePoint(1u << 6 | 1u << 7));
}

TEST(SimplePoint, IsTheSameForObjectAndBackground) {
  for (unsigned set = 0; set < 1u << 14; ++set) {
    EXPECT_EQ(isSimplePoint(static_cast<std::uint16_t>(set)),
              isSimplePoint(static_cast<std::uint16_t>(~set & 0x3fff)));
  }
}
