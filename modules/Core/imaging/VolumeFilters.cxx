#include "Core/imaging/VolumeFilters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "Core/imaging/BucketQueue.h"
#include "Core/imaging/SimplePoint.h"

namespace authalic {

namespace {

constexpr float kFar = 1e20f;

// Lines handled together: neighbours in memory, so that reading across the stride fills whole cache lines.
constexpr std::size_t kTile = 16;

// Replaces every line of the volume along an axis by body(line, length), slices in parallel.
template <class Body>
void transformLines(ScalarVolume& volume, int axis, const Execution& execution, const Body& body) {
  const std::array<std::size_t, 3> size{static_cast<std::size_t>(volume.dimensions[0]),
                                        static_cast<std::size_t>(volume.dimensions[1]),
                                        static_cast<std::size_t>(volume.dimensions[2])};
  const std::array<std::size_t, 3> stride{1, size[0], size[0] * size[1]};
  const std::size_t a = static_cast<std::size_t>(axis), u = axis == 0 ? 1 : 0, w = axis == 2 ? 1 : 2;
  execution.throwIfCancelled();
  const auto slices = [&](std::size_t begin, std::size_t end) {
    std::vector<float> lines(kTile * size[a]);
    for (std::size_t q = begin; q < end; ++q) {
      for (std::size_t p = 0; p < size[u]; p += kTile) {
        const std::size_t count = std::min(kTile, size[u] - p);
        float* first = &volume.values[p * stride[u] + q * stride[w]];
        for (std::size_t x = 0; x < size[a]; ++x) {
          for (std::size_t t = 0; t < count; ++t)
            lines[t * size[a] + x] = first[x * stride[a] + t * stride[u]];
        }
        for (std::size_t t = 0; t < count; ++t) body(&lines[t * size[a]], size[a]);
        for (std::size_t x = 0; x < size[a]; ++x) {
          for (std::size_t t = 0; t < count; ++t)
            first[x * stride[a] + t * stride[u]] = lines[t * size[a] + x];
        }
      }
    }
  };
  parallelFor(size[w], execution, slices, 8);
}

// One line of the squared distance transform: lower envelope of the parabolas f[q] + s² (x − q)².
struct Envelope {
  std::vector<float> f, bound;
  std::vector<int> place;

  void transform(float* values, std::size_t length, float spacing) {
    const int n = static_cast<int>(length);
    f.resize(length);
    place.resize(length);
    bound.resize(length + 1);
    bool any = false;
    for (std::size_t q = 0; q < length; ++q) any = (f[q] = values[q]) < kFar || any;
    if (!any) return;
    const float s2 = spacing * spacing;
    int top = -1;
    for (int q = 0; q < n; ++q) {
      if (f[static_cast<std::size_t>(q)] >= kFar) continue;
      float meet = -kFar;
      while (top >= 0) {
        const int p = place[static_cast<std::size_t>(top)];
        meet = (f[static_cast<std::size_t>(q)] - f[static_cast<std::size_t>(p)]) /
                   (2 * s2 * static_cast<float>(q - p)) +
               0.5f * static_cast<float>(q + p);
        if (meet > bound[static_cast<std::size_t>(top)]) break;
        --top;
        meet = -kFar;
      }
      ++top;
      place[static_cast<std::size_t>(top)] = q;
      bound[static_cast<std::size_t>(top)] = meet;
    }
    bound[static_cast<std::size_t>(top) + 1] = kFar;
    for (int q = 0, at = 0; q < n; ++q) {
      while (bound[static_cast<std::size_t>(at) + 1] < static_cast<float>(q)) ++at;
      const auto d = static_cast<float>(q - place[static_cast<std::size_t>(at)]);
      values[static_cast<std::size_t>(q)] =
          f[static_cast<std::size_t>(place[static_cast<std::size_t>(at)])] + s2 * d * d;
    }
  }
};

std::array<std::ptrdiff_t, 14> neighbourSteps(const std::array<int, 3>& n) {
  std::array<std::ptrdiff_t, 14> step{};
  for (std::size_t k = 0; k < 14; ++k) {
    const auto& o = kLatticeNeighbours[k];
    step[k] = o[0] + static_cast<std::ptrdiff_t>(n[0]) * (o[1] + static_cast<std::ptrdiff_t>(n[1]) * o[2]);
  }
  return step;
}

// Calls body(voxel) for every voxel of the outermost layer.
template <class Body>
void forEachBorderVoxel(const std::array<int, 3>& n, const Body& body) {
  std::size_t v = 0;
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      const bool edge = k == 0 || j == 0 || k + 1 == n[2] || j + 1 == n[1];
      for (int i = 0; i < n[0]; ++i, ++v) {
        if (edge || i == 0 || i + 1 == n[0]) body(v);
      }
    }
  }
}

}  // namespace

Eigen::Vector3d voxelSpacing(const Eigen::Matrix4d& voxelToWorld) {
  return voxelToWorld.topLeftCorner<3, 3>().colwise().norm().transpose();
}

ScalarVolume distanceTo(const MaskVolume& mask, const Execution& execution) {
  ScalarVolume out(mask.dimensions, mask.voxelToWorld);
  for (std::size_t v = 0; v < out.size(); ++v) out.values[v] = mask.values[v] ? 0.0f : kFar;
  const Eigen::Vector3d spacing = voxelSpacing(mask.voxelToWorld);
  for (int axis = 0; axis < 3; ++axis) {
    transformLines(out, axis, execution, [&](float* line, std::size_t length) {
      thread_local Envelope envelope;
      envelope.transform(line, length, static_cast<float>(spacing[axis]));
    });
  }
  for (float& d : out.values) d = d >= kFar ? std::numeric_limits<float>::infinity() : std::sqrt(d);
  return out;
}

ScalarVolume gaussianBlur(ScalarVolume volume, double sigma, const Execution& execution) {
  const Eigen::Vector3d spacing = voxelSpacing(volume.voxelToWorld);
  for (int axis = 0; axis < 3; ++axis) {
    const double s = sigma / spacing[axis];
    const int radius = static_cast<int>(std::ceil(3 * s));
    if (radius == 0) continue;
    std::vector<float> kernel;
    double sum = 0;
    for (int r = -radius; r <= radius; ++r) sum += std::exp(-0.5 * r * r / (s * s));
    for (int r = -radius; r <= radius; ++r)
      kernel.push_back(static_cast<float>(std::exp(-0.5 * r * r / (s * s)) / sum));
    transformLines(volume, axis, execution, [&](float* values, std::size_t length) {
      thread_local std::vector<float> line;
      const int n = static_cast<int>(length);
      line.resize(length + 2 * static_cast<std::size_t>(radius));
      for (int q = -radius; q < n + radius; ++q) {
        line[static_cast<std::size_t>(q + radius)] = values[std::clamp(q, 0, n - 1)];
      }
      for (std::size_t q = 0; q < length; ++q) {
        float value = 0;
        for (std::size_t r = 0; r < kernel.size(); ++r) value += kernel[r] * line[q + r];
        values[q] = value;
      }
    });
  }
  return volume;
}

MaskVolume floodFromMarkers(MaskVolume regions, const VolumeOf<std::int16_t>& priority,
                            const Execution& execution) {
  constexpr std::uint8_t kClosed = 255;
  const auto steps = neighbourSteps(regions.dimensions);
  std::vector<std::uint8_t> border;
  forEachBorderVoxel(regions.dimensions, [&](std::size_t v) {
    border.push_back(regions.values[v]);
    regions.values[v] = kClosed;
  });
  BucketQueue queue(32767);
  for (std::size_t v = 0; v < regions.size(); ++v) {
    if (regions.values[v] != 0 && regions.values[v] != kClosed && priority.values[v] > 0)
      queue.push(v, priority.values[v]);
  }
  std::size_t voxel = 0, count = 0;
  while (queue.pop(voxel)) {
    if ((++count & 0xfffffu) == 0) execution.throwIfCancelled();
    for (const std::ptrdiff_t step : steps) {
      const std::size_t n = voxel + static_cast<std::size_t>(step);
      if (regions.values[n] != 0 || priority.values[n] <= 0) continue;
      regions.values[n] = regions.values[voxel];
      queue.push(n, priority.values[n]);
    }
  }
  std::size_t at = 0;
  forEachBorderVoxel(regions.dimensions, [&](std::size_t v) { regions.values[v] = border[at++]; });
  return regions;
}

std::size_t fillCavities(MaskVolume& mask) {
  const auto steps = neighbourSteps(mask.dimensions);
  std::vector<std::uint8_t> border;
  forEachBorderVoxel(mask.dimensions, [&](std::size_t v) {
    border.push_back(mask.values[v]);
    mask.values[v] = 2;
  });
  std::vector<std::uint32_t> front;
  for (std::size_t v = 0; v < mask.size(); ++v) {
    if (mask.values[v] != 2) continue;
    for (const std::ptrdiff_t step : steps) {
      const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(v) + step;
      if (n < 0 || n >= static_cast<std::ptrdiff_t>(mask.size()) ||
          mask.values[static_cast<std::size_t>(n)] != 0)
        continue;
      mask.values[static_cast<std::size_t>(n)] = 3;
      front.push_back(static_cast<std::uint32_t>(n));
    }
  }
  while (!front.empty()) {
    const std::size_t v = front.back();
    front.pop_back();
    for (const std::ptrdiff_t step : steps) {
      const std::size_t n = v + static_cast<std::size_t>(step);
      if (mask.values[n] != 0) continue;
      mask.values[n] = 3;
      front.push_back(static_cast<std::uint32_t>(n));
    }
  }
  std::size_t filled = 0, at = 0;
  for (std::uint8_t& m : mask.values) {
    filled += m == 0;
    m = m == 3 ? 0 : 1;
  }
  forEachBorderVoxel(mask.dimensions, [&](std::size_t v) { mask.values[v] = border[at++]; });
  return filled;
}

std::size_t keepLargestComponent(MaskVolume& mask) {
  const auto steps = neighbourSteps(mask.dimensions);
  VolumeOf<std::uint32_t> id(mask.dimensions, mask.voxelToWorld, 0);
  forEachBorderVoxel(mask.dimensions, [&](std::size_t v) { mask.values[v] = 0; });
  std::vector<std::size_t> sizes{0};
  std::vector<std::uint32_t> front;
  std::size_t total = 0;
  for (std::size_t seed = 0; seed < mask.size(); ++seed) {
    if (!mask.values[seed] || id.values[seed]) continue;
    const auto label = static_cast<std::uint32_t>(sizes.size());
    sizes.push_back(0);
    id.values[seed] = label;
    front.push_back(static_cast<std::uint32_t>(seed));
    while (!front.empty()) {
      const std::size_t v = front.back();
      front.pop_back();
      ++sizes.back();
      for (const std::ptrdiff_t step : steps) {
        const std::size_t n = v + static_cast<std::size_t>(step);
        if (!mask.values[n] || id.values[n]) continue;
        id.values[n] = label;
        front.push_back(static_cast<std::uint32_t>(n));
      }
    }
    total += sizes.back();
  }
  const auto largest =
      static_cast<std::uint32_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  for (std::size_t v = 0; v < mask.size(); ++v) mask.values[v] = largest != 0 && id.values[v] == largest;
  return total - sizes[largest];
}

}  // namespace authalic
