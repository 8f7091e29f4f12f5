#include "GatheredSurface.h"

#include <string>

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticPointLocator.h>

#include "Core/base/Error.h"
#include "FieldArrays.h"

namespace authalic {
namespace {

constexpr double kSamePlace = 1e-6;  // of the diagonal: single precision, whichever way a piece was computed

/// Result vertex of each point, and a point and the last piece of each result vertex.
struct Joint {
  std::vector<vtkIdType> vertexOf;
  std::vector<int> pointOf;
  std::vector<int> lastPieceOf;
};

[[noreturn]] void refuseSeam(const double place[3]) {
  throw GeometryError("A surface in one piece is required, but it is spread over several processes and cannot be "
                      "joined: at (" + std::to_string(place[0]) + ", " + std::to_string(place[1]) + ", " +
                      std::to_string(place[2]) + ") mm two vertices of one piece meet another piece. Run on one "
                      "process.");
}

/// Of the vertices near a point, the one that points of earlier pieces have become; -1 = none.
vtkIdType vertexAt(const double place[3], vtkIdList* near, vtkIdType endOfEarlierPieces, const Joint& joint) {
  vtkIdType vertex = -1;
  for (vtkIdType i = 0; i < near->GetNumberOfIds(); ++i) {
    if (near->GetId(i) >= endOfEarlierPieces) continue;
    const vtkIdType other = joint.vertexOf[static_cast<std::size_t>(near->GetId(i))];
    if (vertex >= 0 && vertex != other) refuseSeam(place);
    vertex = other;
  }
  return vertex;
}

Joint joinPoints(vtkPolyData* all, const std::vector<vtkIdType>& pieceEnds) {
  Joint joint;
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(all);
  locator->BuildLocator();
  vtkNew<vtkIdList> near;
  std::size_t piece = 0;
  for (vtkIdType point = 0; point < all->GetNumberOfPoints(); ++point) {
    while (point >= pieceEnds[piece]) ++piece;
    double place[3];
    all->GetPoint(point, place);
    locator->FindPointsWithinRadius(kSamePlace * all->GetLength(), place, near);
    vtkIdType vertex = vertexAt(place, near, piece == 0 ? 0 : pieceEnds[piece - 1], joint);
    if (vertex < 0) {
      vertex = static_cast<vtkIdType>(joint.pointOf.size());
      joint.pointOf.push_back(static_cast<int>(point));
      joint.lastPieceOf.push_back(static_cast<int>(piece));
    } else {
      int& last = joint.lastPieceOf[static_cast<std::size_t>(vertex)];
      if (last == static_cast<int>(piece)) refuseSeam(place);
      last = static_cast<int>(piece);
    }
    joint.vertexOf.push_back(vertex);
  }
  return joint;
}

vtkSmartPointer<vtkPolyData> joined(vtkPolyData* all, const Joint& joint) {
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(all->GetPoints()->GetDataType());
  for (const int point : joint.pointOf) points->InsertNextPoint(all->GetPoint(point));
  result->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  auto cell = vtk::TakeSmartPointer(all->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    polygons->InsertNextCell(static_cast<int>(size));
    for (vtkIdType k = 0; k < size; ++k) polygons->InsertCellPoint(joint.vertexOf[static_cast<std::size_t>(ids[k])]);
  }
  result->SetPolys(polygons);
  gatherArrays(all->GetPointData(), joint.pointOf, result->GetPointData());
  result->GetCellData()->ShallowCopy(all->GetCellData());
  return result;
}

}  // namespace

vtkSmartPointer<vtkPolyData> joinPieces(const std::vector<vtkSmartPointer<vtkPolyData>>& pieces) {
  std::vector<vtkSmartPointer<vtkPolyData>> filled;
  for (const auto& piece : pieces) {
    if (piece && piece->GetNumberOfPoints() > 0) filled.push_back(piece);
  }
  if (filled.empty()) return vtkSmartPointer<vtkPolyData>::New();
  if (filled.size() == 1) return filled.front();
  vtkNew<vtkAppendPolyData> append;
  std::vector<vtkIdType> pieceEnds;
  vtkIdType end = 0;
  for (const auto& piece : filled) {
    vtkNew<vtkPolyData> own;
    own->ShallowCopy(piece);
    own->RemoveGhostCells();
    append->AddInputData(own);
    pieceEnds.push_back(end += own->GetNumberOfPoints());
  }
  append->Update();
  vtkSmartPointer<vtkPolyData> result = append->GetOutput();
  const bool polygonsOnly = result->GetNumberOfPolys() == result->GetNumberOfCells();
  if (polygonsOnly) result = joined(result, joinPoints(result, pieceEnds));
  passFields(filled.front(), result);
  return result;
}

}  // namespace authalic
