#include <algorithm>
#include <memory>

#include <vtkPolyData.h>

#include "Density.h"
#include "MapFamily.h"

namespace authalic::cli {
namespace {

/// Every family of methods, in the order of the help page.
std::vector<std::unique_ptr<MapFamily>> makeFamilies() {
  std::vector<std::unique_ptr<MapFamily>> families;
  families.push_back(barycentricFamily());
  families.push_back(authalicFamily());
  families.push_back(transportFamily());
  families.push_back(lieFlowFamily());
  families.push_back(lieAdvectionFamily());
  families.push_back(stretchEnergyFamily());
  families.push_back(stretchFamily());
  families.push_back(conformalFlowFamily());
  families.push_back(leastSquaresConformalFamily());
  families.push_back(symmetricDirichletFamily());
  families.push_back(sphereFamily());
  return families;
}

struct MapOptions {
  std::string method, surface, output, report;
  bool allowNonconverged = false, textureCoordinates = false;
  SharedMapOptions shared;
  DensityOptions density;
  std::vector<CLI::Option*> sharedOptions;
  std::vector<std::unique_ptr<MapFamily>> families = makeFamilies();
};

std::vector<std::string> allMethods(const MapOptions& o) {
  std::vector<std::string> all;
  for (const auto& family : o.families) {
    for (const std::string& method : family->methods()) all.push_back(method);
  }
  return all;
}

VerbHelp mapHelp(const MapOptions& o) {
  VerbHelp help;
  help.name = "map";
  help.summary = "map a surface to the plane, the sphere or another domain";
  help.synopsis = "map METHOD SURFACE -o MAP.vtp [OPTIONS]";
  help.description = "METHOD is one of:";
  for (const auto& family : o.families) help.description += "\n\n" + family->description();
  help.description +=
      "\n\nauthalic info says what the topology of SURFACE is, authalic cut makes a disk of a closed cortex.\n\n"
      "MAP.vtp holds the image (z = 0 in the plane, double precision) with vertices and faces in the order of "
      "the input, the point array OriginalPoints, the cell arrays AreaDistortion (log2 of image share / target "
      "share), AngleDistortion, BeltramiCoefficient and Flipped, and every metric and the histograms of both "
      "distortions in its field data.";
  help.examples = {
      "authalic map authalic lh.disk.vtp -o lh.map.vtp --report lh.map.json\n"
      "  area-preserving map to the unit disk",
      "authalic map harmonic face.off -o face.vtp --domain rectangle:2\n  harmonic map to [0, 2] x [0, 1]",
      "authalic map authalic lh.disk.vtp -o lh.map.vtp --measure importance.txt\n"
      "  share of every face in proportion to its native area times the mean of its corners' numbers in the file",
      "authalic map authalic lh.disk.vtp -o lh.map.vtp --roi lh.aparc.annot:precentral=4 --roi-blend 5\n"
      "  a gyrus gets four times the share that its area has; the density passes over 5 mm at its border",
      "authalic map sphere lh.pial -o lh.sphere.vtp --report lh.sphere.json\n"
      "  conformal map of a closed surface to the unit sphere"};
  help.references = {"Su et al. 2019, discrete Lie flow: a measure controllable parameterization method",
                     "Zou, Hu, Gu, Hua 2011, authalic parameterization of general surfaces using Lie advection",
                     "Tutte 1963; Pinkall and Polthier 1993; Floater 2003",
                     "Yoshizawa, Belyaev, Seidel 2004 (stretch); Yueh, Lin, Wu, Yau 2019 (stretch-energy)",
                     "Gu et al. 2016; Su et al. 2016; Kitagawa et al. 2019 (optimal transport)",
                     "Gu et al. 2004; Haker et al. 2000; Kazhdan et al. 2012; Nadeem et al. 2017 (spheres)"};
  return help;
}

const MapFamily& familyOf(const MapOptions& o) {
  for (const auto& family : o.families) {
    const std::vector<std::string> names = family->methods();
    if (std::find(names.begin(), names.end(), o.method) != names.end()) return *family;
  }
  (void)choice("METHOD", o.method, allMethods(o));  // throws, naming the methods
  return *o.families.front();
}

/// "lie-flow, slim": the methods of the families that pass `takes`.
template <class Predicate>
std::string methodsThat(const MapOptions& o, const Predicate& takes) {
  std::string names;
  for (const auto& family : o.families) {
    if (!takes(*family)) continue;
    for (const std::string& method : family->methods()) names += (names.empty() ? "" : ", ") + method;
  }
  return names;
}

void refuseForeignOptions(const MapOptions& o, const MapFamily& mine) {
  const auto refuse = [&](const CLI::Option* option, const std::string& owners) {
    throw Failure(UsageProblem,
                  option->get_name() + " belongs to " + owners + "; method " + o.method + " has no such option.");
  };
  for (const CLI::Option* option : o.sharedOptions) {
    const auto takes = [&](const MapFamily& family) {
      return family.sharedOptions().count(option->get_name()) > 0;
    };
    if (option->count() > 0 && !takes(mine)) refuse(option, methodsThat(o, takes));
  }
  for (const auto& family : o.families) {
    if (family.get() == &mine) continue;
    for (const CLI::Option* option : family->ownOptions()) {
      const auto owns = [&](const MapFamily& other) { return &other == family.get(); };
      if (option->count() > 0) refuse(option, methodsThat(o, owns));
    }
  }
}

void runMap(const MapOptions& o, const Session& session) {
  const MapFamily& family = familyOf(o);
  refuseForeignOptions(o, family);
  requireArrayFormat("--output", o.output);
  std::vector<std::string> files = family.files();
  files.insert(files.end(), {o.output, o.report});
  requireWritable(files);
  vtkSmartPointer<vtkPolyData> surface = readSurface(o.surface, session, o.shared.space);
  const vtkSmartPointer<vtkSurfaceMapAlgorithm> filter = family.filter(o.method, o.shared, session);
  family.addArrays(filter, o.shared, surface, session);
  if (o.textureCoordinates) filter->SetOutputModeToTextureCoordinates();
  filter->SetMeasureArrayName(o.density.apply(surface, session));
  filter->SetInputData(0, surface);
  const int code = update(filter.Get(), session);
  sayRegions(filter->GetOutput(), session);
  writeSurface(o.output, filter->GetOutput());
  if (!o.report.empty()) writeText(o.report, filter->GetReport());
  family.conclude(filter, session);
  if (code != NotConverged || o.allowNonconverged) return;
  throw Failure(NotConverged, "The map did not reach the tolerance; the best one is in " + o.output +
                                  " (--allow-nonconverged accepts it).");
}

void declareOutputs(CLI::App* verb, MapOptions& o) {
  verb->add_option("-o,--output", o.output, "The map.")->type_name("MAP.vtp")->required();
  verb->add_option("--report", o.report,
                   "Status, residual history, seconds, metrics, flips, histograms, topology, options, version.")
      ->type_name("REPORT.json");
  verb->add_flag("--texture-coordinates", o.textureCoordinates,
                 "The points stay the surface; the image becomes texture coordinates in [0, 1].");
  verb->add_flag("--allow-nonconverged", o.allowNonconverged, "Exit 0 although the tolerance was not reached.");
}

/// What a shared option means to each family that takes it.
std::string meanings(const MapOptions& o, const std::string& option) {
  std::string text;
  for (const auto& family : o.families) {
    const auto taken = family->sharedOptions();
    const auto meaning = taken.find(option);
    if (meaning != taken.end()) {
      text += (text.empty() ? "" : " ") + oneOf(family->methods()) + ": " + meaning->second + ".";
    }
  }
  return text;
}

void declareShared(CLI::App* verb, MapOptions& o) {
  verb->add_option(
          "--domain", o.shared.domain,
          "Where to, as the methods above say: disk (unit), square (unit), rectangle:ASPECT (width / "
          "height, height 1), polygon:FILE (x y of a corner per line), sphere (unit), torus (flat, area 1), "
          "flat-cones (area 1), annulus, circle-domain, free.")
      ->type_name("DOMAIN");
  o.density.declare(verb);
  o.sharedOptions = {
      verb->add_option("--initial", o.shared.initial, meanings(o, "--initial"))->type_name("METHOD|MAP.vtp"),
      verb->add_option("--tolerance", o.shared.tolerance, meanings(o, "--tolerance"))->type_name("X"),
      verb->add_option("--max-iterations", o.shared.maxIterations, meanings(o, "--max-iterations"))
          ->type_name("N")->check(notNegative()),
      verb->add_option("--finish", o.shared.finish, meanings(o, "--finish"))->type_name("HOW"),
      verb->add_flag("--no-unfold", o.shared.noUnfold,
                     "Leave folded faces as they are. " + meanings(o, "--no-unfold")),
      verb->add_option("--hole-areas", o.shared.holeAreas,
                       "Area of every hole but the longest loop, mm^2, > 0, in the order of the loops' smallest vertex "
                       "ids; by default, of the cones that close them. " + meanings(o, "--hole-areas"))
          ->type_name("AREA..."),
      verb->add_option("--balance", o.shared.balance,
                       "To the disk or the sphere: weight of the areas against the angles, 0 (conformal) to 1; or a "
                       "weight per vertex, in an array or a file. " + meanings(o, "--balance"))
          ->type_name("T|ARRAY|FILE")};
}

}  // namespace

void addMap(CLI::App& app, Session& session) {
  auto o = std::make_shared<MapOptions>();
  CLI::App* verb = addVerb(app, session, mapHelp(*o));
  verb->add_option("METHOD", o->method, "How: " + oneOf(allMethods(*o)) + ".")->required();
  verb->add_option("SURFACE", o->surface, "The surface, in any format that authalic info reads.")->required();
  declareOutputs(verb, *o);
  declareShared(verb, *o);
  o->shared.space.declare(verb);
  for (const auto& family : o->families) family->declare(verb);
  verb->callback([o, &session] { runMap(*o, session); });
}

}  // namespace authalic::cli
