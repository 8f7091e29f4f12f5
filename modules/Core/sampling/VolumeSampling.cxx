#include "Core/sampling/VolumeSampling.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "Core/base/Error.h"

namespace authalic {

namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
constexpr double kMostSamples = 10000;
constexpr std::size_t kBlock = 32768;  // vertices between two looks at the caller's wish to stop

void requireRange(const char* what, double from, double to, double step) {
  const std::string found =
      std::to_string(from) + " to " + std::to_string(to) + " by " + std::to_string(step);
  if (!std::isfinite(from) || !std::isfinite(to) || !std::isfinite(step) || step <= 0.0 || from > to) {
    throw InvalidArgument(std::string("A ") + what +
                          " range with from <= to and a step above 0 is required, but it is " + found +
                          "; correct the range.");
  }
  if ((to - from) / step > kMostSamples) {
    throw InvalidArgument(std::string("At most 10000 samples per vertex are allowed, but the ") + what +
                          " range is " + found + "; enlarge the step.");
  }
}

/// from, from + step, … up to `to`.
std::vector<double> steps(double from, double to, double step) {
  const int count = static_cast<int>(std::floor((to - from) / step + 1e-9)) + 1;
  std::vector<double> result(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) result[static_cast<std::size_t>(k)] = from + k * step;
  return result;
}

double medianOf(std::vector<double>& samples) {
  std::sort(samples.begin(), samples.end());
  const std::size_t half = samples.size() / 2;
  return samples.size() % 2 == 1 ? samples[half] : 0.5 * (samples[half - 1] + samples[half]);
}

double modeOf(std::vector<double>& samples) {
  std::sort(samples.begin(), samples.end());
  double best = samples.front();
  std::ptrdiff_t most = 0;
  for (auto run = samples.begin(); run != samples.end();) {
    const auto end = std::upper_bound(run, samples.end(), *run);
    if (end - run > most) {
      most = end - run;
      best = *run;
    }
    run = end;
  }
  return best;
}

/// Sorts `samples` where the reducer needs it.
double reduce(std::vector<double>& samples, SamplingReducer reducer) {
  if (samples.empty()) return kNoValue;
  switch (reducer) {
    case SamplingReducer::Mean:
      return std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
    case SamplingReducer::Median:
      return medianOf(samples);
    case SamplingReducer::Maximum:
      return *std::max_element(samples.begin(), samples.end());
    case SamplingReducer::Minimum:
      return *std::min_element(samples.begin(), samples.end());
    case SamplingReducer::Mode:
      return modeOf(samples);
  }
  return kNoValue;
}

/// Samples at points + t·directions for every t of `positions`; a direction that is not finite makes its
/// vertex n/a.
template <class T>
VolumeSamples sampleLines(const Points3& points, const Points3& directions,
                          const std::vector<double>& positions, const VolumeOf<T>& volume,
                          const VolumeSamplingOptions& options, const Execution& execution) {
  const Interpolator<T> valueAt(volume, options.interpolation);
  const auto count = static_cast<std::size_t>(points.rows());
  VolumeSamples result;
  result.samplesPerVertex = static_cast<int>(positions.size());
  result.values.assign(count, kNoValue);
  result.coverage.assign(count, 0.0);
  const auto sampleVertices = [&](std::size_t begin, std::size_t end) {
    std::vector<double> samples;
    for (std::size_t v = begin; v < end; ++v) {
      samples.clear();
      const Eigen::Vector3d start = points.row(static_cast<Eigen::Index>(v)).transpose();
      const Eigen::Vector3d direction = directions.row(static_cast<Eigen::Index>(v)).transpose();
      if (!direction.allFinite()) continue;
      for (const double t : positions) {
        const std::optional<double> value = valueAt(start + t * direction);
        if (value && !(options.skipZero && *value == 0.0)) samples.push_back(*value);
      }
      result.coverage[v] = static_cast<double>(samples.size()) / static_cast<double>(positions.size());
      result.values[v] = reduce(samples, options.reducer);
    }
  };
  for (std::size_t block = 0; block < count; block += kBlock) {
    execution.throwIfCancelled();
    execution.report(static_cast<double>(block) / static_cast<double>(count), "sampling the volume");
    parallelFor(std::min(kBlock, count - block), execution,
                [&](std::size_t begin, std::size_t end) { sampleVertices(block + begin, block + end); });
  }
  execution.report(1.0, "sampling the volume");
  result.verticesWithoutValue = static_cast<int>(
      std::count_if(result.values.begin(), result.values.end(), [](double x) { return std::isnan(x); }));
  return result;
}

/// Inward unit directions; NaN where there is no normal.
Points3 inwardDirections(const Points3& normals) {
  Points3 result(normals.rows(), 3);
  for (Eigen::Index v = 0; v < normals.rows(); ++v) {
    const double length = normals.row(v).norm();
    if (length > 0.0 && std::isfinite(length)) {
      result.row(v) = -normals.row(v) / length;
    } else {
      result.row(v).setConstant(kNoValue);
    }
  }
  return result;
}

void requireOneSurfaceMode(const VolumeSamplingOptions& options) {
  if (options.mode == SamplingMode::BetweenSurfaces) {
    throw InvalidArgument(
        "Two surfaces are required to sample between surfaces, but one was given; give the other surface or "
        "choose "
        "at-vertex or along-normal.");
  }
}

}  // namespace

const char* samplingModeName(SamplingMode mode) noexcept {
  switch (mode) {
    case SamplingMode::AtVertex:
      return "at-vertex";
    case SamplingMode::AlongNormal:
      return "along-normal";
    case SamplingMode::BetweenSurfaces:
      return "between-surfaces";
  }
  return "unknown";
}

const char* samplingReducerName(SamplingReducer reducer) noexcept {
  switch (reducer) {
    case SamplingReducer::Mean:
      return "mean";
    case SamplingReducer::Median:
      return "median";
    case SamplingReducer::Maximum:
      return "maximum";
    case SamplingReducer::Minimum:
      return "minimum";
    case SamplingReducer::Mode:
      return "mode";
  }
  return "unknown";
}

const char* interpolationName(Interpolation interpolation) noexcept {
  return interpolation == Interpolation::Nearest ? "nearest" : "trilinear";
}

void VolumeSamplingOptions::validate() const {
  requireRange("depth", depthFrom, depthTo, depthStep);
  requireRange("fraction", fractionFrom, fractionTo, fractionStep);
}

template <class T>
VolumeSamples sampleVolume(const TriangleMesh& surface, const VolumeOf<T>& volume,
                           const VolumeSamplingOptions& options, const Execution& execution) {
  if (options.mode == SamplingMode::AlongNormal) {
    return sampleVolume(surface, angleWeightedNormals(surface), volume, options, execution);
  }
  options.validate();
  requireOneSurfaceMode(options);
  const Points3 nowhere = Points3::Zero(surface.points().rows(), 3);
  return sampleLines(surface.points(), nowhere, {0.0}, volume, options, execution);
}

template <class T>
VolumeSamples sampleVolume(const TriangleMesh& surface, const Points3& normals, const VolumeOf<T>& volume,
                           const VolumeSamplingOptions& options, const Execution& execution) {
  options.validate();
  requireOneSurfaceMode(options);
  if (normals.rows() != surface.points().rows()) {
    throw GeometryError("One normal per vertex is required, but there are " + std::to_string(normals.rows()) +
                        " normals for " + std::to_string(surface.vertexCount()) +
                        " vertices; compute the normals on this surface.");
  }
  if (options.mode == SamplingMode::AtVertex) return sampleVolume(surface, volume, options, execution);
  return sampleLines(surface.points(), inwardDirections(normals),
                     steps(options.depthFrom, options.depthTo, options.depthStep), volume, options,
                     execution);
}

template <class T>
VolumeSamples sampleVolumeBetween(const TriangleMesh& surface, const Points3& otherPoints,
                                  const VolumeOf<T>& volume, const VolumeSamplingOptions& options,
                                  const Execution& execution) {
  options.validate();
  if (otherPoints.rows() != surface.points().rows()) {
    throw GeometryError("Two surfaces with the same vertices are required, but one has " +
                        std::to_string(surface.vertexCount()) + " and the other " +
                        std::to_string(otherPoints.rows()) +
                        " vertices; give the white and the pial surface of the same hemisphere.");
  }
  for (Eigen::Index v = 0; v < otherPoints.rows(); ++v) {
    if (!otherPoints.row(v).allFinite()) {
      throw GeometryError("Finite coordinates are required, but vertex " + std::to_string(v) +
                          " of the other surface has a NaN or infinite one; repair that vertex.");
    }
  }
  return sampleLines(surface.points(), otherPoints - surface.points(),
                     steps(options.fractionFrom, options.fractionTo, options.fractionStep), volume, options,
                     execution);
}

Points3 angleWeightedNormals(const TriangleMesh& surface) {
  Points3 normals = Points3::Zero(surface.points().rows(), 3);
  for (int f = 0; f < surface.faceCount(); ++f) {
    const Eigen::Vector3d normal =
        (surface.corner(f, 1) - surface.corner(f, 0)).cross(surface.corner(f, 2) - surface.corner(f, 0));
    const double length = normal.norm();
    if (!(length > 0.0)) continue;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d a = surface.corner(f, (k + 1) % 3) - surface.corner(f, k);
      const Eigen::Vector3d b = surface.corner(f, (k + 2) % 3) - surface.corner(f, k);
      normals.row(surface.faces()(f, k)) +=
          std::atan2(a.cross(b).norm(), a.dot(b)) / length * normal.transpose();
    }
  }
  for (Eigen::Index v = 0; v < normals.rows(); ++v) {
    const double length = normals.row(v).norm();
    if (length > 0.0) normals.row(v) /= length;
  }
  return normals;
}

#define AUTHALIC_INSTANTIATE_SAMPLING(T)                                                                 \
  template VolumeSamples sampleVolume<T>(const TriangleMesh&, const VolumeOf<T>&,                        \
                                         const VolumeSamplingOptions&, const Execution&);                \
  template VolumeSamples sampleVolume<T>(const TriangleMesh&, const Points3&, const VolumeOf<T>&,        \
                                         const VolumeSamplingOptions&, const Execution&);                \
  template VolumeSamples sampleVolumeBetween<T>(const TriangleMesh&, const Points3&, const VolumeOf<T>&, \
                                                const VolumeSamplingOptions&, const Execution&);
AUTHALIC_INSTANTIATE_SAMPLING(float)
AUTHALIC_INSTANTIATE_SAMPLING(double)
AUTHALIC_INSTANTIATE_SAMPLING(std::int16_t)
AUTHALIC_INSTANTIATE_SAMPLING(std::int32_t)
AUTHALIC_INSTANTIATE_SAMPLING(std::uint8_t)
#undef AUTHALIC_INSTANTIATE_SAMPLING

}  // namespace authalic
