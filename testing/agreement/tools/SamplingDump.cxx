// What Core samples and sums up, as plain arrays, for comparison with independent programs.
//
//   sampling_dump sample SURFACE VOLUME OUT MODE REDUCER INTERPOLATION [OTHER]   OUT: values, then coverage
//   (float64) sampling_dump summary SURFACE VOLUME              prints mean, sd, median of the sampled volume
//   over the surface

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include "Core/base/Error.h"
#include "Core/sampling/VolumeSampling.h"
#include "Core/statistics/ElementTable.h"
#include "Formats/SurfaceFile.h"
#include "Formats/VolumeFile.h"

using namespace authalic;

namespace {

TriangleMesh readMesh(const std::string& path) {
  SurfaceFile file = readSurface(path);
  if (file.space != CoordinateSpace::Unknown) toScannerRas(file);
  Points3 points(static_cast<Eigen::Index>(file.vertexCount()), 3);
  Faces faces(static_cast<Eigen::Index>(file.faceCount()), 3);
  std::copy(file.points.begin(), file.points.end(), points.data());
  std::copy(file.faces.begin(), file.faces.end(), faces.data());
  return TriangleMesh(points, faces);
}

void write(std::ofstream& out, const std::vector<double>& values) {
  out.write(reinterpret_cast<const char*>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(double)));
}

int sample(const std::vector<std::string>& words) {
  VolumeSamplingOptions options;
  options.mode = static_cast<SamplingMode>(std::stoi(words.at(4)));
  options.reducer = static_cast<SamplingReducer>(std::stoi(words.at(5)));
  options.interpolation = static_cast<Interpolation>(std::stoi(words.at(6)));
  const TriangleMesh surface = readMesh(words.at(1));
  const ScalarVolume volume = readVolume(words.at(2)).scalars();
  const VolumeSamples samples =
      words.size() > 7 ? sampleVolumeBetween(surface, readMesh(words.at(7)).points(), volume, options)
                       : sampleVolume(surface, volume, options);
  std::ofstream out(words.at(3), std::ios::binary);
  write(out, samples.values);
  write(out, samples.coverage);
  return out ? 0 : 1;
}

int summary(const std::vector<std::string>& words) {
  const TriangleMesh surface = readMesh(words.at(1));
  const VolumeSamples samples = sampleVolume(surface, readVolume(words.at(2)).scalars());
  const SurfaceLabels all{std::vector<int>(samples.values.size(), 1), {{1, "all"}}};
  const SurfaceField field{"sample", samples.values, samples.coverage, "", ""};
  const RegionRow row = regionTable(surface, all, {field}).rows.at(0);
  const FieldStatistics& statistics = row.fields.at(0);
  std::cout << std::setprecision(17) << row.area << ' ' << statistics.mean << ' ' << statistics.sd << ' '
            << statistics.median << '\n';
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> words(arguments + 1, arguments + count);
  try {
    if (!words.empty() && words[0] == "sample") return sample(words);
    if (!words.empty() && words[0] == "summary") return summary(words);
    std::cerr << "sample or summary is required\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
