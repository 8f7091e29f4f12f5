/// @file
/// What a map and a surface report about themselves, as JSON.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "Core/base/Status.h"
#include "Core/distortion/Distortion.h"
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
  MeshReport topology;                                  ///< of the surface that was mapped
  Json options = Json::object();  ///< every option with the value used, defaults included
  Json more = Json::object();     ///< members that only this method has, put at the end
};

/// Members, in this order: version, method, status, iterations, residual_history, seconds (stages and
/// `total`), metrics, flips, topology, options, and those of `more`.
/// @throws InvalidArgument when `more` is not an object or repeats one of these members.
[[nodiscard]] Json mapReport(const MapReport& report);

/// Counts, sizes, components, loops and every defect with its place (scanner RAS mm).
/// Lists are cut after `mostDefects` entries; the counts are of all.
[[nodiscard]] Json meshReport(const MeshReport& report, std::size_t mostDefects = 100);

/// Every metric by its name; ideal values are in docs/conventions.md.
[[nodiscard]] Json distortionReport(const DistortionSummary& summary);

}  // namespace authalic
