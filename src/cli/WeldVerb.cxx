#include <memory>

#include <vtkConformalWelding.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "Files.h"

namespace authalic::cli {
namespace {

struct WeldOptions {
  std::string first, second, output, report, signature;
  bool asTheyAre = false;
};

VerbHelp weldHelp() {
  VerbHelp help;
  help.name = "weld";
  help.summary = "glue two maps to the unit disk into one map to the sphere";
  help.synopsis = "weld FIRST.vtp SECOND.vtp -o SPHERE.vtp [OPTIONS]";
  help.description =
      "FIRST and SECOND are maps to the unit disk (authalic map) of two surfaces that meet along their boundaries: the "
      "two halves of one cut. Boundary vertices at the same place are glued, or, with --signature, those with the same "
      "number. Conformal maps of the halves give a conformal map of the whole; authalic map welding cuts, maps "
      "and welds a closed surface by itself.\n\n"
      "SPHERE.vtp holds the closed surface on the unit sphere, vertices and faces of FIRST and then those that SECOND "
      "adds, with OriginalPoints, OriginalPointIds, OriginalCellIds, Disk and the arrays of every map.";
  help.examples = {"authalic weld upper.map.vtp lower.map.vtp -o sphere.vtp --report sphere.json",
                   "authalic weld upper.map.vtp lower.map.vtp -o sphere.vtp --signature OriginalPointIds\n"
                   "  both halves were cut along edges, and know their vertices in the whole"};
  help.references = {"Sharon and Mumford 2006; Marshall and Rohde 2007; Nadeem et al. 2017"};
  return help;
}

void runWeld(const WeldOptions& o, const Session& session) {
  requireArrayFormat("--output", o.output);
  requireWritable({o.output, o.report});
  vtkNew<vtkConformalWelding> welding;
  welding->SetInputData(0, readSurface(o.first, session, {}));
  welding->SetInputData(1, readSurface(o.second, session, {}));
  welding->SetSignatureArrayName(o.signature);
  welding->SetNormalise(!o.asTheyAre);
  update(welding.Get(), session);
  writeSurface(o.output, welding->GetOutput());
  if (!o.report.empty()) writeText(o.report, welding->GetReport());
}

}  // namespace

void addWeld(CLI::App& app, Session& session) {
  auto o = std::make_shared<WeldOptions>();
  CLI::App* verb = addVerb(app, session, weldHelp());
  verb->add_option("FIRST", o->first, "A map to the unit disk.")->required();
  verb->add_option("SECOND", o->second, "Another one; its boundary has as many vertices.")->required();
  verb->add_option("-o,--output", o->output, "The map to the sphere.")->type_name("SPHERE.vtp")->required();
  verb->add_option("--report", o->report, "Seconds, metrics, flips, mismatch along the seam, topology, version.")
      ->type_name("REPORT.json");
  verb->add_option("--signature", o->signature,
                   "Point array of both: boundary vertices with the same number are glued. Without it: those at the "
                   "same place.")
      ->type_name("ARRAY");
  verb->add_flag("--no-normalise", o->asTheyAre,
                 "Leave the centres of the disks at the poles; else the centre of mass goes to 0.");
  verb->callback([o, &session] { runWeld(*o, session); });
}

}  // namespace authalic::cli
