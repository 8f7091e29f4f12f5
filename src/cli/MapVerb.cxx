#include <memory>
#include <optional>

#include <vtkBarycentricMap.h>
#include <vtkDiscreteLieFlow.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "Files.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> methods = {"tutte", "harmonic", "mean-value", "lie-flow"};
const std::vector<std::string> barycentric = {"tutte", "harmonic", "mean-value"};
const std::vector<std::string> finishes = {"none", "unfold", "match"};

struct MapOptions {
  std::string method, surface, output, report, domain = "disk", measure;
  std::optional<std::string> initial, finish;
  std::optional<double> tolerance, fixedStep, stepRatio;
  std::optional<int> iterations;
  bool allowNonconverged = false;
  SpaceOption space;
};

VerbHelp mapHelp() {
  VerbHelp help;
  help.name = "map";
  help.summary = "map a topological disk to the plane";
  help.synopsis = "map METHOD SURFACE -o MAP.vtp [OPTIONS]";
  help.description =
      "METHOD is tutte (combinatorial; never folds on a convex domain), harmonic (cotangent weights; low angle distortion, "
      "may fold), mean-value (nearly harmonic; never folds on a convex domain) or lie-flow (area-preserving, or to a "
      "measure of yours).\n\nSURFACE must be a topological disk: connected, manifold, genus 0, one boundary loop; authalic "
      "info says what it is, authalic cut makes a disk of a closed cortex.\n\nMAP.vtp holds the image (z = 0, double "
      "precision) with vertices and faces in the order of the input, the point array OriginalPoints, the cell arrays "
      "AreaDistortion (log2 of image share / target share), AngleDistortion and Flipped, and every metric in its field "
      "data.";
  help.examples = {"authalic map lie-flow lh.disk.vtp -o lh.map.vtp --report lh.map.json\n  area-preserving map to the unit disk",
                   "authalic map harmonic face.off -o face.vtp --domain rectangle:2\n  harmonic map to [0, 2] x [0, 1]",
                   "authalic map lie-flow lh.disk.vtp -o lh.map.vtp --measure importance.txt\n"
                   "  share of every vertex in proportion to its native area times its number in the file"};
  help.references = {"Su et al. 2019, discrete Lie flow: a measure controllable parameterization method",
                     "Zou, Hu, Gu, Hua 2011, authalic parameterization of general surfaces using Lie advection",
                     "Tutte 1963; Pinkall and Polthier 1993; Floater 2003"};
  return help;
}

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

void setDomain(vtkDiskMapAlgorithm* filter, const std::string& text) {
  const auto [name, argument] = split(text);
  if (name == "disk" && argument.empty()) return filter->SetDomainToDisk();
  if (name == "square" && argument.empty()) return filter->SetDomainToSquare();
  if (name == "polygon" && !argument.empty()) return setPolygon(filter, argument);
  if (name == "rectangle" && !argument.empty()) {
    double aspect = 0;
    if (!CLI::detail::lexical_cast(argument, aspect)) {
      throw Failure(UsageProblem, "--domain rectangle:ASPECT needs a number (width / height); it is '" + argument + "'.");
    }
    filter->SetAspect(aspect);
    return filter->SetDomainToRectangle();
  }
  for (const char* other : {"sphere", "annulus", "circle-domain", "torus", "free"}) {
    if (name == other) throw Failure(UsageProblem, "--domain " + name + " is not for maps of a disk by this method; take disk, square, rectangle:ASPECT or polygon:FILE.");
  }
  throw Failure(UsageProblem, "--domain must be disk, square, rectangle:ASPECT or polygon:FILE; it is '" + text + "'.");
}

void refuseFlowOptions(const MapOptions& o) {
  const std::pair<const char*, bool> given[] = {{"--initial", o.initial.has_value()},
                                                {"--tolerance", o.tolerance.has_value()},
                                                {"--max-iterations", o.iterations.has_value()},
                                                {"--fixed-step", o.fixedStep.has_value()},
                                                {"--step-ratio", o.stepRatio.has_value()},
                                                {"--finish", o.finish.has_value()}};
  for (const auto& [name, isGiven] : given) {
    if (isGiven) throw Failure(UsageProblem, std::string(name) + " belongs to lie-flow; method " + o.method + " has no such option.");
  }
}

void setFlowOptions(vtkDiscreteLieFlow* flow, const MapOptions& o, const Session& session) {
  if (o.tolerance) flow->SetTolerance(*o.tolerance);
  if (o.iterations) flow->SetMaximumIterations(*o.iterations);
  if (o.fixedStep) flow->SetFixedStep(*o.fixedStep);
  if (o.stepRatio) flow->SetStepRatio(*o.stepRatio);
  if (o.finish) flow->SetFinish(choice("--finish", *o.finish, finishes));
  if (!o.initial) return;
  const bool isFile = o.initial->find('.') != std::string::npos;
  if (isFile) flow->SetInputData(1, readSurface(*o.initial, session, o.space));
  else flow->SetInitialMethod(choice("--initial", *o.initial, barycentric));
}

void finishMap(vtkDiskMapAlgorithm* filter, const MapOptions& o, const Session& session, vtkSmartPointer<vtkPolyData> surface) {
  setDomain(filter, o.domain);
  if (!o.measure.empty()) filter->SetMeasureArrayName(arrayOf(surface, o.measure, session));
  filter->SetInputData(0, surface);
  const int code = update(filter, session);
  writeSurface(o.output, filter->GetOutput());
  if (!o.report.empty()) writeText(o.report, filter->GetReport());
  if (code != NotConverged || o.allowNonconverged) return;
  throw Failure(NotConverged, "The map did not reach the tolerance; the best one is in " + o.output +
                                  " (--allow-nonconverged accepts it).");
}

void runMap(const MapOptions& o, const Session& session) {
  const int method = choice("METHOD", o.method, methods);
  requireArrayFormat("--output", o.output);
  requireWritable({o.output, o.report});
  const vtkSmartPointer<vtkPolyData> surface = readSurface(o.surface, session, o.space);
  if (o.method == "lie-flow") {
    vtkNew<vtkDiscreteLieFlow> flow;
    setFlowOptions(flow, o, session);
    return finishMap(flow, o, session, surface);
  }
  refuseFlowOptions(o);
  vtkNew<vtkBarycentricMap> map;
  map->SetMethod(method);
  finishMap(map, o, session, surface);
}

std::string text(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

void declareFlow(CLI::App* verb, MapOptions& o) {
  vtkNew<vtkDiscreteLieFlow> flow;
  const auto group = "Options of lie-flow";
  verb->add_option("--initial", o.initial, "Initial map: " + oneOf(barycentric) + ", or a MAP.vtp to the same domain.")
      ->type_name("METHOD|MAP.vtp")->default_str(barycentric[static_cast<std::size_t>(flow->GetInitialMethod())])->group(group);
  verb->add_option("--tolerance", o.tolerance, "Residual sqrt(sum m (r - 1)^2) of vertex stars at which the map is done, > 0.")
      ->type_name("X")->default_str(text(flow->GetTolerance()))->group(group);
  verb->add_option("--max-iterations", o.iterations, "Most steps of the flow.")
      ->type_name("N")->check(notNegative())->default_str(std::to_string(flow->GetMaximumIterations()))->group(group);
  verb->add_option("--step-ratio", o.stepRatio, "Step as a part of the first flip of a triangle, between 0 and 1.")
      ->type_name("X")->default_str(text(flow->GetStepRatio()))->group(group);
  verb->add_option("--fixed-step", o.fixedStep, "This step instead of the adaptive one; 0 = adaptive. May collapse the mesh.")
      ->type_name("X")->default_str(text(flow->GetFixedStep()))->group(group);
  verb->add_option("--finish", o.finish, "After the flow, on the input's connectivity: " + oneOf(finishes) + " areas.")
      ->type_name("HOW")->default_str(finishes[static_cast<std::size_t>(flow->GetFinish())])->group(group);
}

}  // namespace

void addMap(CLI::App& app, Session& session) {
  auto o = std::make_shared<MapOptions>();
  CLI::App* verb = addVerb(app, session, mapHelp());
  verb->add_option("METHOD", o->method, "How: " + oneOf(methods) + ".")->required();
  verb->add_option("SURFACE", o->surface, "The disk, in any format that authalic info reads.")->required();
  verb->add_option("-o,--output", o->output, "The map.")->type_name("MAP.vtp")->required();
  verb->add_option("--report", o->report, "Status, residual history, seconds, metrics, flips, topology, options, version.")
      ->type_name("REPORT.json");
  verb->add_option("--domain", o->domain,
                   "Where to: disk (unit), square (unit), rectangle:ASPECT (width / height, height 1) or polygon:FILE (x y of "
                   "a corner per line).")
      ->type_name("DOMAIN")->capture_default_str();
  verb->add_option("--measure", o->measure,
                   "Density relative to the native area, > 0, one number per vertex (or per face): an array of SURFACE, or a "
                   "file (text, morphometry, GIFTI).")
      ->type_name("ARRAY|FILE");
  verb->add_flag("--allow-nonconverged", o->allowNonconverged, "Exit 0 although the tolerance was not reached.");
  o->space.declare(verb);
  declareFlow(verb, *o);
  verb->callback([o, &session] { runMap(*o, session); });
}

}  // namespace authalic::cli
