#include <memory>

#include <vtkPolyData.h>

#include "Density.h"

namespace authalic::cli {
namespace {

struct DensityVerbOptions {
  std::string surface, output;
  DensityOptions density;
  SpaceOption space;
};

VerbHelp densityHelp() {
  VerbHelp help;
  help.name = "density";
  help.summary = "make the density of regions of interest or of curvature, to look at or to use in several maps";
  help.synopsis = "density SURFACE -o SURFACE.vtp [--roi REGION=FACTOR]... [--curvature-measure ...]";
  help.description =
      "Writes SURFACE with the cell array RegionDensity (or the point array CurvatureDensity), which a map takes as "
      "--measure. authalic map has the same options; this verb shows what they ask for.";
  help.examples = {
      "authalic density lh.disk.vtp -o lh.density.vtp --roi lh.aparc.annot:precentral=4 --roi-blend 5\n"
      "  four times the share for one gyrus, the density passing over 5 mm",
      "authalic map authalic lh.density.vtp -o lh.map.vtp --measure RegionDensity\n  a map with it"};
  help.references = {"Su et al. 2019, discrete Lie flow: a measure controllable parameterization method"};
  return help;
}

void runDensity(const DensityVerbOptions& o, const Session& session) {
  requireArrayFormat("--output", o.output);
  requireWritable({o.output});
  vtkSmartPointer<vtkPolyData> surface = readSurface(o.surface, session, o.space);
  if (o.density.apply(surface, session).empty()) {
    throw Failure(UsageProblem, "A density is required: give --roi REGION=FACTOR, --curvature-measure or --measure.");
  }
  sayRegions(surface, session);
  writeSurface(o.output, surface);
}

}  // namespace

void addDensity(CLI::App& app, Session& session) {
  auto o = std::make_shared<DensityVerbOptions>();
  CLI::App* verb = addVerb(app, session, densityHelp());
  verb->add_option("SURFACE", o->surface, "The surface, in any format that authalic info reads.")->required();
  verb->add_option("-o,--output", o->output, "The surface with the density.")->type_name("SURFACE.vtp")->required();
  o->density.declare(verb);
  o->space.declare(verb);
  verb->callback([o, &session] { runDensity(*o, session); });
}

}  // namespace authalic::cli
