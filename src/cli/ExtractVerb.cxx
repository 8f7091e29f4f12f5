#include <filesystem>
#include <memory>
#include <optional>

#include <vtkCorticalSurface.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "Files.h"
#include "Formats/VolumeFile.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> conventions = {"aal", "freesurfer"};
const std::vector<std::string> formats = {"vtp", "gii", "freesurfer"};

struct ExtractOptions {
  std::string t1, output, labels, convention = "aal", format = "vtp", json;
  std::optional<int> faces, smoothing;
  std::optional<double> sealing, threshold;
  VolumeOption volume;
};

VerbHelp extractHelp() {
  VerbHelp help;
  help.name = "extract";
  help.summary = "white surfaces of both hemispheres from a T1 volume";
  help.synopsis = "extract T1 -o FOLDER [--labels VOLUME] [OPTIONS]";
  help.description =
      "Segments white matter, fills ventricles and subcortical grey matter, takes cerebellum and brainstem away, "
      "splits the hemispheres and makes a closed surface of genus 0 of each, by construction. Without --labels "
      "the T1 must be skull-stripped. Leaves FOLDER/lh.white.vtp and FOLDER/rh.white.vtp (or .surf.gii, or "
      "FreeSurfer's lh.white) in scanner RAS mm; .vtp also has the point array MedialWall, which authalic cut "
      "takes.";
  help.examples = {"authalic extract ch2better.nii.gz --labels aal.nii.gz -o surfaces",
                   "authalic extract brain.mgz --labels aparc+aseg.mgz --convention freesurfer -o surfaces --faces 0\n"
                   "  keeps every triangle"};
  help.references = {"Dale, Fischl, Sereno 1999; Bertrand 1994; Han et al. 2003"};
  return help;
}

const std::vector<std::string> endings = {".vtp", ".surf.gii", ""};  // of each format

std::string surfaceName(const ExtractOptions& o, const std::string& side, const std::string& ending) {
  return o.output + "/" + side + ".white" + ending;
}

/// The folder may be missing still; then so are the files in it.
void requireTargets(const ExtractOptions& o, const std::string& ending) {
  namespace fs = std::filesystem;
  requireFolder(o.output);
  const bool exists = fs::is_directory(o.output);
  const fs::path folder = fs::absolute(o.output + "/").lexically_normal();
  const bool jsonInside = !o.json.empty() && (fs::absolute(o.json).parent_path() / "").lexically_normal() == folder;
  if (exists) requireWritable({surfaceName(o, "lh", ending), surfaceName(o, "rh", ending), o.json});
  else if (!jsonInside) requireWritable({o.json});
}

void runExtract(const ExtractOptions& o, const Session& session) {
  const std::string ending = endings[static_cast<std::size_t>(choice("--format", o.format, formats))];
  requireTargets(o, ending);
  const vtkSmartPointer<vtkImageData> t1 = readVolume(o.t1, session, o.volume);
  vtkNew<vtkCorticalSurface> extract;
  extract->SetInputData(0, t1);
  const VolumeOption ofLabels = isNiftiName(o.labels) ? o.volume : VolumeOption();
  if (!o.labels.empty()) extract->SetInputData(1, readVolume(o.labels, session, ofLabels));
  extract->SetLabelConvention(choice("--convention", o.convention, conventions));
  if (o.faces) extract->SetTargetFaces(*o.faces);
  if (o.smoothing) extract->SetSmoothingIterations(*o.smoothing);
  if (o.sealing) extract->SetSealing(*o.sealing);
  if (o.threshold) extract->SetThreshold(*o.threshold);
  update(extract.Get(), session);
  std::error_code failed;
  std::filesystem::create_directories(o.output, failed);
  if (failed) throw Failure(FileProblem, o.output + ": the folder cannot be made (" + failed.message() + ").");
  OrderedJson json;
  for (const int port : {0, 1}) {
    const std::string side = port == 0 ? "lh" : "rh";
    writeSurface(surfaceName(o, side, ending), extract->GetOutput(port));
    json[side] = fieldsAsJson(extract->GetOutput(port));
  }
  writeJson(o.json, json);
}

}  // namespace

void addExtract(CLI::App& app, Session& session) {
  auto o = std::make_shared<ExtractOptions>();
  vtkNew<vtkCorticalSurface> defaults;
  CLI::App* verb = addVerb(app, session, extractHelp());
  verb->add_option("T1", o->t1, "NIfTI or MGH volume.")->required();
  verb->add_option("-o,--output", o->output, "Folder for the surfaces; made when missing.")
      ->type_name("FOLDER")
      ->required();
  verb->add_option("--labels", o->labels, "Region labels on any grid.")->type_name("VOLUME");
  verb->add_option("--convention", o->convention, "What the labels mean: " + oneOf(conventions) + ".")
      ->type_name("NAME")->capture_default_str();
  verb->add_option("--faces", o->faces, "Triangles per hemisphere after decimation; 0 = no decimation.")
      ->type_name("N")->check(notNegative())->default_str(std::to_string(defaults->GetTargetFaces()));
  verb->add_option("--smoothing", o->smoothing, "Pairs of volume-preserving smoothing steps, 0 to 1000.")
      ->type_name("N")->default_str(std::to_string(defaults->GetSmoothingIterations()));
  verb->add_option("--sealing", o->sealing, "Tunnels up to about twice this many voxels wide are sealed, 0 to 5.")
      ->type_name("VOXELS")->default_str(std::to_string(static_cast<int>(defaults->GetSealing())));
  verb->add_option("--threshold", o->threshold, "Grey-white threshold in units of the T1; 0 = from the histogram.")
      ->type_name("X")->default_str("0");
  verb->add_option("--format", o->format, "Format of the surfaces: " + oneOf(formats) + ".")
      ->type_name("NAME")->capture_default_str();
  verb->add_option("--json", o->json, "Areas, volumes, thresholds and counts.")->type_name("FILE");
  o->volume.declareTransform(verb);
  verb->callback([o, &session] { runExtract(*o, session); });
}

}  // namespace authalic::cli
