#include <memory>
#include <optional>
#include <sstream>

#include <vtkImageData.h>
#include <vtkLabelsOnSurface.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSampleVolumeOnSurface.h>

#include "Files.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> modes = {"at-vertex", "along-normal", "between-surfaces"};
const std::vector<std::string> reducers = {"mean", "median", "maximum", "minimum", "mode"};
const std::vector<std::string> interpolations = {"trilinear", "nearest"};

struct SampleOptions {
  std::string volume, surface, output, other, name, json;
  std::optional<std::string> mode, reducer, interpolation;
  std::vector<double> depths, fractions;
  std::optional<double> labels;
  bool skipZero = false;
  SpaceOption space;
  VolumeOption volumeOption;
};

VerbHelp sampleHelp() {
  VerbHelp help;
  help.name = "sample";
  help.summary = "read a volume at, below or between surfaces";
  help.synopsis = "sample VOLUME SURFACE -o OUT [OPTIONS]";
  help.description =
      "One number per vertex: at the vertex; reduced along the inward normal; or reduced between two surfaces. "
      "Outside the field of view, and where the volume has no data, the value is n/a (NaN), never 0; the array "
      "NAMECoverage says which part of the samples was valid. SURFACE may be a MAP.vtp: then the surface it came "
      "from is sampled.\n\n"
      "Both must be in scanner RAS mm. When a surface file does not state its space, say which it is with "
      "--space. OUT is a surface with the new arrays (.vtp), or the values alone (.func.gii, .shape.gii, "
      ".label.gii, .txt).";
  help.examples = {
      "authalic sample pet.nii.gz lh.map.vtp -o lh.pet.vtp --mode along-normal --name PET\n"
      "  mean over 0, 1, ... 10 mm below the surface",
      "authalic sample t1.mgz lh.white -o lh.t1.func.gii --mode between-surfaces --other lh.pial "
      "--fractions 0.2 0.8 0.1",
      "authalic sample aal.nii.gz lh.map.vtp -o lh.labelled.vtp --labels 5 --name AAL\n"
      "  label of the nearest labelled voxel within 5 mm"};
  help.references = {"Zou, Hu, Gu, Hua 2011 (mean along the normal within 10 mm)"};
  return help;
}

void setRange(const std::vector<double>& range, const char* option,
              const std::function<void(double, double, double)>& set) {
  if (range.empty()) return;
  if (range.size() != 3) throw Failure(UsageProblem, std::string(option) + " needs three numbers: FROM TO STEP.");
  set(range[0], range[1], range[2]);
}

vtkSmartPointer<vtkPolyData> sampled(const SampleOptions& o, const Session& session, vtkPolyData* surface,
                                     vtkImageData* volume) {
  vtkNew<vtkSampleVolumeOnSurface> sample;
  sample->SetInputData(0, surface);
  sample->SetInputData(1, volume);
  if (o.other.empty() && o.mode == modes[2]) {
    throw Failure(UsageProblem, "--mode between-surfaces needs --other: the other surface, with the same vertices.");
  }
  if (!o.other.empty()) sample->SetInputData(2, readSurface(o.other, session, o.space));
  if (o.mode) sample->SetMode(choice("--mode", *o.mode, modes));
  if (o.reducer) sample->SetReducer(choice("--reducer", *o.reducer, reducers));
  if (o.interpolation) sample->SetInterpolation(choice("--interpolation", *o.interpolation, interpolations));
  setRange(o.depths, "--depths", [&sample](double from, double to, double step) {
    sample->SetDepthFrom(from);
    sample->SetDepthTo(to);
    sample->SetDepthStep(step);
  });
  setRange(o.fractions, "--fractions", [&sample](double from, double to, double step) {
    sample->SetFractionFrom(from);
    sample->SetFractionTo(to);
    sample->SetFractionStep(step);
  });
  sample->SetSkipZero(o.skipZero);
  if (!o.name.empty()) sample->SetArrayName(o.name);
  update(sample.Get(), session);
  return sample->GetOutput();
}

vtkSmartPointer<vtkPolyData> labelled(const SampleOptions& o, const Session& session, vtkPolyData* surface,
                                      vtkImageData* volume) {
  vtkNew<vtkLabelsOnSurface> labels;
  labels->SetInputData(0, surface);
  labels->SetInputData(1, volume);
  labels->SetMaximumDistance(*o.labels);
  if (!o.name.empty()) labels->SetArrayName(o.name);
  update(labels.Get(), session);
  return labels->GetOutput();
}

void runSample(const SampleOptions& o, const Session& session) {
  requireWritable({o.output, o.json});
  const vtkSmartPointer<vtkPolyData> surface = readSurface(o.surface, session, o.space);
  requireScannerSpace(surface, o.surface, "state it with --space scanner-ras or --space tkras.");
  const vtkSmartPointer<vtkImageData> volume = readVolume(o.volume, session, o.volumeOption);
  requireScannerSpace(volume, o.volume, "give the file an sform or a qform.");
  const vtkSmartPointer<vtkPolyData> result =
      o.labels ? labelled(o, session, surface, volume) : sampled(o, session, surface, volume);
  const std::string name = !o.name.empty() ? o.name : o.labels ? "Label" : "Sample";
  writeSurfaceOrData(o.output, result, {name});
  writeJson(o.json, fieldsAsJson(result));
}

std::string triple(double from, double to, double step) {
  std::ostringstream out;
  out << from << " " << to << " " << step;
  return out.str();
}

}  // namespace

void addSample(CLI::App& app, Session& session) {
  auto o = std::make_shared<SampleOptions>();
  vtkNew<vtkSampleVolumeOnSurface> defaults;
  const auto nameOf = [](const std::vector<std::string>& names, int i) { return names[static_cast<std::size_t>(i)]; };
  CLI::App* verb = addVerb(app, session, sampleHelp());
  verb->add_option("VOLUME", o->volume, "NIfTI or MGH volume.")->required();
  verb->add_option("SURFACE", o->surface, "Surface or MAP.vtp.")->required();
  verb->add_option("-o,--output", o->output, "Surface with the new arrays, or the values alone.")
      ->type_name("OUT")
      ->required();
  verb->add_option("--mode", o->mode, "Where: " + oneOf(modes) + ".")
      ->type_name("MODE")
      ->default_str(nameOf(modes, defaults->GetMode()));
  verb->add_option("--reducer", o->reducer, "How samples become one number: " + oneOf(reducers) + ".")
      ->type_name("NAME")->default_str(nameOf(reducers, defaults->GetReducer()));
  verb->add_option("--interpolation", o->interpolation, "Between voxels: " + oneOf(interpolations) + ".")
      ->type_name("NAME")->default_str(nameOf(interpolations, defaults->GetInterpolation()));
  verb->add_option("--depths", o->depths, "Along the inward normal, mm.")->type_name("FROM TO STEP")->expected(3)
      ->default_str(triple(defaults->GetDepthFrom(), defaults->GetDepthTo(), defaults->GetDepthStep()));
  verb->add_option("--fractions", o->fractions, "Between the surfaces: 0 = SURFACE, 1 = the other.")
      ->type_name("FROM TO STEP")
      ->expected(3)
      ->default_str(triple(defaults->GetFractionFrom(), defaults->GetFractionTo(), defaults->GetFractionStep()));
  verb->add_option("--other", o->other, "The other surface, same vertices (between-surfaces).")->type_name("SURFACE");
  verb->add_option("--labels", o->labels,
                   "VOLUME holds labels: take the nearest labelled voxel within so many mm, up to 50.")
      ->type_name("MM");
  verb->add_flag("--skip-zero", o->skipZero, "A sample of exactly 0 is background and counts as n/a.");
  verb->add_option("--name", o->name, "Name of the array.")->type_name("NAME")->default_str(defaults->GetArrayName());
  verb->add_option("--json", o->json, "Counts, and everything the surface says about itself.")->type_name("FILE");
  o->space.declare(verb);
  o->volumeOption.declareFrame(verb);
  o->volumeOption.declareTransform(verb);
  verb->callback([o, &session] { runSample(*o, session); });
}

}  // namespace authalic::cli
