#include "Core/topology/SurfaceRepair.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <utility>

#include "Core/base/Error.h"
#include "Core/topology/RepairedFaces.h"

namespace authalic {
namespace {

/// Rounds until one changes nothing; more are never needed but where steps undo each other.
constexpr int kMostPasses = 20;

struct KindWords {
  const char *name, *one, *many;
};
constexpr KindWords kWords[kRepairKinds] = {
    {"isolated_vertices", "isolated vertex removed", "isolated vertices removed"},
    {"degenerate_faces", "degenerate face removed", "degenerate faces removed"},
    {"duplicate_faces", "duplicate face removed", "duplicate faces removed"},
    {"seams", "pair of coincident boundary edges joined", "pairs of coincident boundary edges joined"},
    {"t_junctions", "T-junction: face split at the vertex on its edge",
     "T-junctions: faces split at vertices on their edges"},
    {"non_manifold_edges", "non-manifold edge taken apart", "non-manifold edges taken apart"},
    {"non_manifold_vertices", "non-manifold vertex split", "non-manifold vertices split"},
    {"stray_components", "stray component removed", "stray components removed"},
    {"flipped_faces", "face turned round", "faces turned round"},
    {"inside_out_components", "component turned outside out", "components turned outside out"},
    {"holes", "hole filled", "holes filled"},
    {"handles", "handle cut and capped", "handles cut and capped"},
};

void requireUsable(const Points3& points, const Faces& faces) {
  if (faces.rows() == 0) throw GeometryError("A surface with at least one triangle is required; there is none.");
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int v = faces(f, k);
      if (v < 0 || v >= points.rows()) {
        throw GeometryError("Vertex indices from 0 to " + std::to_string(points.rows() - 1) +
                            " are required, but face " + std::to_string(f) + " names " + std::to_string(v) +
                            "; the file is damaged.");
      }
      if (!points.row(v).allFinite()) {
        throw GeometryError("Finite coordinates are required, but vertex " + std::to_string(v) + " of face " +
                            std::to_string(f) + " has a NaN or infinite one, and there is no place to repair it to.");
      }
    }
  }
}

void listIsolated(RepairedFaces& surface) {
  std::vector<char> used(surface.pointCount(), 0);
  for (const RepairedFace& face : surface.faces) {
    for (const int v : face.v) used[static_cast<std::size_t>(v)] = 1;
  }
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) continue;
    surface.listVertices(RepairKind::IsolatedVertex, {static_cast<int>(v)});
    if (!surface.points[v].allFinite()) surface.points[v].setZero();  // goes in the end; must not get in the way
  }
}

void requireFaces(const RepairedFaces& surface) {
  if (!surface.faces.empty()) return;
  throw GeometryError("A surface with at least one sound triangle is required, but every one of the " +
                      std::to_string(surface.changes.size()) + " defects took its triangles with it.");
}

void runPass(RepairedFaces& surface, const SurfaceRepairOptions& options, const Execution& execution) {
  removeRepeatedVertices(surface);
  requireFaces(surface);
  removeDuplicates(surface);
  if (options.sewSeams) sewSeams(surface);
  splitAtJunctions(surface, options.junctionTolerance, options.sewSeams);
  if (options.sewSeams) sewSeams(surface);
  removeRepeatedVertices(surface);
  removeDuplicates(surface);
  requireFaces(surface);
  requireSheets(surface);
  separateSheets(surface);
  removeStrays(surface, options.strayShare);
  orient(surface);
  removeDegenerate(surface);
  requireFaces(surface);
  execution.throwIfCancelled();
  fillHoles(surface, options.largestHole);
  cutHandles(surface, options.largestHandle, execution);
}

/// The surface without vertices that no face uses.
void extract(const RepairedFaces& surface, SurfaceRepair& result) {
  std::vector<int> number(surface.pointCount(), -1);
  for (const RepairedFace& face : surface.faces) {
    for (const int v : face.v) number[static_cast<std::size_t>(v)] = 0;
    result.originalFaceIds.push_back(face.original);
    result.faceSources.push_back(face.source);
  }
  std::vector<Eigen::Vector3d> kept;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<int>(kept.size());
    kept.push_back(surface.points[v]);
    result.originalPointIds.push_back(surface.originalPoint[v]);
    result.pointSources.push_back(surface.pointSource[v]);
  }
  Points3 points(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t i = 0; i < kept.size(); ++i) points.row(static_cast<Eigen::Index>(i)) = kept[i].transpose();
  Faces faces = surface.faceMatrix();
  for (Eigen::Index k = 0; k < faces.size(); ++k) faces.data()[k] = number[static_cast<std::size_t>(faces.data()[k])];
  result.mesh = TriangleMesh(std::move(points), std::move(faces));
}

void requireRepaired(const SurfaceRepair& result) {
  if (result.after.orientedManifold()) return;
  throw TopologyError("The surface could not be made a manifold in " + std::to_string(result.passes) +
                      " rounds; what is left has " + result.after.summary() +
                      ": take that part out by hand, or remesh the surface.");
}

}  // namespace

const char* repairKindName(RepairKind kind) noexcept { return kWords[static_cast<int>(kind)].name; }

std::string repairKindWords(RepairKind kind, int count) {
  const KindWords& words = kWords[static_cast<int>(kind)];
  return std::to_string(count) + " " + (count == 1 ? words.one : words.many);
}

std::string placeWords(const Eigen::Vector3d& place) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(5);
  for (int k = 0; k < 3; ++k) text << (k == 0 ? "(" : ", ") << std::round(1e6 * place[k]) / 1e6 + 0.0;
  return text.str() + ") mm";
}

void SurfaceRepairOptions::validate() const {
  if (!(junctionTolerance >= 0 && junctionTolerance <= 0.1)) {
    throw InvalidArgument("The tolerance of T-junctions must lie in [0, 0.1] of the edge's length, but it is " +
                          std::to_string(junctionTolerance) + ".");
  }
  if (!(strayShare >= 0 && strayShare <= 1)) {
    throw InvalidArgument("The share of area below which a component is a stray must lie in [0, 1], but it is " +
                          std::to_string(strayShare) + ".");
  }
  if (!std::isfinite(largestHole) || !std::isfinite(largestHandle)) {
    throw InvalidArgument("Finite lengths of the largest hole and handle are required (negative = automatic).");
  }
}

int SurfaceRepair::count(RepairKind kind) const {
  return static_cast<int>(
      std::count_if(changes.begin(), changes.end(), [kind](const auto& c) { return c.kind == kind; }));
}

std::string SurfaceRepair::remaining() const {
  std::string text;
  const auto add = [&text](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
  if (status == Status::NotConverged) add("changes in every one of " + std::to_string(passes) + " rounds");
  if (after.components.size() > 1) add(std::to_string(after.components.size()) + " components");
  if (after.genus > 0) add("genus " + std::to_string(after.genus));
  if (!after.degenerateFaces.empty()) add(std::to_string(after.degenerateFaces.size()) + " degenerate faces");
  return text;
}

SurfaceRepair repairSurface(const Points3& points, const Faces& faces, const SurfaceRepairOptions& options,
                            const Execution& execution) {
  options.validate();
  requireUsable(points, faces);
  RepairedFaces surface(points, faces);
  listIsolated(surface);
  SurfaceRepair result;
  result.status = Status::NotConverged;
  while (result.status == Status::NotConverged && result.passes < kMostPasses) {
    execution.report(static_cast<double>(result.passes) / (result.passes + 2), "repair");
    const std::size_t before = surface.changes.size();
    runPass(surface, options, execution);
    ++result.passes;
    if (surface.changes.size() == before) result.status = Status::Converged;
  }
  extract(surface, result);
  result.changes = std::move(surface.changes);
  result.after = inspect(result.mesh);
  requireRepaired(result);
  execution.report(1.0, "repair");
  return result;
}

}  // namespace authalic
