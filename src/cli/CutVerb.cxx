#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include <vtkCutToDisk.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include "Files.h"

namespace authalic::cli {
namespace {

struct CutOptions {
  std::string surface, output, region, json;
  std::vector<std::string> values;
  std::vector<double> plane;
  std::optional<int> smoothing;
  bool keep = false, allRegions = false;
  SpaceOption space;
};

VerbHelp cutHelp() {
  VerbHelp help;
  help.name = "cut";
  help.summary = "open a closed surface to a disk by removing a region";
  help.synopsis = "cut SURFACE -o DISK [--region ARRAY|FILE [--values LABEL...] [--keep] | --plane X Y Z NX NY NZ]";
  help.description =
      "Removes the faces that touch the region (the medial wall) and keeps the largest piece, as a topological "
      "disk: what the region encloses goes with it, and the rim is smoothed. DISK (.vtp) keeps the order of "
      "vertices and faces and has the point array OriginalPointIds.";
  help.examples = {
      "authalic cut surfaces/lh.white.vtp -o lh.disk.vtp\n"
      "  removes the array MedialWall that authalic extract made",
      "authalic cut lh.pial -o lh.disk.vtp --region lh.cortex.label --keep\n  keeps FreeSurfer's cortex label",
      "authalic cut lh.pial -o lh.disk.vtp --region lh.aparc.annot --values unknown corpuscallosum\n"
      "  removes two regions of an annotation",
      "authalic cut ball.off -o cap.vtp --plane 0 0 0 0 0 -1\n  removes what lies below z = 0"};
  return help;
}

/// The id of a region: a number, or a name in the table that came with the array.
int regionId(vtkPolyData* surface, const std::string& array, const std::string& value) {
  int id = 0;
  if (CLI::detail::lexical_cast(value, id)) return id;
  auto* names = vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray((array + "Names").c_str()));
  vtkDataArray* ids = surface->GetFieldData()->GetArray((array + "Ids").c_str());
  for (vtkIdType i = 0; names && ids && i < names->GetNumberOfValues(); ++i) {
    if (names->GetValue(i) == value) return static_cast<int>(ids->GetComponent(i, 0));
  }
  throw Failure(UsageProblem,
                "--values needs label numbers or names of regions of '" + array + "'; '" + value + "' is neither.");
}

void runCut(const CutOptions& o, const Session& session) {
  requireWritable({o.output, o.json});
  vtkSmartPointer<vtkPolyData> surface = readSurface(o.surface, session, o.space);
  vtkNew<vtkCutToDisk> cut;
  if (!o.plane.empty()) {
    cut->SetRegionModeToPlane();
    cut->SetPlaneOrigin(o.plane[0], o.plane[1], o.plane[2]);
    cut->SetPlaneNormal(o.plane[3], o.plane[4], o.plane[5]);
  }
  if (!o.region.empty()) cut->SetRegionArrayName(arrayOf(surface, o.region, session));
  for (const std::string& value : o.values) cut->AddRegionValue(regionId(surface, cut->GetRegionArrayName(), value));
  cut->SetKeepRegion(o.keep);
  if (o.allRegions) cut->LargestRegionOnlyOff();
  if (o.smoothing) cut->SetLoopSmoothing(*o.smoothing);
  cut->SetInputData(surface);
  update(cut.Get(), session);
  writeSurface(o.output, cut->GetOutput());
  writeJson(o.json, fieldsAsJson(cut->GetOutput()));
}

}  // namespace

void addCut(CLI::App& app, Session& session) {
  auto o = std::make_shared<CutOptions>();
  vtkNew<vtkCutToDisk> defaults;
  CLI::App* verb = addVerb(app, session, cutHelp());
  verb->add_option("SURFACE", o->surface, "A closed surface of genus 0.")->required();
  verb->add_option("-o,--output", o->output, "The disk.")->type_name("DISK")->required();
  CLI::Option* region =
      verb->add_option("--region", o->region,
                       "What to remove: a point array of SURFACE, or a file (.annot, .label, .label.gii, text).")
          ->type_name("ARRAY|FILE")
          ->default_str(defaults->GetRegionArrayName());
  verb->add_option(
          "--values", o->values,
          "Labels (numbers, or names of an annotation) that form the region; without it, every label but 0.")
      ->type_name("LABEL...");
  verb->add_flag("--keep", o->keep, "The region is what to keep.");
  verb->add_option("--plane", o->plane, "Remove the side of a plane: a point and the normal towards that side, mm.")
      ->type_name("X Y Z NX NY NZ")->expected(6)->excludes(region);
  verb->add_flag("--all-regions", o->allRegions, "Remove every connected piece of the region, not only the largest.");
  verb->add_option("--smoothing", o->smoothing, "Averaging passes that take spikes and bays off the rim.")
      ->type_name("N")->check(notNegative())->default_str(std::to_string(defaults->GetLoopSmoothing()));
  verb->add_option("--json", o->json, "Areas, loop length and counts.")->type_name("FILE");
  o->space.declare(verb);
  verb->callback([o, &session] { runCut(*o, session); });
}

}  // namespace authalic::cli
