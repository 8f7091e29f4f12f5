#include "Core/imaging/IntensityClasses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "Core/base/Error.h"
#include "Core/imaging/VolumeFilters.h"

namespace authalic {

namespace {

constexpr int kBins = 256;

struct Histogram {
  double low = 0, width = 1;
  std::vector<double> counts = std::vector<double>(kBins, 0.0);
  [[nodiscard]] double centre(double bin) const { return low + (bin + 0.5) * width; }
};

// Between the 0.1 and 99.9 percentiles, so that a few hot voxels do not squeeze the rest.
Histogram makeHistogram(std::vector<float> sample) {
  std::sort(sample.begin(), sample.end());
  const auto quantile = [&sample](double q) {
    return static_cast<double>(sample[static_cast<std::size_t>(q * static_cast<double>(sample.size() - 1))]);
  };
  Histogram h;
  h.low = quantile(0.001);
  const double high = quantile(0.999);
  if (!(high > h.low)) {
    throw GeometryError("Grey and white matter of different intensity are required, but nearly all of the " +
                        std::to_string(sample.size()) + " brain voxels have the value " +
                        std::to_string(high) + "; give a T1-weighted image.");
  }
  const double margin = 0.05 * (high - h.low);  // so that a peak at either end is still a local maximum
  h.width = (high - h.low + 2 * margin) / kBins;
  h.low -= margin;
  for (const float value : sample) {
    const int bin = static_cast<int>(std::floor((value - h.low) / h.width));
    if (bin >= 0 && bin < kBins) h.counts[static_cast<std::size_t>(bin)] += 1;
  }
  return h;
}

void smooth(std::vector<double>& counts, double sigma) {
  const std::vector<double> from = counts;
  const int radius = static_cast<int>(3 * sigma);
  for (int b = 0; b < kBins; ++b) {
    double sum = 0, weight = 0;
    for (int r = -radius; r <= radius; ++r) {
      if (b + r < 0 || b + r >= kBins) continue;
      const double w = std::exp(-0.5 * r * r / (sigma * sigma));
      sum += w * from[static_cast<std::size_t>(b + r)];
      weight += w;
    }
    counts[static_cast<std::size_t>(b)] = sum / weight;
  }
}

// Local maxima of at least a tenth of the highest, far enough apart, highest first.
std::vector<int> majorPeaks(const std::vector<double>& counts) {
  std::vector<int> peaks;
  const double least = 0.1 * *std::max_element(counts.begin(), counts.end());
  for (int b = 1; b + 1 < kBins; ++b) {
    const auto i = static_cast<std::size_t>(b);
    if (counts[i] >= least && counts[i] > counts[i - 1] && counts[i] >= counts[i + 1]) peaks.push_back(b);
  }
  std::sort(peaks.begin(), peaks.end(), [&](int a, int b) {
    return counts[static_cast<std::size_t>(a)] > counts[static_cast<std::size_t>(b)];
  });
  std::vector<int> apart;
  for (const int p : peaks) {
    if (std::all_of(apart.begin(), apart.end(), [p](int q) { return std::abs(p - q) >= kBins / 10; }))
      apart.push_back(p);
  }
  return apart;
}

// Centres of three classes of the histogram, in ascending order.
std::array<double, 3> threeMeans(const Histogram& h) {
  std::array<double, 3> mean{0.25 * kBins, 0.55 * kBins, 0.8 * kBins};
  for (int round = 0; round < 200; ++round) {
    std::array<double, 3> sum{}, weight{};
    for (int b = 0; b < kBins; ++b) {
      const std::size_t c = b < 0.5 * (mean[0] + mean[1]) ? 0 : b < 0.5 * (mean[1] + mean[2]) ? 1 : 2;
      sum[c] += b * h.counts[static_cast<std::size_t>(b)];
      weight[c] += h.counts[static_cast<std::size_t>(b)];
    }
    for (std::size_t c = 0; c < 3; ++c) {
      if (weight[c] > 0) mean[c] = sum[c] / weight[c];
    }
  }
  return mean;
}

}  // namespace

IntensityClasses estimateIntensityClasses(const ScalarVolume& t1, const MaskVolume& mask) {
  std::vector<float> sample;
  for (std::size_t v = 0; v < t1.size(); ++v) {
    if (mask.values[v] && std::isfinite(t1.values[v])) sample.push_back(t1.values[v]);
  }
  if (sample.size() < 1000) {
    throw GeometryError(
        "At least 1000 brain voxels are required to tell grey from white matter, but there are " +
        std::to_string(sample.size()) + "; check the image and its labels.");
  }
  Histogram h = makeHistogram(std::move(sample));
  smooth(h.counts, 2.5);
  const std::vector<int> peaks = majorPeaks(h.counts);
  IntensityClasses classes;
  if (peaks.size() >= 2) {
    classes.grey = h.centre(std::min(peaks[0], peaks[1]));
    classes.white = h.centre(std::max(peaks[0], peaks[1]));
  } else {
    const std::array<double, 3> mean = threeMeans(h);
    classes.grey = h.centre(mean[1]);
    classes.white = h.centre(mean[2]);
  }
  classes.threshold = 0.5 * (classes.grey + classes.white);
  classes.fluid = classes.grey - 0.9 * (classes.white - classes.grey);
  return classes;
}

namespace {

// Sums over blocks of b³ voxels: weight and weighted intensity of the voxels of one class.
struct BlockMeans {
  ScalarVolume weight, sum;
};

BlockMeans blockSums(const ScalarVolume& t1, const MaskVolume& mask, double low, double high,
                     const std::array<int, 3>& block) {
  std::array<int, 3> n{};
  Eigen::Matrix4d affine = t1.voxelToWorld;
  for (std::size_t a = 0; a < 3; ++a) {
    n[a] = (t1.dimensions[a] + block[a] - 1) / block[a];
    affine.col(static_cast<Eigen::Index>(a)) *= block[a];
  }
  BlockMeans out{ScalarVolume(n, affine, 0.0f), ScalarVolume(n, affine, 0.0f)};
  std::size_t v = 0;
  for (int k = 0; k < t1.dimensions[2]; ++k) {
    for (int j = 0; j < t1.dimensions[1]; ++j) {
      for (int i = 0; i < t1.dimensions[0]; ++i, ++v) {
        const float value = t1.values[v];
        if (!mask.values[v] || !(value >= low && value < high)) continue;
        const std::size_t at = out.sum.index(i / block[0], j / block[1], k / block[2]);
        out.weight.values[at] += 1;
        out.sum.values[at] += value;
      }
    }
  }
  return out;
}

// Value of a block volume between block centres; constant beyond the outermost centres.
double interpolate(const ScalarVolume& blocks, const Eigen::Vector3d& at) {
  std::array<int, 3> base{}, next{};
  std::array<double, 3> t{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double x =
        std::clamp(at[static_cast<Eigen::Index>(a)], 0.0, static_cast<double>(blocks.dimensions[a] - 1));
    base[a] = std::min(static_cast<int>(x), std::max(0, blocks.dimensions[a] - 2));
    next[a] = std::min(base[a] + 1, blocks.dimensions[a] - 1);
    t[a] = x - base[a];
  }
  double value = 0;
  for (int c = 0; c < 8; ++c) {
    const int i = c & 1 ? next[0] : base[0], j = c & 2 ? next[1] : base[1], k = c & 4 ? next[2] : base[2];
    value += (c & 1 ? t[0] : 1 - t[0]) * (c & 2 ? t[1] : 1 - t[1]) * (c & 4 ? t[2] : 1 - t[2]) *
             blocks.at(i, j, k);
  }
  return value;
}

}  // namespace

ScalarVolume localThreshold(const ScalarVolume& t1, const MaskVolume& mask, const IntensityClasses& classes,
                            double scale, const Execution& execution) {
  const Eigen::Vector3d spacing = voxelSpacing(t1.voxelToWorld);
  std::array<int, 3> block{};
  for (std::size_t a = 0; a < 3; ++a) {
    block[a] =
        std::max(1, static_cast<int>(std::lround(0.4 * scale / spacing[static_cast<Eigen::Index>(a)])));
  }
  const double half = 0.5 * (classes.white - classes.grey);
  const double prior = 0.02 * block[0] * block[1] * block[2];
  const auto meanOf = [&](double low, double high, double global) {
    BlockMeans sums = blockSums(t1, mask, low, high, block);
    const ScalarVolume weight = gaussianBlur(std::move(sums.weight), scale, execution);
    ScalarVolume mean = gaussianBlur(std::move(sums.sum), scale, execution);
    for (std::size_t v = 0; v < mean.size(); ++v) {
      mean.values[v] = static_cast<float>((mean.values[v] + prior * global) / (weight.values[v] + prior));
    }
    return mean;
  };
  ScalarVolume middle = meanOf(classes.threshold, classes.white + 2 * half, classes.white);
  const ScalarVolume grey = meanOf(classes.grey - half, classes.threshold, classes.grey);
  for (std::size_t v = 0; v < middle.size(); ++v)
    middle.values[v] = 0.5f * (middle.values[v] + grey.values[v]);
  ScalarVolume out(t1.dimensions, t1.voxelToWorld);
  parallelFor(
      static_cast<std::size_t>(t1.dimensions[2]), execution,
      [&](std::size_t begin, std::size_t end) {
        for (int k = static_cast<int>(begin); k < static_cast<int>(end); ++k) {
          for (int j = 0; j < t1.dimensions[1]; ++j) {
            for (int i = 0; i < t1.dimensions[0]; ++i) {
              const Eigen::Vector3d at((i + 0.5) / block[0] - 0.5, (j + 0.5) / block[1] - 0.5,
                                       (k + 0.5) / block[2] - 0.5);
              out.at(i, j, k) = static_cast<float>(interpolate(middle, at));
            }
          }
        }
      },
      4);
  return out;
}

}  // namespace authalic
