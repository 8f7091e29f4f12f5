#include <memory>

#include <vtkPolyData.h>

#include "Files.h"

namespace authalic::cli {
namespace {

struct ConvertOptions {
  std::string input, output;
  std::vector<std::string> data, arrays;
  SpaceOption space;
};

VerbHelp convertHelp() {
  VerbHelp help;
  help.name = "convert";
  help.summary = "surfaces and per-vertex data between formats";
  help.synopsis = "convert INPUT OUTPUT [--data FILE...] [--array NAME...]";
  help.description =
      "The ending of OUTPUT decides: .surf.gii, .vtp, .vtk, .ply, .stl, .off, .obj, anything else is a "
      "FreeSurfer surface; .func.gii, .shape.gii, .label.gii and .txt take the arrays named with --array. "
      "Coordinates are written in scanner RAS when the space is known.";
  help.examples = {
      "authalic convert lh.pial lh.pial.surf.gii",
      "authalic convert lh.white lh.white.vtp --data lh.thickness lh.aparc.annot\n  surface with two arrays",
      "authalic convert lh.pet.vtp lh.pet.func.gii --array PET"};
  return help;
}

void runConvert(const ConvertOptions& o, const Session& session) {
  requireWritable({o.output});
  vtkSmartPointer<vtkPolyData> surface = readSurface(o.input, session, o.space);
  std::vector<std::string> arrays = o.arrays;
  for (const std::string& path : o.data) arrays.push_back(addVertexData(surface, path, "", session));
  writeSurfaceOrData(o.output, surface, arrays);
}

}  // namespace

void addConvert(CLI::App& app, Session& session) {
  auto o = std::make_shared<ConvertOptions>();
  CLI::App* verb = addVerb(app, session, convertHelp());
  verb->add_option("INPUT", o->input, "A surface.")->required();
  verb->add_option("OUTPUT", o->output, "What to write.")->required();
  verb->add_option("--data", o->data, "Per-vertex data to add: morphometry, .annot, .label, GIFTI, text.")
      ->type_name("FILE...");
  verb->add_option("--array", o->arrays, "Arrays to write to a file of per-vertex data.")->type_name("NAME...");
  o->space.declare(verb);
  verb->callback([o, &session] { runConvert(*o, session); });
}

}  // namespace authalic::cli
