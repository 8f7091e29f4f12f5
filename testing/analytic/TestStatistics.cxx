#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "Core/statistics/ElementTable.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

/// The mean of eˣ cos(3y) over a rectangle is the product of two one-dimensional means.
TEST(ElementTable, ConvergesToTheMeanOfASmoothFieldWithSecondOrder) {
  const auto exact = [](const ElementRow& row) {
    return (std::exp(row.uMax) - std::exp(row.uMin)) / (row.uMax - row.uMin) *
           (std::sin(3 * row.vMax) - std::sin(3 * row.vMin)) / (3 * (row.vMax - row.vMin));
  };
  double coarse = 0;
  for (const int n : {13, 26, 52}) {
    const TriangleMesh mesh = gridMesh(n, n);
    SurfaceField field{"f", {}, {}, "", ""};
    for (int v = 0; v < mesh.vertexCount(); ++v)
      field.values.push_back(std::exp(mesh.point(v)[0]) * std::cos(3 * mesh.point(v)[1]));
    const Points2 image = mesh.points().leftCols<2>();
    double error = 0;
    for (const ElementRow& row : elementTable(mesh, elementGrid(mesh, image, {25}), {field}).rows) {
      error = std::max(error, std::abs(row.fields[0].mean - exact(row)));
    }
    if (coarse > 0) {
      EXPECT_GT(coarse / error, 3.5) << n;
    }
    coarse = error;
  }
}
