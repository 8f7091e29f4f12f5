#include "Core/imaging/CorticalSurface.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include <Eigen/Geometry>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Decimation.h"
#include "Core/imaging/HomotopicGrowing.h"
#include "Core/imaging/Isosurface.h"
#include "Core/imaging/MedialWall.h"
#include "Core/imaging/VolumeFilters.h"
#include "Core/mesh/SurfaceTopology.h"
#include "Core/topology/PruneSpikes.h"

namespace authalic {

namespace {

// Seconds per named stage.
class StopWatch {
 public:
  explicit StopWatch(std::vector<std::pair<std::string, double>>& table) : table_(table) {}
  void lap(const std::string& stage) {
    const auto now = std::chrono::steady_clock::now();
    table_.emplace_back(stage, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

 private:
  std::vector<std::pair<std::string, double>>& table_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// The hemisphere alone, on its bounding box with a margin of 4 voxels.
struct Hemisphere {
  MaskVolume white, filled, foreign;  // foreign: hindbrain or the other hemisphere
  MaskVolume wall;                    // foreign, or filled near the midline
  ScalarVolume contrast;
};

// Fillings further than this from the midline (the putamen beneath the insula, the temporal horn) lie under
// cortex. Frame units.
constexpr double kWallHalfWidth = 24;

void markWall(Hemisphere& h, const BrainFrame& frame) {
  h.wall = h.foreign;
  std::size_t v = 0;
  for (int k = 0; k < h.wall.dimensions[2]; ++k) {
    for (int j = 0; j < h.wall.dimensions[1]; ++j) {
      for (int i = 0; i < h.wall.dimensions[0]; ++i, ++v) {
        if (h.filled.values[v] && std::abs(frame(h.wall.world(i, j, k))[0]) < kWallHalfWidth)
          h.wall.values[v] = 1;
      }
    }
  }
}

Hemisphere cutOut(const WhiteMatter& wm, std::uint8_t side) {
  std::array<int, 3> lower = wm.tissue.dimensions, upper{0, 0, 0};
  for (int k = 0; k < wm.tissue.dimensions[2]; ++k) {
    for (int j = 0; j < wm.tissue.dimensions[1]; ++j) {
      for (int i = 0; i < wm.tissue.dimensions[0]; ++i) {
        if (wm.tissue.at(i, j, k) != side) continue;
        const std::array<int, 3> p{i, j, k};
        for (std::size_t a = 0; a < 3; ++a) {
          lower[a] = std::min(lower[a], p[a] - 4);
          upper[a] = std::max(upper[a], p[a] + 5);
        }
      }
    }
  }
  Hemisphere h;
  h.white = cropVolume<std::uint8_t>(wm.tissue, lower, upper, kOutside);
  h.filled = cropVolume<std::uint8_t>(wm.filled, lower, upper, 0);
  h.contrast = cropVolume(wm.contrast, lower, upper, -1.0f);
  h.foreign = MaskVolume(h.white.dimensions, h.white.voxelToWorld, 0);
  for (std::size_t v = 0; v < h.white.size(); ++v) {
    h.foreign.values[v] = h.white.values[v] != kOutside && h.white.values[v] != side;
    h.white.values[v] = h.white.values[v] == side;
    h.filled.values[v] = h.filled.values[v] && h.white.values[v];
  }
  markWall(h, wm.frame);
  return h;
}

// Depth decides, contrast breaks ties; voxels near the mask and not clearly grey may seal tunnels.
VolumeOf<std::int16_t> growthPriority(const Hemisphere& h, double sealing, const Execution& execution) {
  MaskVolume rest(h.white.dimensions, h.white.voxelToWorld);
  for (std::size_t v = 0; v < rest.size(); ++v) rest.values[v] = !h.white.values[v];
  const ScalarVolume depth = distanceTo(rest, execution);
  const ScalarVolume height = distanceTo(h.white, execution);
  const double reach = sealing * voxelSpacing(h.white.voxelToWorld).maxCoeff() * 1.001;
  VolumeOf<std::int16_t> priority(h.white.dimensions, h.white.voxelToWorld, 0);
  for (std::size_t v = 0; v < priority.size(); ++v) {
    const float contrast = h.filled.values[v] ? 1.0f : h.contrast.values[v];
    if (h.white.values[v]) {
      priority.values[v] = static_cast<std::int16_t>(1 + 1000 * std::min(30.0f, depth.values[v]) +
                                                     499 * std::max(0.0f, contrast));
    } else if (!h.foreign.values[v] && height.values[v] <= reach && contrast > -0.6f) {
      priority.values[v] = static_cast<std::int16_t>(-1 - 1000 * std::min(1.0f, -contrast));
    }
  }
  return priority;
}

std::array<int, 3> deepest(const VolumeOf<std::int16_t>& priority) {
  const auto at = static_cast<std::size_t>(std::max_element(priority.values.begin(), priority.values.end()) -
                                           priority.values.begin());
  const auto nx = static_cast<std::size_t>(priority.dimensions[0]),
             ny = static_cast<std::size_t>(priority.dimensions[1]);
  return {static_cast<int>(at % nx), static_cast<int>(at / nx % ny), static_cast<int>(at / (nx * ny))};
}

// 1 where a voxel is foreign or touches, by a face, one that is.
MaskVolume besideForeign(const MaskVolume& foreign) {
  MaskVolume out = foreign;
  const auto& n = foreign.dimensions;
  const std::array<std::ptrdiff_t, 3> step{1, n[0], static_cast<std::ptrdiff_t>(n[0]) * n[1]};
  for (std::ptrdiff_t v = step[2]; v < static_cast<std::ptrdiff_t>(foreign.size()) - step[2]; ++v) {
    if (!foreign.values[static_cast<std::size_t>(v)]) continue;
    for (const std::ptrdiff_t s : step)
      out.values[static_cast<std::size_t>(v + s)] = out.values[static_cast<std::size_t>(v - s)] = 1;
  }
  return out;
}

// The contrast where its sign is that of the grown set and no cut is near, else the blurred set; never nearer
// to 0 than 0.02.
ScalarVolume surfaceField(const Hemisphere& h, const MaskVolume& grown, const Execution& execution) {
  ScalarVolume field(grown.dimensions, grown.voxelToWorld);
  for (std::size_t v = 0; v < field.size(); ++v) field.values[v] = grown.values[v] ? 0.5f : -0.5f;
  field = gaussianBlur(std::move(field), voxelSpacing(grown.voxelToWorld).mean(), execution);
  const MaskVolume cut = besideForeign(h.foreign);
  for (std::size_t v = 0; v < field.size(); ++v) {
    const bool inside = grown.values[v] != 0;
    const float natural = h.contrast.values[v];
    const float value = (natural > 0) == inside && !cut.values[v] ? natural : field.values[v];
    field.values[v] = inside ? std::clamp(value, 0.02f, 0.5f) : std::clamp(value, -0.5f, -0.02f);
  }
  return field;
}

// Smoothing after decimation, which evens out the triangles.
constexpr int kRounds = 3;

// Share of the area (1 cm² of 1000) up to which what hangs on three edges is no anatomy.
constexpr double kLargestSpike = 1e-3;

HemisphereSurface makeSurface(const WhiteMatter& wm, std::uint8_t side, const CorticalSurfaceOptions& options,
                              StopWatch& watch, const Execution& execution) {
  const std::string name = side == kLeft ? "left " : "right ";
  const Hemisphere h = cutOut(wm, side);
  HemisphereSurface out;
  out.filledVoxels = static_cast<std::size_t>(std::count(h.filled.values.begin(), h.filled.values.end(), 1));
  execution.report(0, name + "topology");
  const VolumeOf<std::int16_t> priority = growthPriority(h, options.sealing, execution);
  const HomotopicGrowth growth = growHomotopic(priority, deepest(priority), execution);
  out.voxels = growth.kept + growth.rejected;
  out.cutVoxels = growth.rejected;
  out.sealedVoxels = growth.added;
  watch.lap(name + "topology");
  execution.report(0.3, name + "surface");
  TriangleMesh mesh = extractIsosurface(surfaceField(h, growth.mask, execution), execution.part(0.3, 0.45));
  out.extractedFaces = mesh.faceCount();
  watch.lap(name + "isosurface");
  SmoothedSurface smoothed = smoothSurface(mesh, options.smoothing, execution.part(0.45, 0.6));
  out.turnedFaces = smoothed.turnedFaces;
  watch.lap(name + "smoothing");
  const bool decimated = options.targetFaces > 0 && smoothed.mesh.faceCount() > options.targetFaces;
  if (decimated) smoothed.mesh = decimate(smoothed.mesh, options.targetFaces, execution.part(0.6, 0.95));
  PrunedSurface pruned = pruneSpikes(smoothed.mesh, kLargestSpike, execution);
  out.prunedSpikes = pruned.spikes;
  out.prunedFaces = pruned.removedFaces;
  out.mesh = std::move(pruned.mesh);
  if (decimated) out.mesh = smoothSurface(out.mesh, {kRounds, options.smoothing.passBand, true}, execution).mesh;
  watch.lap(name + "decimation");
  out.medialWall = findMedialWall(
      out.mesh, h.wall,
      std::max(options.medialWallReach, 1.05 * voxelSpacing(h.wall.voxelToWorld).maxCoeff()), execution);
  watch.lap(name + "medial wall");
  out.eulerCharacteristic = SurfaceTopology(out.mesh.faces(), out.mesh.vertexCount()).eulerCharacteristic();
  out.area = faceAreas(out.mesh).sum();
  out.volume = enclosedVolume(out.mesh);
  out.medialWallShare = regionArea(out.mesh, out.medialWall) / out.area;
  execution.report(1, name + "surface");
  return out;
}

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

void warnAbout(const HemisphereSurface& h, const std::string& side, std::vector<std::string>& warnings) {
  if (h.area < 40000 || h.area > 140000) {
    warnings.push_back("The " + side + " white surface has " + number("%.0f", h.area / 100) +
                       " cm², outside the usual 400 to 1400.");
  }
  if (h.medialWallShare > 0.25) {
    warnings.push_back("The " + side + " medial wall takes " + number("%.0f", 100 * h.medialWallShare) +
                       " % of the surface, more than the usual 25.");
  }
  if (static_cast<double>(h.cutVoxels) > 0.05 * static_cast<double>(h.voxels)) {
    warnings.push_back(
        "Making the " + side + " hemisphere a sphere cut " +
        number("%.1f", 100.0 * static_cast<double>(h.cutVoxels) / static_cast<double>(h.voxels)) +
        " % of its voxels; the image may be noisy or the threshold wrong.");
  }
}

}  // namespace

void CorticalSurfaceOptions::validate() const {
  whiteMatter.validate();
  smoothing.validate();
  if (!(sealing >= 0 && sealing <= 5)) {
    throw InvalidArgument("Sealing must lie in [0, 5] voxels, but it is " + std::to_string(sealing) + ".");
  }
  if (targetFaces != 0 && targetFaces < 1000) {
    throw InvalidArgument("The target must be 0 (no decimation) or at least 1000 faces, but it is " +
                          std::to_string(targetFaces) + ".");
  }
  if (!(medialWallReach > 0 && medialWallReach <= 10)) {
    throw InvalidArgument("The reach of the medial wall must lie in (0, 10] mm, but it is " +
                          std::to_string(medialWallReach) + ".");
  }
}

CorticalSurfaceResult extractCorticalSurfaces(const ScalarVolume& t1, const LabelVolume* labels,
                                              const CorticalSurfaceOptions& options,
                                              const Execution& execution) {
  options.validate();
  CorticalSurfaceResult out;
  StopWatch watch(out.seconds);
  const WhiteMatter wm = segmentWhiteMatter(t1, labels, options.whiteMatter, execution.part(0, 0.3));
  watch.lap("white matter");
  out.classes = wm.classes;
  out.frame = wm.frame;
  out.brainVolume = wm.brainVolume;
  out.left = makeSurface(wm, kLeft, options, watch, execution.part(0.3, 0.65));
  out.right = makeSurface(wm, kRight, options, watch, execution.part(0.65, 1));
  warnAbout(out.left, "left", out.warnings);
  warnAbout(out.right, "right", out.warnings);
  return out;
}

}  // namespace authalic
