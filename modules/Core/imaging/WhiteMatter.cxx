#include "Core/imaging/WhiteMatter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

#include "Core/base/Error.h"
#include "Core/imaging/CerebralPrior.h"
#include "Core/imaging/VolumeFilters.h"

namespace authalic {

namespace {

enum Role : std::uint8_t { kNamedLeft = 1, kNamedRight = 2, kRemove = 4, kFill = 8 };

// Calls body(voxel index, i, j, k) for every voxel, slices in parallel.
template <class Body>
void forEachVoxel(const std::array<int, 3>& n, const Execution& execution, const Body& body) {
  execution.throwIfCancelled();
  parallelFor(
      static_cast<std::size_t>(n[2]), execution,
      [&](std::size_t begin, std::size_t end) {
        std::size_t v = begin * static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]);
        for (int k = static_cast<int>(begin); k < static_cast<int>(end); ++k) {
          for (int j = 0; j < n[1]; ++j) {
            for (int i = 0; i < n[0]; ++i, ++v) body(v, i, j, k);
          }
        }
      },
      4);
}

// Every voxel's roles by the nearest voxel of the label volume.
MaskVolume lookUpRoles(const ScalarVolume& t1, const LabelVolume& labels, const LabelConvention& convention,
                       const Execution& execution) {
  std::unordered_map<std::int32_t, std::uint8_t> roleOf;
  for (const auto id : convention.left) roleOf[id] |= kNamedLeft;
  for (const auto id : convention.right) roleOf[id] |= kNamedRight;
  for (const auto id : convention.remove) roleOf[id] |= kRemove;
  for (const auto id : convention.fill) roleOf[id] |= kFill;
  const Eigen::Matrix4d map = labels.worldToVoxel() * t1.voxelToWorld;
  MaskVolume roles(t1.dimensions, t1.voxelToWorld, 0);
  forEachVoxel(t1.dimensions, execution, [&](std::size_t v, int i, int j, int k) {
    const Eigen::Vector4d p = map * Eigen::Vector4d(i, j, k, 1);
    const int x = static_cast<int>(std::lround(p[0])), y = static_cast<int>(std::lround(p[1])),
              z = static_cast<int>(std::lround(p[2]));
    if (!labels.contains(x, y, z) || labels.at(x, y, z) == 0) return;
    const auto found = roleOf.find(labels.at(x, y, z));
    if (found != roleOf.end()) roles.values[v] = found->second;
  });
  if (std::none_of(roles.values.begin(), roles.values.end(),
                   [](std::uint8_t r) { return r & (kNamedLeft | kNamedRight); })) {
    throw GeometryError(
        "Labels that name regions of the T1 are required, but no voxel of the T1 falls on a known left or "
        "right label; "
        "check that both volumes share one space and that the label convention is the right one.");
  }
  return roles;
}

MaskVolume select(const MaskVolume& volume, std::uint8_t bits) {
  MaskVolume out(volume.dimensions, volume.voxelToWorld);
  std::transform(volume.values.begin(), volume.values.end(), out.values.begin(),
                 [bits](std::uint8_t value) { return static_cast<std::uint8_t>((value & bits) != 0); });
  return out;
}

// All voxels within `radius` of the mask, then without those within `radius` of the rest.
MaskVolume closeMask(MaskVolume mask, double radius, double back, const Execution& execution) {
  const ScalarVolume outer = distanceTo(mask, execution);
  for (std::size_t v = 0; v < mask.size(); ++v) mask.values[v] = outer.values[v] > radius;
  const ScalarVolume inner = distanceTo(mask, execution);
  for (std::size_t v = 0; v < mask.size(); ++v) mask.values[v] = inner.values[v] > back;
  return mask;
}

double foregroundLevel(const ScalarVolume& t1) {
  std::vector<float> sample;
  const std::size_t step = std::max<std::size_t>(1, t1.size() / 2000000);
  for (std::size_t v = 0; v < t1.size(); v += step) {
    if (std::isfinite(t1.values[v]) && t1.values[v] > 0) sample.push_back(t1.values[v]);
  }
  if (sample.size() < 1000) {
    throw GeometryError(
        "A T1 image of a brain is required, but fewer than 1000 of its sampled voxels are positive and "
        "finite; "
        "check that it is the right volume.");
  }
  const auto at = sample.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(sample.size() - 1));
  std::nth_element(sample.begin(), at, sample.end());
  return 0.2 * *at;
}

struct Cropped {
  ScalarVolume t1;
  MaskVolume brain, roles;  // roles: empty without labels
};

// The T1 around its foreground with a margin of 4 voxels.
ScalarVolume cropToForeground(const ScalarVolume& t1, double level) {
  std::array<int, 3> lower = t1.dimensions, upper{0, 0, 0};
  for (int k = 0; k < t1.dimensions[2]; ++k) {
    for (int j = 0; j < t1.dimensions[1]; ++j) {
      for (int i = 0; i < t1.dimensions[0]; ++i) {
        if (!(t1.at(i, j, k) > level)) continue;
        const std::array<int, 3> p{i, j, k};
        for (std::size_t a = 0; a < 3; ++a) {
          lower[a] = std::min(lower[a], p[a] - 4);
          upper[a] = std::max(upper[a], p[a] + 5);
        }
      }
    }
  }
  return cropVolume(t1, lower, upper, 0.0f);
}

Cropped prepare(const ScalarVolume& t1, const LabelVolume* labels, const LabelConvention& convention,
                const Execution& execution) {
  const double level = foregroundLevel(t1);
  Cropped out;
  out.t1 = cropToForeground(t1, level);
  out.brain = MaskVolume(out.t1.dimensions, out.t1.voxelToWorld);
  std::size_t count = 0;
  for (std::size_t v = 0; v < out.t1.size(); ++v) count += out.brain.values[v] = out.t1.values[v] > level;
  if (labels) out.roles = lookUpRoles(out.t1, *labels, convention, execution);
  const double litres = static_cast<double>(count) * out.t1.voxelVolume() * 1e-6;
  if (litres < 2.2) return out;
  if (!labels) {
    throw GeometryError(
        "A skull-stripped T1, or labels, are required, but the image shows " +
        std::to_string(litres).substr(0, 4) +
        " litres above background, more than a brain; strip the skull or give a label volume.");
  }
  MaskVolume named(out.roles.dimensions, out.roles.voxelToWorld);
  for (std::size_t v = 0; v < named.size(); ++v) named.values[v] = out.roles.values[v] != 0;
  const MaskVolume hull = closeMask(std::move(named), 12, 10.5, execution);
  for (std::size_t v = 0; v < out.t1.size(); ++v) {
    if (!hull.values[v]) out.brain.values[v] = 0;
  }
  return out;
}

void requireThresholdWithin(const Cropped& in, double threshold) {
  double darkest = std::numeric_limits<double>::infinity(), brightest = -darkest;
  for (std::size_t v = 0; v < in.t1.size(); ++v) {
    if (!in.brain.values[v] || !std::isfinite(in.t1.values[v])) continue;
    darkest = std::min(darkest, static_cast<double>(in.t1.values[v]));
    brightest = std::max(brightest, static_cast<double>(in.t1.values[v]));
  }
  if (threshold > darkest && threshold < brightest) return;
  throw InvalidArgument("A white-matter threshold between the intensities of the brain, " + std::to_string(darkest) +
                        " to " + std::to_string(brightest) + ", is required, but it is " + std::to_string(threshold) +
                        "; 0 takes it from the histogram.");
}

// (T − θ) / (white − grey) inside the brain, −1 outside and where T is not finite.
ScalarVolume contrastOf(const Cropped& in, const IntensityClasses& classes, const WhiteMatterOptions& options,
                        const Execution& execution) {
  ScalarVolume out;
  if (options.threshold == 0 && options.biasScale > 0) {
    out = localThreshold(in.t1, in.brain, classes, options.biasScale, execution);
  } else {
    out = ScalarVolume(in.t1.dimensions, in.t1.voxelToWorld, static_cast<float>(classes.threshold));
  }
  const auto scale = static_cast<float>(1.0 / (classes.white - classes.grey));
  for (std::size_t v = 0; v < out.size(); ++v) {
    const float c = (in.t1.values[v] - out.values[v]) * scale;
    out.values[v] = in.brain.values[v] && std::isfinite(c) ? std::clamp(c, -1.0f, 1.0f) : -1.0f;
  }
  return out;
}

void fill(WhiteMatter& wm, std::size_t voxel) {
  wm.tissue.values[voxel] = wm.filled.values[voxel] = 1;
}

// Roles of a voxel; none without labels.
std::uint8_t roleAt(const MaskVolume& roles, std::size_t voxel) {
  return roles.size() == 0 ? std::uint8_t{0} : roles.values[voxel];
}

bool isCortex(std::uint8_t role) {
  return role != 0 && !(role & (kFill | kRemove));
}

// Labels to fill, grown by 1 mm so that they meet the white matter around them; and the prior where labels
// are silent.
void fillDeepStructures(WhiteMatter& wm, const MaskVolume& roles, bool usePrior, const Execution& execution) {
  ScalarVolume toFill;
  if (roles.size() != 0) toFill = distanceTo(select(roles, kFill), execution);
  forEachVoxel(wm.tissue.dimensions, execution, [&](std::size_t v, int i, int j, int k) {
    const std::uint8_t role = roleAt(roles, v);
    if (wm.tissue.values[v] || role & kRemove) return;
    const bool named = toFill.size() != 0 && toFill.values[v] <= 1.0f;
    if (named || (usePrior && !isCortex(role) && inDeepFill(wm.frame(wm.tissue.world(i, j, k))))) fill(wm, v);
  });
}

// The claustrum: gaps up to 3 mm between the capsules around the lentiform nucleus.
void fillClaustrum(WhiteMatter& wm, const Execution& execution) {
  const MaskVolume closed = closeMask(wm.tissue, 1.5, 1.5, execution);
  forEachVoxel(wm.tissue.dimensions, execution, [&](std::size_t v, int i, int j, int k) {
    if (wm.tissue.values[v] || !closed.values[v]) return;
    if (inLateralFill(wm.frame(wm.tissue.world(i, j, k)))) wm.tissue.values[v] = 1;
  });
}

// The 6-connected parts of `space` of at least `least` voxels whose border lies, to a given share, next to
// white matter.
MaskVolume partsAgainstWhite(MaskVolume space, const ScalarVolume& fromWhite, double share,
                             std::size_t least) {
  const auto& n = space.dimensions;
  const std::array<std::ptrdiff_t, 3> step{1, n[0], static_cast<std::ptrdiff_t>(n[0]) * n[1]};
  std::vector<std::size_t> part;
  for (std::size_t seed = 0; seed < space.size(); ++seed) {
    if (space.values[seed] != 1) continue;
    std::size_t border = 0, white = 0;
    part.assign(1, seed);
    space.values[seed] = 2;
    for (std::size_t at = 0; at < part.size(); ++at) {
      for (const std::ptrdiff_t s : {step[0], -step[0], step[1], -step[1], step[2], -step[2]}) {
        const std::size_t u = part[at] + static_cast<std::size_t>(s);
        if (space.values[u] == 0) {
          ++border;
          white += fromWhite.values[u] <= 1.0f;
        } else if (space.values[u] == 1) {
          space.values[u] = 2;
          part.push_back(u);
        }
      }
    }
    if (part.size() >= least && static_cast<double>(white) >= share * static_cast<double>(border)) continue;
    for (const std::size_t v : part) space.values[v] = 3;
  }
  for (std::uint8_t& s : space.values) s = s == 2;
  return space;
}

// Fluid spaces that the outside reaches only through gaps narrower than 2 mm, and that lie mostly against
// white matter; with the rim of mixed voxels around them.
void fillVentricles(WhiteMatter& wm, const Cropped& in, const Execution& execution) {
  MaskVolume solid = wm.tissue;
  for (std::size_t v = 0; v < solid.size(); ++v) {
    if (in.brain.values[v] && in.t1.values[v] > wm.classes.fluid) solid.values[v] = 1;
  }
  const ScalarVolume room = distanceTo(solid, execution);
  MaskVolume closed = solid;
  for (std::size_t v = 0; v < closed.size(); ++v) closed.values[v] = room.values[v] <= 1.0f;
  MaskVolume core = closed;
  fillCavities(core);
  for (std::size_t v = 0; v < core.size(); ++v) core.values[v] = core.values[v] && !closed.values[v];
  const ScalarVolume fromCore = distanceTo(core, execution);
  for (std::size_t v = 0; v < solid.size(); ++v)
    solid.values[v] = !solid.values[v] && fromCore.values[v] <= 1.6f;
  const auto least = static_cast<std::size_t>(40.0 / in.t1.voxelVolume());
  const MaskVolume ventricles =
      partsAgainstWhite(std::move(solid), distanceTo(wm.tissue, execution), 0.35, least);
  const ScalarVolume fromVentricles = distanceTo(ventricles, execution);
  const double rim = 1.0 + 0.75 * voxelSpacing(in.t1.voxelToWorld).mean();
  for (std::size_t v = 0; v < wm.tissue.size(); ++v) {
    if (!wm.tissue.values[v] && fromVentricles.values[v] <= rim) fill(wm, v);
  }
}

// Depth inside the mask as a priority: 1 + 100 per mm.
VolumeOf<std::int16_t> depthPriority(const MaskVolume& mask, const Execution& execution) {
  MaskVolume rest(mask.dimensions, mask.voxelToWorld);
  for (std::size_t v = 0; v < mask.size(); ++v) rest.values[v] = !mask.values[v];
  const ScalarVolume depth = distanceTo(rest, execution);
  VolumeOf<std::int16_t> priority(mask.dimensions, mask.voxelToWorld, 0);
  for (std::size_t v = 0; v < mask.size(); ++v) {
    if (mask.values[v])
      priority.values[v] = static_cast<std::int16_t>(1 + std::min(320.0f, depth.values[v]) * 100);
  }
  return priority;
}

// Marks brainstem and cerebellum: kHindbrain in tissue; the rest stays 1.
void separateHindbrain(WhiteMatter& wm, const MaskVolume& roles, bool usePrior, const Execution& execution) {
  ScalarVolume toRemove, toCerebrum;
  if (roles.size() != 0) {
    toRemove = distanceTo(select(roles, kRemove), execution);
    toCerebrum = distanceTo(select(roles, kNamedLeft | kNamedRight), execution);
  }
  MaskVolume markers(wm.tissue.dimensions, wm.tissue.voxelToWorld);
  forEachVoxel(markers.dimensions, execution, [&](std::size_t v, int i, int j, int k) {
    if (!wm.tissue.values[v]) return;
    const Eigen::Vector3d p = wm.frame(markers.world(i, j, k));
    bool hind = usePrior && !isCortex(roleAt(roles, v)) && inHindbrainCore(p), cerebrum = false;
    if (roles.size() != 0) {
      hind = hind || (toRemove.values[v] <= 2.0f && toRemove.values[v] < toCerebrum.values[v]);
      cerebrum = toCerebrum.values[v] <= 2.0f;
    }
    cerebrum = cerebrum || (usePrior && inCerebrumCore(p));
    markers.values[v] = hind ? 2 : cerebrum ? 1 : 0;
  });
  markers = floodFromMarkers(std::move(markers), depthPriority(wm.tissue, execution), execution);
  for (std::size_t v = 0; v < markers.size(); ++v) {
    if (wm.tissue.values[v])
      wm.tissue.values[v] = markers.values[v] == 2 ? std::uint8_t{kHindbrain} : markers.values[v];
  }
}

// Cerebrum (1) becomes kLeft or kRight.
void splitHemispheres(WhiteMatter& wm, double band, const Execution& execution) {
  const double scale = wm.frame.lateralScale();
  MaskVolume markers(wm.tissue.dimensions, wm.tissue.voxelToWorld);
  VolumeOf<std::int16_t> priority(wm.tissue.dimensions, wm.tissue.voxelToWorld, 0);
  forEachVoxel(markers.dimensions, execution, [&](std::size_t v, int i, int j, int k) {
    if (wm.tissue.values[v] != 1) return;
    const double d = scale * wm.frame(markers.world(i, j, k))[0];
    priority.values[v] = static_cast<std::int16_t>(1 + 1000 * std::min(1.0, std::abs(d) / band));
    if (std::abs(d) >= band) markers.values[v] = d < 0 ? kLeft : kRight;
  });
  markers = floodFromMarkers(std::move(markers), priority, execution);
  for (std::size_t v = 0; v < markers.size(); ++v) {
    if (wm.tissue.values[v] == 1) wm.tissue.values[v] = markers.values[v];
  }
}

// Only the largest component of each hemisphere, without cavities.
void cleanHemispheres(WhiteMatter& wm) {
  for (const std::uint8_t side : {kLeft, kRight}) {
    MaskVolume mask(wm.tissue.dimensions, wm.tissue.voxelToWorld);
    for (std::size_t v = 0; v < mask.size(); ++v) mask.values[v] = wm.tissue.values[v] == side;
    keepLargestComponent(mask);
    if (std::none_of(mask.values.begin(), mask.values.end(), [](std::uint8_t m) { return m; })) {
      throw GeometryError(std::string("White matter in both hemispheres is required, but the ") +
                          (side == kLeft ? "left" : "right") +
                          " one is empty; check the threshold, the labels and the orientation of the image.");
    }
    fillCavities(mask);
    for (std::size_t v = 0; v < mask.size(); ++v) {
      if (mask.values[v] && wm.tissue.values[v] != side) {
        wm.filled.values[v] = 1;
        wm.tissue.values[v] = side;
      } else if (!mask.values[v] && wm.tissue.values[v] == side) {
        wm.tissue.values[v] = kOutside;
      }
    }
  }
}

void requireVolume(const ScalarVolume& t1) {
  for (const int n : t1.dimensions) {
    if (n >= 16) continue;
    throw InvalidArgument("A volume of at least 16 voxels along every axis is required, but one axis has " +
                          std::to_string(n) + "; give a whole-brain T1.");
  }
  if (t1.size() > std::numeric_limits<std::uint32_t>::max() / 2) {
    throw InvalidArgument("At most 2^31 voxels are supported, but the volume has " +
                          std::to_string(t1.size()) + "; crop it.");
  }
  const Eigen::Vector3d spacing = voxelSpacing(t1.voxelToWorld);
  if (!(spacing.minCoeff() > 0.05) || !(spacing.maxCoeff() <= 3.0) ||
      std::abs(t1.voxelToWorld.topLeftCorner<3, 3>().determinant()) < 1e-4) {
    throw GeometryError("Voxels of 0.05 to 3 mm are required, but one axis has steps of " +
                        std::to_string(spacing.minCoeff()) + " to " + std::to_string(spacing.maxCoeff()) +
                        " mm; correct the header or resample the image.");
  }
}

}  // namespace

void WhiteMatterOptions::validate() const {
  const auto require = [](bool ok, const char* what, double found) {
    if (!ok) throw InvalidArgument(std::string(what) + ", but it is " + std::to_string(found) + ".");
  };
  require(std::isfinite(threshold), "The white-matter threshold must be finite", threshold);
  require(biasScale >= 0 && biasScale <= 200, "The bias scale must lie in [0, 200] mm", biasScale);
  require(midlineBand >= 1 && midlineBand <= 20, "The midline band must lie in [1, 20] mm", midlineBand);
}

WhiteMatter segmentWhiteMatter(const ScalarVolume& t1, const LabelVolume* labels,
                               const WhiteMatterOptions& options, const Execution& execution) {
  options.validate();
  requireVolume(t1);
  execution.report(0, "brain mask");
  const Cropped in = prepare(t1, labels, options.labels, execution);
  WhiteMatter wm;
  wm.brainVolume = in.t1.voxelVolume() *
                   static_cast<double>(std::count(in.brain.values.begin(), in.brain.values.end(), 1));
  if (options.threshold != 0) requireThresholdWithin(in, options.threshold);
  wm.frame = findBrainFrame(in.t1, in.brain, execution);
  execution.report(0.2, "intensity classes");
  wm.classes = estimateIntensityClasses(in.t1, in.brain);
  if (options.threshold != 0) wm.classes.threshold = options.threshold;
  wm.contrast = contrastOf(in, wm.classes, options, execution);
  wm.tissue = MaskVolume(in.t1.dimensions, in.t1.voxelToWorld);
  wm.filled = wm.tissue;
  for (std::size_t v = 0; v < wm.tissue.size(); ++v) wm.tissue.values[v] = wm.contrast.values[v] > 0;
  execution.report(0.35, "deep structures");
  const bool usePrior = in.roles.size() == 0 || !options.labels.namesBrainstemAndVentricles;
  fillDeepStructures(wm, in.roles, usePrior, execution);
  if (usePrior) fillClaustrum(wm, execution);
  execution.report(0.5, "ventricles");
  fillVentricles(wm, in, execution);
  execution.report(0.65, "hindbrain");
  separateHindbrain(wm, in.roles, usePrior, execution);
  execution.report(0.8, "hemispheres");
  splitHemispheres(wm, options.midlineBand, execution);
  cleanHemispheres(wm);
  execution.report(1, "white matter");
  return wm;
}

}  // namespace authalic
