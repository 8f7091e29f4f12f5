#include "Core/transport/PowerDiagram.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/transport/ConvexRegion.h"
#include "Core/transport/DensityIntegrals.h"
#include "Core/transport/DistinctSites.h"
#include "Core/transport/RegularFlips.h"
#include "Core/transport/RegularTriangulation.h"

namespace authalic {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Side of a cell inside the domain, in the direction that has the cell to its left.
struct Chord {
  Eigen::Vector2d start, end;
  bool startsInside, endsInside;  // at a corner of the diagram, not on the boundary of the domain
  int neighbour;
  std::size_t side = 0;  // of the outline
};

}  // namespace

// Connectivity and corners of the diagram, and the walk around each cell.
struct PowerDiagram::Walk {
  Walk(Points2 y, const PlanarDomain& domain)
      : sites(std::move(y)), region(domain), triangulation(makeRegularTriangulation(sites)) {}

  Points2 sites;
  ConvexRegion region;
  std::unique_ptr<RegularTriangulation> triangulation;
  Heights heights;
  RegularConnectivity dual;
  RegularConnectivity kept;              // a triangulation of all sites, to flip from; or empty
  std::vector<Eigen::Vector2d> corners;  // per finite face
  std::vector<char> inside;              // per face: its corner lies in the domain
  std::vector<int> rank;                 // dimension < 2: place of a site on the line
  int owner = 0;                         // site whose cell has a certain point of the boundary

  bool update(const Heights& newHeights, bool unlessHidden, const Execution& execution);
  bool triangulate(const Eigen::VectorXd& rounded, bool unlessHidden);
  [[nodiscard]] Eigen::Vector2d cornerOf(const std::array<int, 3>& face) const;
  bool chordBetween(int i, int j, int before, int after, Chord& chord) const;
  void chordsOf(int site, std::vector<Chord>& chords) const;
  void outlineOf(int site, std::vector<Chord>& chords, CellOutline& outline) const;
};

// x with ⟨x, y_j − y_i⟩ = h_i − h_j and ⟨x, y_k − y_i⟩ = h_i − h_k.
Eigen::Vector2d PowerDiagram::Walk::cornerOf(const std::array<int, 3>& face) const {
  using Real = long double;
  const int i = face[0], j = face[1], k = face[2];
  const Real ax = Real(sites(j, 0)) - sites(i, 0), ay = Real(sites(j, 1)) - sites(i, 1), a = heights[i] - heights[j];
  const Real bx = Real(sites(k, 0)) - sites(i, 0), by = Real(sites(k, 1)) - sites(i, 1), b = heights[i] - heights[k];
  const Real turn = std::max(ax * by - ay * bx, 1e-280L);  // > 0 in exact arithmetic
  return {static_cast<double>((a * by - b * ay) / turn), static_cast<double>((b * ax - a * bx) / turn)};
}

// From the last triangulation by flips where that is possible, else anew. False when unlessHidden and a site is.
bool PowerDiagram::Walk::triangulate(const Eigen::VectorXd& rounded, bool unlessHidden) {
  const FlipResult flips = kept.corners.empty() ? FlipResult::GivenUp : flipToRegular(sites, heights, kept);
  if (flips == FlipResult::Regular) {
    dual = kept;
    return true;
  }
  if (flips == FlipResult::Hidden && unlessHidden) return false;
  dual = triangulation->triangulate(rounded);
  const bool allVisible = std::find(dual.faceOf.begin(), dual.faceOf.end(), -1) == dual.faceOf.end();
  if (dual.dimension == 2 && allVisible) kept = dual;
  return allVisible || !unlessHidden;
}

bool PowerDiagram::Walk::update(const Heights& newHeights, bool unlessHidden, const Execution& execution) {
  heights = newHeights;
  const Eigen::VectorXd rounded = heights.cast<double>();
  if (!triangulate(rounded, unlessHidden)) return false;
  corners.resize(dual.corners.size());
  inside.assign(dual.corners.size(), 0);
  rank.assign(at(static_cast<int>(dual.line.empty() ? 0 : sites.rows())), -1);
  const Eigen::Vector2d somewhere = region.outline().corners.front();
  (sites * somewhere + rounded).maxCoeff(&owner);
  for (std::size_t k = 0; k < dual.line.size(); ++k) rank[at(dual.line[k])] = static_cast<int>(k);
  parallelFor(dual.corners.size(), execution, [this](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const std::array<int, 3>& face = dual.corners[f];
      if (face[0] < 0 || face[1] < 0 || face[2] < 0) continue;
      corners[f] = cornerOf(face);
      inside[f] = region.contains(corners[f]);
    }
  });
  return true;
}

// The side between cells i and j from face `before` to face `after` (−1 at infinity), as cell i sees it.
bool PowerDiagram::Walk::chordBetween(int i, int j, int before, int after, Chord& chord) const {
  const bool startsInside = before >= 0 && inside[at(before)], endsInside = after >= 0 && inside[at(after)];
  if (startsInside && endsInside) {
    chord = {corners[at(before)], corners[at(after)], true, true, j, 0};
    return true;
  }
  if (i > j) {  // the same bits from both sides
    if (!chordBetween(j, i, after, before, chord)) return false;
    chord = {chord.end, chord.start, chord.endsInside, chord.startsInside, j, 0};
    return true;
  }
  const Eigen::Vector2d normal = (sites.row(j) - sites.row(i)).transpose();
  const double square = normal.squaredNorm();
  const Eigen::Vector2d foot = static_cast<double>(heights[i] - heights[j]) / square * normal;
  const Eigen::Vector2d direction = Eigen::Vector2d(-normal.y(), normal.x()) / std::sqrt(square);
  const ConvexRegion::Interval part = region.along(foot, direction);
  const auto isFinite = [this](int face) {
    if (face < 0) return false;
    const std::array<int, 3>& corner = dual.corners[at(face)];
    return corner[0] >= 0 && corner[1] >= 0 && corner[2] >= 0;
  };
  chord = {foot + part.low * direction, foot + part.high * direction, startsInside, endsInside, j, 0};
  if (startsInside) chord.start = corners[at(before)];
  if (endsInside) chord.end = corners[at(after)];
  if (startsInside || endsInside) {
    if (part.low > part.high) (startsInside ? chord.end : chord.start) = foot;
    return true;
  }
  if (!(part.low < part.high)) return false;
  if (isFinite(before) && direction.dot(corners[at(before)]) >= part.high) return false;
  return !(isFinite(after) && direction.dot(corners[at(after)]) <= part.low);
}

void PowerDiagram::Walk::chordsOf(int site, std::vector<Chord>& chords) const {
  chords.clear();
  Chord chord;
  if (dual.dimension < 2) {
    const int place = rank[at(site)], last = static_cast<int>(dual.line.size()) - 1;
    for (const int other : {place - 1, place + 1}) {
      if (other < 0 || other > last) continue;
      if (chordBetween(site, dual.line[at(other)], -1, -1, chord)) chords.push_back(chord);
    }
    return;
  }
  const int begun = dual.faceOf[at(site)];
  int face = begun;
  do {
    const std::array<int, 3>& corner = dual.corners[at(face)];
    const int k = corner[0] == site ? 0 : corner[1] == site ? 1 : 2;
    const int next = dual.neighbours[at(face)][at((k + 1) % 3)], other = corner[at((k + 2) % 3)];
    if (other >= 0 && chordBetween(site, other, face, next, chord)) chords.push_back(chord);
    face = next;
  } while (face != begun);
}

void PowerDiagram::Walk::outlineOf(int site, std::vector<Chord>& chords, CellOutline& outline) const {
  outline.clear();
  if (dual.faceOf[at(site)] < 0) return chords.clear();
  chordsOf(site, chords);
  for (std::size_t k = 0; k < chords.size(); ++k) {
    const Chord& next = chords[(k + 1) % chords.size()];
    chords[k].side = outline.corners.size();
    outline.add(chords[k].start);
    if (!chords[k].endsInside || !next.startsInside) {
      region.addBoundary(chords[k].end, next.start, chords.size() == 1, outline);
    }
  }
  if (chords.empty() && site == owner) outline = region.outline();  // no side in the domain
}

PowerDiagram::PowerDiagram(Points2 sites, const PlanarDomain& domain) : domain_(domain) {
  requireDistinctSites(sites);
  walk_ = std::make_unique<Walk>(std::move(sites), domain);
}

PowerDiagram::PowerDiagram(Points2 sites, std::shared_ptr<const PiecewiseLinearDensity> source)
    : PowerDiagram(std::move(sites), source->domain()) {
  source_ = std::move(source);
}

PowerDiagram::~PowerDiagram() = default;
PowerDiagram::PowerDiagram(PowerDiagram&&) noexcept = default;
PowerDiagram& PowerDiagram::operator=(PowerDiagram&&) noexcept = default;

double PowerDiagram::densityAt(const Eigen::Vector2d& point) const {
  return source_ ? source_->pieces()[at(source_->pieceAt(point))].density.at(point) : 1;
}

PowerDiagram PowerDiagram::withSites(Points2 sites) const {
  return source_ ? PowerDiagram(std::move(sites), source_) : PowerDiagram(std::move(sites), domain_);
}

const Points2& PowerDiagram::sites() const noexcept { return walk_->sites; }

const PowerCells& PowerDiagram::compute(const Heights& heights, const Execution& execution) {
  update(heights, false, execution);
  return cells_;
}

bool PowerDiagram::computeUnlessHidden(const Heights& heights, const Execution& execution) {
  return update(heights, true, execution);
}

bool PowerDiagram::update(const Heights& heights, bool unlessHidden, const Execution& execution) {
  const Eigen::Index n = sites().rows();
  if (heights.size() != n || !heights.allFinite()) {
    throw GeometryError("One finite height per site (" + std::to_string(n) + ") is required, but there are " +
                        std::to_string(heights.size()) + (heights.allFinite() ? "." : ", not all of them finite."));
  }
  if (!walk_->update(heights, unlessHidden, execution)) return false;
  cells_.areas.resize(n), cells_.masses.resize(n), cells_.costs.resize(n), cells_.centroids.resize(n, 2);
  std::vector<std::vector<PowerEdge>> found(at(static_cast<int>((n + 1023) / 1024)));
  parallelFor(found.size(), execution, [&](std::size_t begin, std::size_t end) {
    std::optional<DensityIntegrals> density;
    if (source_) density.emplace(*source_);
    for (std::size_t block = begin; block < end; ++block) {
      const int last = std::min(static_cast<int>(n), static_cast<int>(block + 1) * 1024);
      measure(static_cast<int>(block) * 1024, last, density ? &*density : nullptr, found[block]);
    }
  }, 1);
  cells_.edges.clear();
  for (const auto& edges : found) cells_.edges.insert(cells_.edges.end(), edges.begin(), edges.end());
  cells_.emptyCells = static_cast<int>((cells_.masses.array() <= 0).count());
  return true;
}

// Cells begin … end − 1, and their sides with cells of larger numbers.
void PowerDiagram::measure(int begin, int end, DensityIntegrals* density, std::vector<PowerEdge>& edges) {
  const Points2& y = sites();
  std::vector<Chord> chords;
  CellOutline outline;
  for (int i = begin; i < end; ++i) {
    walk_->outlineOf(i, chords, outline);
    CellMoments moments = momentsOf(outline, y.row(i));
    cells_.areas[i] = moments.area;
    if (density && moments.area > 0) moments = density->over(outline, moments.first / moments.area, y.row(i));
    else if (density) chords.clear();
    cells_.masses[i] = moments.area;
    cells_.costs[i] = moments.cost;
    cells_.centroids.row(i) = moments.area > 0 ? Eigen::RowVector2d(moments.first / moments.area) : y.row(i);
    for (const Chord& chord : chords) {
      const double length = (chord.end - chord.start).norm();
      if (!(chord.neighbour > i && length > 0)) continue;
      edges.push_back({i, chord.neighbour, length, density ? density->sides()[chord.side] : length});
    }
  }
}

CellPolygons PowerDiagram::polygons(double arcStep) const {
  std::vector<Chord> chords;
  CellOutline outline;
  std::vector<Eigen::Vector2d> points;
  CellPolygons polygons;
  polygons.starts.push_back(0);
  for (int i = 0; i < static_cast<int>(sites().rows()); ++i) {
    walk_->outlineOf(i, chords, outline);
    for (std::size_t k = 0; k < outline.corners.size(); ++k) {
      const Eigen::Vector2d& a = outline.corners[k];
      const int pieces = std::max(1, static_cast<int>(std::ceil(outline.sweeps[k] / arcStep)));
      for (int piece = 0; piece < pieces; ++piece) {
        const double turn = outline.sweeps[k] * piece / pieces, c = std::cos(turn), s = std::sin(turn);
        points.emplace_back(c * a.x() - s * a.y(), s * a.x() + c * a.y());
      }
    }
    polygons.starts.push_back(static_cast<int>(points.size()));
  }
  polygons.corners.resize(static_cast<Eigen::Index>(points.size()), 2);
  for (std::size_t k = 0; k < points.size(); ++k) {
    polygons.corners.row(static_cast<Eigen::Index>(k)) = points[k].transpose();
  }
  return polygons;
}

bool PowerDiagram::available() noexcept { return regularTriangulationAvailable(); }

}  // namespace authalic
