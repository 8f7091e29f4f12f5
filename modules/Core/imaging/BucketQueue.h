/// @file
/// A priority queue of voxels for small integer priorities. Private to imaging/.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace authalic {

/// Voxels by priority, served from the highest; first in, first out within a priority, so that a flood that
/// uses it is deterministic. Priorities in [0, levels]; at most 2^32 voxels. push and pop are O(1) amortised.
class BucketQueue {
 public:
  explicit BucketQueue(int levels)
      : buckets_(static_cast<std::size_t>(levels) + 1), heads_(buckets_.size(), 0) {}

  void push(std::size_t voxel, int priority) {
    buckets_[static_cast<std::size_t>(priority)].push_back(static_cast<std::uint32_t>(voxel));
    top_ = std::max(top_, priority);
  }

  /// False when the queue is empty.
  [[nodiscard]] bool pop(std::size_t& voxel) {
    for (; top_ >= 0; --top_) {
      auto& bucket = buckets_[static_cast<std::size_t>(top_)];
      auto& head = heads_[static_cast<std::size_t>(top_)];
      if (head < bucket.size()) {
        voxel = bucket[head++];
        return true;
      }
      std::vector<std::uint32_t>().swap(bucket);
      head = 0;
    }
    top_ = 0;
    return false;
  }

 private:
  std::vector<std::vector<std::uint32_t>> buckets_;
  std::vector<std::size_t> heads_;
  int top_ = 0;
};

}  // namespace authalic
