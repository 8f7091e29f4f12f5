#include "Density.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <utility>

#include <vtkCurvatureDensity.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRegionDensity.h>
#include <vtkStringArray.h>

namespace authalic::cli {
namespace {

const char* const kGrammar =
    "REGION=FACTOR is required, REGION being FILE.label, FILE.annot:NAME, ARRAY:VALUE, sphere:X,Y,Z,RADIUS or "
    "geodesic:X,Y,Z,RADIUS";

/// A region and its factor: the text before and after the last '='.
std::pair<std::string, double> splitFactor(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  double factor = 0;
  if (equals == std::string::npos || equals == 0) {
    throw Failure(UsageProblem, "--roi: " + std::string(kGrammar) + ", but it is '" + text + "'.");
  }
  if (!CLI::detail::lexical_cast(text.substr(equals + 1), factor) || !(factor > 0) || !std::isfinite(factor)) {
    throw Failure(UsageProblem, "--roi " + text + ": a factor above 0 is required after '=' (4 enlarges four times, "
                                "0.25 shrinks to a quarter), but it is '" + text.substr(equals + 1) + "'.");
  }
  return {text.substr(0, equals), factor};
}

bool startsWith(const std::string& text, const std::string& start) { return text.compare(0, start.size(), start) == 0; }

/// "sphere:1,2,3,10": centre and radius.
void setBall(vtkRegionDensity* filter, const std::string& region) {
  std::vector<double> numbers;
  for (const std::string& part : CLI::detail::split(region.substr(region.find(':') + 1), ',')) {
    double number = 0;
    if (CLI::detail::lexical_cast(part, number)) numbers.push_back(number);
  }
  if (numbers.size() != 4 || !(numbers[3] > 0)) {
    throw Failure(UsageProblem, "--roi " + region + ": four numbers X,Y,Z,RADIUS are required (mm, in the space of the "
                                "surface, RADIUS above 0).");
  }
  filter->SetCentre(numbers[0], numbers[1], numbers[2]);
  filter->SetRadius(numbers[3]);
}

bool isThere(vtkPolyData* surface, const std::string& arrayOrFile) {
  std::error_code ignored;
  return surface->GetPointData()->HasArray(arrayOrFile.c_str()) || std::filesystem::exists(arrayOrFile, ignored);
}

/// "lh.aparc.annot:precentral", "sulcus:2", "lh.V1.label": array or file, and what of it.
void setArray(vtkRegionDensity* filter, const std::string& region, vtkSmartPointer<vtkPolyData>& surface,
              const Session& session) {
  const std::size_t colon = isThere(surface, region) ? std::string::npos : region.rfind(':');
  filter->SetRegionArrayName(arrayOf(surface, region.substr(0, colon), session));
  filter->SetRegionLabel(region.substr(region.find_last_of('/') + 1));
  const std::string what = colon == std::string::npos ? std::string() : region.substr(colon + 1);
  double value = 0;
  const bool named =
      surface->GetFieldData()->GetAbstractArray((filter->GetRegionArrayName() + "Names").c_str()) != nullptr;
  if (colon == std::string::npos && named) filter->AddRegionName("(none given)");  // the refusal lists the names
  if (colon == std::string::npos) return;
  if (CLI::detail::lexical_cast(what, value)) return filter->AddRegionValue(value);
  filter->AddRegionName(what.empty() ? "(none given)" : what.c_str());
}

std::vector<double> numbersOf(vtkPolyData* surface, const char* name) {
  std::vector<double> values;
  vtkDataArray* array = surface->GetFieldData()->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i) values.push_back(array->GetComponent(i, 0));
  return values;
}

}  // namespace

void DensityOptions::declare(CLI::App* verb) {
  verb->add_option("--measure", measure,
                   "Density relative to the native area, > 0, one number per vertex (or per face): an array of "
                   "SURFACE, or a file (text, morphometry, GIFTI).")
      ->type_name("ARRAY|FILE");
  verb->add_option("--roi", regions,
                   "A region of interest gets FACTOR times its area, relative to the rest: with the share s, "
                   "FACTOR s / (FACTOR s + 1 - s) of the map. REGION is FILE.label; FILE.annot:NAME, or NAME of a "
                   ".label.gii; ARRAY:VALUE, or ARRAY for all but 0; sphere:X,Y,Z,RADIUS (mm, the piece that is "
                   "connected to the nearest vertex) or geodesic:X,Y,Z,RADIUS. May be given several times.")
      ->type_name("REGION=FACTOR")->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  verb->add_option("--roi-blend", blend, "Width over which the density passes across the border of every region, mm.")
      ->type_name("MM")->check(notNegative())->default_str("0");
  vtkNew<vtkCurvatureDensity> defaults;
  verb->add_option("--curvature-measure", curvature,
                   "Density that grows with the absolute curvature: gaussian (of SURFACE), an array, or a file.")
      ->type_name("gaussian|ARRAY|FILE")->excludes("--measure");
  std::ostringstream weight;
  weight << defaults->GetWeight();
  verb->add_option("--curvature-weight", curvatureWeight,
                   "Part of the curvature in that measure, 0 to below 1; the rest is area.")
      ->type_name("X")->needs("--curvature-measure")->default_str(weight.str());
}

std::string DensityOptions::apply(vtkSmartPointer<vtkPolyData>& surface, const Session& session) const {
  std::string array;
  if (!measure.empty()) array = arrayOf(surface, measure, session);
  if (!curvature.empty()) {
    vtkNew<vtkCurvatureDensity> filter;
    if (curvature != "gaussian") filter->SetCurvatureArrayName(arrayOf(surface, curvature, session));
    if (curvatureWeight) filter->SetWeight(*curvatureWeight);
    filter->SetInputData(surface);
    update(filter.Get(), session);
    surface = filter->GetOutput();
    array = "CurvatureDensity";
  }
  if (blend && regions.empty()) throw Failure(UsageProblem, "--roi-blend needs a region: give --roi REGION=FACTOR.");
  for (const std::string& text : regions) {
    const auto [region, factor] = splitFactor(text);
    vtkNew<vtkRegionDensity> filter;
    if (startsWith(region, "sphere:") || startsWith(region, "geodesic:")) {
      filter->SetRegionMode(region[0] == 's' ? vtkRegionDensity::BALL : vtkRegionDensity::GEODESIC_BALL);
      setBall(filter, region);
    } else {
      setArray(filter, region, surface, session);
    }
    filter->SetFactor(factor);
    if (blend) filter->SetBlend(*blend);
    filter->SetMeasureArrayName(array);
    filter->SetInputData(surface);
    update(filter.Get(), session);
    surface = filter->GetOutput();
    array = "RegionDensity";
  }
  return array;
}

void sayRegions(vtkPolyData* surfaceOrMap, const Session& session) {
  auto* names =
      vtkStringArray::SafeDownCast(surfaceOrMap->GetFieldData()->GetAbstractArray("RegionNames"));
  const std::vector<double> factors = numbersOf(surfaceOrMap, "RegionFactors"),
                            sources = numbersOf(surfaceOrMap, "RegionSourceShares"),
                            targets = numbersOf(surfaceOrMap, "RegionTargetShares"),
                            images = numbersOf(surfaceOrMap, "RegionImageShares");
  if (session.quiet || !names || targets.size() != static_cast<std::size_t>(names->GetNumberOfValues())) return;
  for (std::size_t r = 0; r < targets.size(); ++r) {
    std::fprintf(stderr, "region %s: factor %g, %.4f %% of the surface, target %.4f %%",
                 names->GetValue(static_cast<vtkIdType>(r)).c_str(), factors[r], 100 * sources[r], 100 * targets[r]);
    if (r < images.size()) std::fprintf(stderr, ", reached %.4f %% of the map", 100 * images[r]);
    std::fputc('\n', stderr);
  }
}

}  // namespace authalic::cli
