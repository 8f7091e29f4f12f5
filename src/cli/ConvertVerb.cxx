#include <memory>

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include "Files.h"
#include "Formats/VolumeFile.h"

namespace authalic::cli {
namespace {

struct ConvertOptions {
  std::string input, output, structure;
  std::vector<std::string> data, arrays;
  bool lps = false;
  SpaceOption space;
  VolumeOption volume;
};

VerbHelp convertHelp() {
  VerbHelp help;
  help.name = "convert";
  help.summary = "surfaces, per-vertex data and volumes between formats";
  help.synopsis = "convert INPUT OUTPUT [--data FILE...] [--array NAME...]";
  help.description =
      "INPUT is a surface, per-vertex data (with or without their surface) or a volume; what it is, is found from its "
      "content. The ending of OUTPUT decides the format:\n\n"
      "surfaces: .surf.gii, .vtp, .vtk, .ply, .stl, .off, .obj, .mz3, .patch.3d and .patch.flat; anything else is a "
      "FreeSurfer surface\n\n"
      "per-vertex data, arrays named with --array: .func.gii, .shape.gii, .label.gii, .annot, .label, .w, .mgh, .mgz, "
      ".txt, .curv, .thickness, .sulc, .area; anything else is FreeSurfer's curv where INPUT is per-vertex data\n\n"
      "volumes: .nii, .nii.gz, .mgh, .mgz; every frame unless --frame names one, numbers in the type they have where "
      "the format holds it\n\n"
      "Coordinates are written in scanner RAS when the space is known, in FreeSurfer's files in tkRAS when the volume "
      "geometry is. What the format has no room for is said on stderr, one sentence each.";
  help.examples = {
      "authalic convert lh.pial lh.pial.surf.gii",
      "authalic convert lh.white lh.white.vtp --data lh.thickness lh.aparc.annot\n  surface with two arrays",
      "authalic convert lh.pet.vtp lh.pet.func.gii --array PET",
      "authalic convert lh.thickness lh.thickness.shape.gii\n  per-vertex data without their surface",
      "authalic convert all.dscalar.nii lh.shape.gii --structure CortexLeft",
      "authalic convert lh.cortex.patch.flat lh.flat.surf.gii --whole lh.white",
      "authalic convert orig.mgz orig.nii.gz",
      "authalic convert t1.nii.gz t1.mgz --transform qform\n  where the two transforms of the file disagree",
      "authalic convert lh.white.vtp lh.white.ply --lps\n  for ITK and 3D Slicer"};
  return help;
}

void say(const Losses& losses, const ConvertOptions& o, const std::string& notRead, const Session& session) {
  if (session.quiet) return;
  if (!notRead.empty()) sayNote("not taken from " + o.input + ": " + notRead + ".");
  for (const std::string& loss : losses) sayNote("lost in " + o.output + ": " + loss);
}

void refuse(bool given, const std::string& option, const std::string& words) {
  if (given) throw Failure(UsageProblem, option + " " + words);
}

bool isVolumeName(const std::string& path) { return isNiftiName(path) || isMghName(path); }

/// What --space says of a volume without orientation.
void assertSpace(vtkImageData* volume, const ConvertOptions& o) {
  refuse(o.space.name != "stated" && o.space.name != "scanner-ras", "--space",
         "of a volume must be stated or scanner-ras; it is '" + o.space.name + "'.");
  if (o.space.name == "stated" || textField(volume, "CoordinateSpace") != "unknown") return;
  vtkNew<vtkStringArray> space;
  space->SetName("CoordinateSpace");
  space->InsertNextValue("scanner-ras");
  vtkNew<vtkIntArray> code;
  code->SetName("TransformCode");
  code->InsertNextValue(1);
  volume->GetFieldData()->AddArray(space);
  volume->GetFieldData()->AddArray(code);
}

void convertVolume(const ConvertOptions& o, const Session& session) {
  refuse(!o.data.empty() || !o.arrays.empty() || !o.structure.empty() || o.lps,
         "--data, --array, --structure and --lps", "belong to surfaces, but " + o.input + " is a volume.");
  if (!isVolumeName(o.output)) {
    throw Failure(FileProblem, o.input + ": a surface or per-vertex data are required to write " + o.output +
                                   ", but it is a volume; end the output in .nii, .nii.gz, .mgh or .mgz.");
  }
  VolumeOption wanted = o.volume;
  wanted.allFrames = !o.volume.frame;
  wanted.keepNumbers = true;
  const vtkSmartPointer<vtkImageData> volume = readVolume(o.input, session, wanted);
  assertSpace(volume, o);
  const int frames = static_cast<int>(numberField(volume, "Frames").value_or(1));
  const bool others = o.volume.frame && frames > 1;
  say(writeVolume(o.output, volume), o, others ? std::to_string(frames - 1) + " other frames" : "", session);
}

/// The arrays of a file of per-vertex data, without the values that go with a label.
std::vector<std::string> mainArrays(vtkPolyData* surface) {
  std::vector<std::string> names;
  vtkPointData* data = surface->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    const std::string name = data->GetArrayName(i);
    const std::string label = name.size() > 6 ? name.substr(0, name.size() - 6) : "";
    if (label.empty() || name != label + "Values" || !data->HasArray(label.c_str())) names.push_back(name);
  }
  return names;
}

bool isSurfaceName(const std::string& path) {
  for (const char* ending : {".vtp", ".vtk", ".ply", ".stl", ".off", ".obj", ".mz3", ".surf.gii", ".3d", ".flat"}) {
    const std::string end(ending);
    if (path.size() >= end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0) return true;
  }
  return false;
}

void convertVertexData(const ConvertOptions& o, const Session& session) {
  if (isSurfaceName(o.output)) {
    throw Failure(UsageProblem, o.input + ": a surface is required to write " + o.output +
                                    ", but it holds per-vertex data; give the surface first and these with --data.");
  }
  refuse(!o.data.empty() || o.lps, "--data and --lps",
         "belong to a surface, but " + o.input + " holds per-vertex data; give the surface first.");
  const ReadSurface read = readVertexData(nullptr, o.input, o.structure, "", session);
  const auto arrays = o.arrays.empty() ? mainArrays(read.surface) : o.arrays;
  say(writeVertexData(o.output, read.surface, arrays), o, read.notRead, session);
}

void convertSurface(const ConvertOptions& o, const Session& session) {
  ReadSurface read = readWholeSurface(o.input, session, o.space);
  std::vector<std::string> arrays = o.arrays;
  for (const std::string& path : o.data) {
    arrays.push_back(addVertexData(read.surface, path, "", session, o.structure));
  }
  refuse(o.lps && isDataFile(o.output), "--lps", "belongs to a surface, but " + o.output + " is per-vertex data.");
  const Losses losses = isDataFile(o.output) ? writeVertexData(o.output, read.surface, arrays)
                                             : writeSurface(o.output, read.surface, o.lps);
  say(losses, o, read.notRead, session);
}

void runConvert(const ConvertOptions& o, const Session& session) {
  requireWritable({o.output});
  const FileContent content = contentOfInput(o.input);
  if (content == FileContent::Volume) return convertVolume(o, session);
  refuse(o.volume.frame || o.volume.transform != VolumeOption().transform, "--frame and --transform",
         "belong to volumes, but " + o.input + " is none.");
  if (content == FileContent::VertexData) return convertVertexData(o, session);
  convertSurface(o, session);
}

}  // namespace

void addConvert(CLI::App& app, Session& session) {
  auto o = std::make_shared<ConvertOptions>();
  CLI::App* verb = addVerb(app, session, convertHelp());
  verb->add_option("INPUT", o->input, "A surface, per-vertex data or a volume.")->required();
  verb->add_option("OUTPUT", o->output, "What to write.")->required();
  verb->add_option("--data", o->data,
                   "Per-vertex data to add to a surface: morphometry, .annot, .label, .w, .mgh, GIFTI, "
                   "CIFTI, MZ3, text.")
      ->type_name("FILE...");
  verb->add_option("--array", o->arrays, "Arrays to write to a file of per-vertex data.")->type_name("NAME...");
  verb->add_option("--structure", o->structure, "Which surface of a CIFTI file: CortexLeft, CortexRight, ...")
      ->type_name("NAME");
  o->volume.declareFrame(verb);
  o->volume.declareTransform(verb);
  verb->add_flag("--lps", o->lps, "Write LPS coordinates, as ITK and 3D Slicer do: .vtp, .vtk, .ply, .obj, .stl.");
  o->space.declare(verb);
  verb->callback([o, &session] { runConvert(*o, session); });
}

}  // namespace authalic::cli
