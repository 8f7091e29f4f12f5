#include "MapFamily.h"

#include <sstream>
#include <utility>

#include <vtkCurvatureFlowMapAlgorithm.h>
#include <vtkDiskMapAlgorithm.h>
#include <vtkNew.h>
#include <vtkYamabeMap.h>

namespace authalic::cli {
namespace {

/// Name and argument of "rectangle:2".
std::pair<std::string, std::string> split(const std::string& text) {
  const std::size_t colon = text.find(':');
  return {text.substr(0, colon), colon == std::string::npos ? std::string() : text.substr(colon + 1)};
}

void setPolygon(vtkDiskMapAlgorithm* filter, const std::string& path) {
  for (const std::vector<double>& row : readNumbers(path)) {
    if (row.size() != 2) throw Failure(FileProblem, path + ": two numbers per line (x y of a corner) are required.");
    filter->AddPolygonCorner(row[0], row[1]);
  }
  filter->SetDomainToPolygon();
}

void setRectangle(vtkDiskMapAlgorithm* filter, const std::string& aspect) {
  double number = 0;
  if (!CLI::detail::lexical_cast(aspect, number)) {
    throw Failure(UsageProblem, "--domain rectangle:ASPECT needs a number (width / height); it is '" + aspect + "'.");
  }
  filter->SetAspect(number);
  filter->SetDomainToRectangle();
}

}  // namespace

CLI::Option* MapFamily::own(CLI::Option* option) {
  own_.push_back(option);
  const std::vector<std::string> names = methods();
  return option->group("Options of " + (names.size() == 1 ? names.front() : oneOf(names)));
}

void setDiskDomain(vtkDiskMapAlgorithm* filter, const std::optional<std::string>& text) {
  const auto [name, argument] = split(text.value_or("disk"));
  if (name == "disk" && argument.empty()) return filter->SetDomainToDisk();
  if (name == "square" && argument.empty()) return filter->SetDomainToSquare();
  if (name == "polygon" && !argument.empty()) return setPolygon(filter, argument);
  if (name == "rectangle" && !argument.empty()) return setRectangle(filter, argument);
  for (const char* other : {"sphere", "annulus", "circle-domain", "torus", "free"}) {
    if (name == other) {
      throw Failure(UsageProblem, "--domain " + name + " is not for maps of a disk by this method; take disk, square, "
                                  "rectangle:ASPECT or polygon:FILE.");
    }
  }
  throw Failure(UsageProblem,
                "--domain must be disk, square, rectangle:ASPECT or polygon:FILE; it is '" + *text + "'.");
}

namespace {

const std::vector<std::string> metrics = {"vertex-scaling", "circle-packing"};
const std::vector<std::string> radii = {"tangent", "circumradius"};

}  // namespace

std::map<std::string, std::string> flowOptions() {
  const vtkNew<vtkYamabeMap> defaults;
  return {{"--tolerance", "largest |K - target|, radians (default: " + shown(defaults->GetTolerance()) + ")"},
          {"--max-iterations", "Newton steps (default: " + std::to_string(defaults->GetMaximumIterations()) + ")"},
          {"--metric", "how lengths follow the scale factors, " + oneOf(metrics) + " (default: " +
                           metrics[static_cast<std::size_t>(defaults->GetMetric())] + ")"},
          {"--radii", "of --metric circle-packing, " + oneOf(radii) + " (default: " +
                          radii[static_cast<std::size_t>(defaults->GetRadii())] + ")"},
          {"--start-vertex", "boundary vertex on the positive x axis, from 0; -1 is the smallest (default: " +
                                 std::to_string(defaults->GetStartVertex()) + ")"},
          {"--no-unfold", "leave folded faces as the conformal map has them"},
          {"--refinement", "also write the common refinement of the input and the flow's triangulation, on which "
                           "nothing folds"}};
}

void setFlowOptions(vtkCurvatureFlowMapAlgorithm* filter, const SharedMapOptions& shared) {
  if (shared.metric) filter->SetMetric(choice("--metric", *shared.metric, metrics));
  if (shared.radii && filter->GetMetric() != vtkCurvatureFlowMapAlgorithm::CIRCLE_PACKING) {
    throw Failure(UsageProblem, "--radii needs --metric circle-packing; the other metric has no circles.");
  }
  if (shared.radii) filter->SetRadii(choice("--radii", *shared.radii, radii));
  if (shared.tolerance) filter->SetTolerance(*shared.tolerance);
  if (shared.maxIterations) filter->SetMaximumIterations(*shared.maxIterations);
  if (shared.startVertex) filter->SetStartVertex(*shared.startVertex);
  filter->SetUnfold(!shared.noUnfold);
  filter->SetRefine(!shared.refinement.empty());
}

std::string diskCentreMeaning() {
  return "what goes to the centre of the disk, area-centroid, vertex:V or face:F, from 0 (default: area-centroid)";
}

std::pair<int, int> diskCentre(const std::string& text) {
  if (text == "area-centroid") return {0, -1};
  const std::size_t colon = text.find(':');
  const std::string what = text.substr(0, colon);
  int id = 0;
  if (colon == std::string::npos || (what != "vertex" && what != "face") ||
      !CLI::detail::lexical_cast(text.substr(colon + 1), id)) {
    throw Failure(UsageProblem, "--centre must be area-centroid, vertex:V or face:F; it is '" + text + "'.");
  }
  return {what == "face" ? 2 : 1, id};
}

bool isFile(const std::string& nameOrPath) { return nameOrPath.find('.') != std::string::npos; }

std::string shown(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

}  // namespace authalic::cli
