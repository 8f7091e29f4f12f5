/// Surfaces in pieces: joined where they meet, refused where nothing says how, and never mapped piece by piece.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <vtkBarycentricMap.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/base/Error.h"
#include "Core/mesh/MeshReport.h"
#include "Core/mesh/SurfaceTopology.h"
#include "FieldArrays.h"
#include "GatheredSurface.h"
#include "support/TestMeshes.h"

namespace {

using namespace authalic;
using authalic::testing::bumpyDisk;

vtkSmartPointer<vtkPolyData> polyData(const Points3& points, const Faces& faces) {
  auto result = vtkSmartPointer<vtkPolyData>::New();
  setMesh(result, TriangleMesh(points, faces));
  return result;
}

/// The faces whose mean x is on one side of 0, with the vertices they use and an array with the vertex of the whole.
vtkSmartPointer<vtkPolyData> half(const TriangleMesh& mesh, bool left) {
  std::vector<int> vertexOf(static_cast<std::size_t>(mesh.vertexCount()), -1), ids;
  std::vector<int> faces;
  for (Eigen::Index f = 0; f < mesh.faces().rows(); ++f) {
    double x = 0;
    for (int k = 0; k < 3; ++k) x += mesh.points()(mesh.faces()(f, k), 0);
    if ((x < 0) != left) continue;
    for (int k = 0; k < 3; ++k) {
      int& vertex = vertexOf[static_cast<std::size_t>(mesh.faces()(f, k))];
      if (vertex < 0) {
        vertex = static_cast<int>(ids.size());
        ids.push_back(mesh.faces()(f, k));
      }
      faces.push_back(vertex);
    }
  }
  Points3 points(static_cast<Eigen::Index>(ids.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) points.row(i) = mesh.points().row(ids[static_cast<std::size_t>(i)]);
  auto result = polyData(points, Eigen::Map<const Faces>(faces.data(), static_cast<Eigen::Index>(faces.size() / 3), 3));
  addArray(result->GetPointData(), "Vertex", ids);
  addField(result, "Side", std::string(left ? "left" : "right"));
  return result;
}

MeshReport reportOf(vtkPolyData* surface) {
  const TriangleMesh mesh = toTriangleMesh(surface);
  return inspect(mesh, SurfaceTopology(mesh.faces(), mesh.vertexCount()));
}

TEST(JoinPieces, GivesTheSurfaceThatWasDivided) {
  const TriangleMesh mesh = bumpyDisk(8);
  const auto whole = joinPieces({half(mesh, true), nullptr, half(mesh, false)});
  ASSERT_EQ(whole->GetNumberOfPoints(), mesh.vertexCount());
  EXPECT_EQ(whole->GetNumberOfCells(), mesh.faceCount());
  EXPECT_EQ(reportOf(whole).eulerCharacteristic, 1);
  EXPECT_EQ(reportOf(whole).loops.size(), 1u);
  vtkDataArray* vertex = whole->GetPointData()->GetArray("Vertex");
  for (vtkIdType i = 0; i < whole->GetNumberOfPoints(); ++i) {
    const auto original = static_cast<Eigen::Index>(vertex->GetComponent(i, 0));
    EXPECT_EQ(toPoints(whole).row(i), mesh.points().row(original));
  }
  EXPECT_EQ(textField(whole, "Side"), "left");
}

TEST(JoinPieces, JoinsWhatRoundingHasMoved) {
  const TriangleMesh mesh = bumpyDisk(8);
  auto moved = half(mesh, false);
  setPoints(moved, toPoints(moved).cast<float>().cast<double>().eval());
  EXPECT_EQ(joinPieces({half(mesh, true), moved})->GetNumberOfPoints(), mesh.vertexCount());
}

TEST(JoinPieces, LeavesASinglePieceAsItIs) {
  const auto piece = half(bumpyDisk(4), true);
  EXPECT_EQ(joinPieces({nullptr, vtkSmartPointer<vtkPolyData>::New(), piece}), piece);
  EXPECT_EQ(joinPieces({})->GetNumberOfPoints(), 0);
}

TEST(JoinPieces, RefusesASeamBetweenPieces) {
  // A piece with two vertices in one place, at the rim where the other piece begins.
  Points3 points(5, 3);
  points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0;
  Faces faces(2, 3);
  faces << 0, 1, 2, 3, 4, 2;
  Points3 beside(3, 3);
  beside << 1, 0, 0, 2, 0, 0, 2, 1, 0;
  Faces one(1, 3);
  one << 0, 1, 2;
  const auto split = polyData(points, faces), other = polyData(beside, one);
  for (const auto& order : {std::vector{split, other}, std::vector{other, split}}) {
    try {
      (void)joinPieces({order.begin(), order.end()});
      FAIL() << "joined";
    } catch (const GeometryError& e) {
      EXPECT_NE(std::string(e.what()).find("(1.000000, 0.000000, 0.000000) mm two vertices of one piece"),
                std::string::npos);
    }
  }
}

TEST(WholeInputs, GiveEverythingInPieceZeroAndNothingInTheOthers) {
  vtkNew<vtkBarycentricMap> map;
  map->SetInputData(polyData(bumpyDisk(6).points(), bumpyDisk(6).faces()));
  map->UpdatePiece(1, 3, 0);
  EXPECT_EQ(map->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(map->GetErrorKind(), vtkBarycentricMap::NONE);
  map->UpdatePiece(0, 3, 0);
  EXPECT_EQ(map->GetOutput()->GetNumberOfPoints(), bumpyDisk(6).vertexCount());
}

}  // namespace
