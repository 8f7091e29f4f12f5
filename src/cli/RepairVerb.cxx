#include <cstdio>
#include <memory>
#include <optional>
#include <sstream>

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSurfaceRepair.h>

#include "Files.h"

namespace authalic::cli {
namespace {

struct RepairOptions {
  std::string input, output, json;
  std::optional<double> hole, handle, share, tolerance;
  bool keepSeams = false, dryRun = false;
  SpaceOption space;
};

VerbHelp repairHelp() {
  VerbHelp help;
  help.name = "repair";
  help.summary = "a clean oriented manifold from a broken surface, every change listed";
  help.synopsis = "repair SURFACE OUTPUT [--largest-hole MM] [--largest-handle MM] [--dry-run] [--json FILE]";
  help.description =
      "In rounds, until a round changes nothing: isolated vertices, degenerate and duplicate faces, seams of "
      "coincident boundary edges, T-junctions, non-manifold edges and vertices, stray components, flipped faces, small "
      "holes, and handles, which are cut along their shortest loop and capped. Points never move. One line per kind "
      "of change goes to stderr, with places; --json lists them. Repairing OUTPUT again changes nothing.\n\n"
      "OUTPUT (.vtp) has the arrays OriginalPointIds and OriginalCellIds, -1 where the repair made something new. A "
      "surface that cannot be repaired, because it is one-sided for instance, is refused with the reason (exit code "
      "3).";
  help.examples = {
      "authalic repair colon.vtk colon.vtp --json repair.json\n  handles are listed with place and length",
      "authalic repair soup.stl --dry-run\n  says what would be changed, writes no surface",
      "authalic repair scan.ply scan.vtp --largest-hole 20 --largest-handle 0\n"
      "  fills loops up to 20 mm, leaves handles alone"};
  help.references = {"Barequet and Sharir 1995, Filling gaps in the boundary of a polyhedron",
                     "Erickson and Whittlesey 2005, Greedy optimal homotopy and homology generators"};
  return help;
}

void sayChanges(const std::string& summary, bool dryRun) {
  std::istringstream lines(summary);
  for (std::string line; std::getline(lines, line);) {
    std::fprintf(stderr, "authalic: %s%s\n", dryRun ? "would be: " : "", line.c_str());
  }
  if (summary.empty())
    std::fprintf(stderr, "authalic: nothing to repair: points and triangles stay as they are, bit for bit\n");
}

int runRepair(const RepairOptions& o, const Session& session) {
  if (o.output.empty() && !o.dryRun) {
    throw Failure(UsageProblem, "repair needs an OUTPUT to write, or --dry-run to write none.");
  }
  requireWritable({o.dryRun ? std::string() : o.output, o.json});
  const vtkSmartPointer<vtkPolyData> surface = readSurface(o.input, session, o.space);
  vtkNew<vtkSurfaceRepair> repair;
  if (o.keepSeams) repair->SewSeamsOff();
  if (o.tolerance) repair->SetJunctionTolerance(*o.tolerance);
  if (o.share) repair->SetStrayShare(*o.share);
  if (o.hole) repair->SetLargestHole(*o.hole);
  if (o.handle) repair->SetLargestHandle(*o.handle);
  repair->SetInputData(surface);
  const int code = update(repair.Get(), session);
  sayChanges(repair->GetSummary(), o.dryRun);
  if (!o.dryRun) writeSurface(o.output, repair->GetOutput());
  OrderedJson json;
  json["file"] = o.input;
  json["dry_run"] = o.dryRun;
  json.update(OrderedJson::parse(repair->GetReport()));
  writeJson(o.json, json);
  return code;
}

std::string inWords(double value, const char* automatic) {
  std::ostringstream text;
  text << value;
  return value < 0 ? automatic : text.str();
}

}  // namespace

void addRepair(CLI::App& app, Session& session) {
  auto o = std::make_shared<RepairOptions>();
  vtkNew<vtkSurfaceRepair> defaults;
  CLI::App* verb = addVerb(app, session, repairHelp());
  verb->add_option("SURFACE", o->input, "Triangles, however broken.")->required();
  verb->add_option("OUTPUT", o->output, "The repaired surface; not needed with --dry-run.");
  verb->add_flag("--dry-run", o->dryRun, "Say what would be changed and write no surface.");
  verb->add_option("--largest-hole", o->hole, "Boundary loops up to this length are filled, mm; 0 = none.")
      ->type_name("MM")->check(notNegative())
      ->default_str(inWords(defaults->GetLargestHole(), "a tenth of the square root of the area"));
  verb->add_option("--largest-handle", o->handle,
                   "Handles whose shortest loop is at most this long are cut, mm; 0 = none.")
      ->type_name("MM")->check(notNegative())->default_str(inWords(defaults->GetLargestHandle(), "all"));
  verb->add_option("--stray-share", o->share,
                   "Components with less than this fraction of the largest one's area are removed.")
      ->type_name("X")->check(CLI::Range(0.0, 1.0))->default_str(inWords(defaults->GetStrayShare(), ""));
  verb->add_option("--junction-tolerance", o->tolerance,
                   "Boundary vertices closer to a boundary edge than this fraction of its length are T-junctions.")
      ->type_name("X")->check(CLI::Range(0.0, 0.1))->default_str(inWords(defaults->GetJunctionTolerance(), ""));
  verb->add_flag("--keep-seams", o->keepSeams, "Leave boundary edges apart that lie on each other.");
  verb->add_option("--json", o->json, "Every change with ids, place and size, and the topology of the result.")
      ->type_name("FILE");
  o->space.declare(verb);
  verb->callback([o, &session] {
    const int code = runRepair(*o, session);
    if (code != Success) throw Failure(code, "The repair still made changes in its last round; it was written.");
  });
}

}  // namespace authalic::cli
