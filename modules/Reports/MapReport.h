/// @file
/// What a map and a surface report about themselves, as JSON.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "Core/base/Status.h"
#include "Core/distortion/Distortion.h"
#include "Core/distortion/Histogram.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Core/mesh/MeshReport.h"
#include "Reports/Json.h"

namespace authalic {

/// Everything that the report of a map says. Only `seconds` differs between two runs on the same input.
struct MapReport {
  std::string method;  ///< "tutte", "lie-flow" …
  Status status = Status::NotRun;
  int iterations = 0;
  std::vector<double> residuals;                        ///< one per iteration, the start first
  std::vector<std::pair<std::string, double>> seconds;  ///< stage → wall time, in order
  DistortionSummary metrics;                            ///< on the original connectivity
  std::optional<DistortionHistograms> histograms;       ///< left out when not given
  MeshReport topology;                                  ///< of the surface that was mapped
  Json options = Json::object();  ///< every option with the value used, defaults included
  Json more = Json::object();     ///< members that only this method has, put at the end
};

/// Members, in this order: version, method, status, iterations, residual_history, seconds (stages and
/// `total`), metrics, flips, histograms (when given), topology, options, and those of `more`.
/// @throws InvalidArgument when `more` is not an object or repeats one of these members.
[[nodiscard]] Json mapReport(const MapReport& report);

/// Counts, sizes, components, loops and every defect with its place (scanner RAS mm).
/// Lists are cut after `mostDefects` entries; the counts are of all.
[[nodiscard]] Json meshReport(const MeshReport& report, std::size_t mostDefects = 100);

/// Every metric by its name; ideal values are in docs/conventions.md.
[[nodiscard]] Json distortionReport(const DistortionSummary& summary);

/// What only a sphere has: areas of flat triangles, angles of spherical ones, coverage, folds by both signs.
[[nodiscard]] Json sphericalDistortionReport(const SphericalDistortion& distortion);

/// Bin edges and counts of every histogram, with what lies outside.
[[nodiscard]] Json histogramReport(const DistortionHistograms& histograms);

}  // namespace authalic
