#include "Core/imaging/HomotopicGrowing.h"

#include <algorithm>
#include <string>
#include <vector>

#include "Core/base/Error.h"
#include "Core/imaging/BucketQueue.h"
#include "Core/imaging/SimplePoint.h"

namespace authalic {

namespace {

enum State : std::uint8_t { Free = 0, Queued = 1, Inside = 2 };

class Growing {
 public:
  Growing(const VolumeOf<std::int16_t>& priority, const Execution& execution)
      : priority_(priority), execution_(execution), state_(priority.dimensions, priority.voxelToWorld, Free) {
    for (std::size_t k = 0; k < 14; ++k) {
      const auto& o = kLatticeNeighbours[k];
      offset_[k] = o[0] + static_cast<std::ptrdiff_t>(priority.dimensions[0]) *
                              (o[1] + static_cast<std::ptrdiff_t>(priority.dimensions[1]) * o[2]);
    }
    const auto [low, high] = std::minmax_element(priority.values.begin(), priority.values.end());
    lowest_ = std::min<int>(*low, 0);
    highest_ = *high;
    closeOutermostLayer();
  }

  // Positive voxels first, then the negative ones nearest to 0: one queue in the order of level().
  void grow(std::size_t seed) {
    BucketQueue queue(highest_ - lowest_);
    join(seed, queue);
    std::size_t voxel = 0, steps = 0;
    while (queue.pop(voxel)) {
      if ((++steps & 0xfffffu) == 0) pause();
      state_.values[voxel] = Free;
      if (isSimplePoint(insideNeighbours(voxel))) join(voxel, queue);
    }
  }

  // Gives back the voxels of negative priority that are simple, the least wanted first.
  void giveBack() {
    BucketQueue queue(-lowest_);
    for (std::size_t v = 0; v < state_.size(); ++v) {
      if (state_.values[v] == Inside && priority_.values[v] < 0) queue.push(v, -priority_.values[v]);
    }
    std::size_t voxel = 0, steps = 0;
    while (queue.pop(voxel)) {
      if ((++steps & 0xfffffu) == 0) pause();
      if (state_.values[voxel] != Inside || !isSimplePoint(insideNeighbours(voxel))) continue;
      state_.values[voxel] = Free;
      for (const std::ptrdiff_t offset : offset_) {
        const std::size_t n = voxel + static_cast<std::size_t>(offset);
        if (state_.values[n] == Inside && priority_.values[n] < 0) queue.push(n, -priority_.values[n]);
      }
    }
  }

  [[nodiscard]] HomotopicGrowth result() {
    HomotopicGrowth growth;
    for (std::size_t v = 0; v < state_.size(); ++v) {
      const bool inside = state_.values[v] == Inside;
      growth.kept += inside && priority_.values[v] > 0;
      growth.added += inside && priority_.values[v] < 0;
      growth.rejected += !inside && priority_.values[v] > 0;
      state_.values[v] = inside;
    }
    growth.mask = std::move(state_);
    return growth;
  }

 private:
  // Voxels without all 14 neighbours can never join: marked as queued, they are never looked at.
  void closeOutermostLayer() {
    const auto& n = state_.dimensions;
    for (int k = 0; k < n[2]; ++k) {
      for (int j = 0; j < n[1]; ++j) {
        const bool edge = k == 0 || j == 0 || k + 1 == n[2] || j + 1 == n[1];
        for (int i = 0; i < n[0]; i += edge ? 1 : std::max(1, n[0] - 1)) state_.at(i, j, k) = Queued;
      }
    }
  }

  [[nodiscard]] std::uint16_t insideNeighbours(std::size_t voxel) const {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 14; ++k) {
      bits |= static_cast<unsigned>(state_.values[voxel + static_cast<std::size_t>(offset_[k])] == Inside)
              << k;
    }
    return static_cast<std::uint16_t>(bits);
  }

  void join(std::size_t voxel, BucketQueue& queue) {
    state_.values[voxel] = Inside;
    for (const std::ptrdiff_t offset : offset_) {
      const std::size_t n = voxel + static_cast<std::size_t>(offset);
      if (state_.values[n] != Free || priority_.values[n] == 0) continue;
      state_.values[n] = Queued;
      queue.push(n, priority_.values[n] - lowest_);
    }
  }

  void pause() const { execution_.throwIfCancelled(); }

  const VolumeOf<std::int16_t>& priority_;
  const Execution& execution_;
  MaskVolume state_;
  std::array<std::ptrdiff_t, 14> offset_{};
  int lowest_ = 0, highest_ = 0;
};

void requireSeed(const VolumeOf<std::int16_t>& priority, const std::array<int, 3>& seed) {
  bool valid = true;
  for (std::size_t a = 0; a < 3; ++a) valid = valid && seed[a] > 0 && seed[a] + 1 < priority.dimensions[a];
  if (valid && priority.at(seed[0], seed[1], seed[2]) > 0) return;
  throw InvalidArgument(
      "A seed of positive priority inside the outermost layer is required to grow an object, but voxel (" +
      std::to_string(seed[0]) + ", " + std::to_string(seed[1]) + ", " + std::to_string(seed[2]) +
      ") is none; give another seed.");
}

}  // namespace

HomotopicGrowth growHomotopic(const VolumeOf<std::int16_t>& priority, const std::array<int, 3>& seed,
                              const Execution& execution) {
  requireSeed(priority, seed);
  Growing growing(priority, execution);
  growing.grow(priority.index(seed[0], seed[1], seed[2]));
  growing.giveBack();
  return growing.result();
}

}  // namespace authalic
