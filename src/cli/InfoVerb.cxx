#include <cstdio>
#include <memory>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSurfaceTopologyReport.h>

#include "FileInfo.h"
#include "Files.h"

namespace authalic::cli {
namespace {

struct InfoOptions {
  std::string surface, json;
  SpaceOption space;
  VolumeOption volume;
};

VerbHelp infoHelp() {
  VerbHelp help;
  help.name = "info";
  help.summary = "what a file is: topology, size, space, defects; voxels and values";
  help.synopsis = "info FILE [--json FILE]";
  help.description =
      "Of a surface, prints vertices, edges, faces, the Euler characteristic, genus, components and boundary "
      "loops with their "
      "lengths in mm, area in mm², bounding box, the space of the coordinates and how it was decided, and "
      "every "
      "kind of defect with places. Defects are not an error: the exit code is 0 for any surface that can be "
      "read.\n\n"
      "Of a volume, prints voxels, values, axes, the affine, its space and how it was decided, and what is "
      "doubtful "
      "about it (an sform and a qform that disagree). Of per-vertex data, prints arrays, ranges, regions and "
      "surfaces.";
  help.examples = {"authalic info lh.pial\n  prints the report of a FreeSurfer surface",
                   "authalic info cow.obj --json cow.json\n  also writes every defect with its place",
                   "authalic info t1.nii.gz\n  where its voxels are, and which transform said so"};
  return help;
}

int count(vtkPolyData* surface, const char* name) { return static_cast<int>(numberField(surface, name).value_or(0)); }

void printLoops(vtkPolyData* surface) {
  vtkDataArray* lengths = surface->GetFieldData()->GetArray("LoopLengths");
  std::printf("boundary loops     %d", count(surface, "BoundaryLoops"));
  for (vtkIdType i = 0; lengths && i < lengths->GetNumberOfTuples() && i < 8; ++i) {
    std::printf("%s%.4g mm", i == 0 ? ": " : ", ", lengths->GetComponent(i, 0));
  }
  std::printf("%s\n", lengths && lengths->GetNumberOfTuples() > 8 ? ", ..." : "");
}

void printPlaces(vtkPolyData* surface, const char* kind, vtkDataArray* flags, bool cells) {
  int shown = 0;
  for (vtkIdType i = 0; flags && i < flags->GetNumberOfTuples(); ++i) {
    if (flags->GetComponent(i, 0) == 0) continue;
    if (++shown > 5) {
      std::printf("  ... (all places: --json)\n");
      return;
    }
    double p[6], bounds[6];
    surface->GetPoint(cells ? 0 : i, p);
    if (cells) {
      surface->GetCellBounds(i, bounds);
      for (int k = 0; k < 3; ++k) p[k] = 0.5 * (bounds[2 * k] + bounds[2 * k + 1]);
    }
    std::printf("  %s %lld at (%.2f, %.2f, %.2f) mm\n", kind, static_cast<long long>(i), p[0], p[1], p[2]);
  }
}

void printReport(vtkPolyData* surface, const std::string& path, const std::string& summary) {
  const double* b = surface->GetBounds();
  std::printf("file               %s\n", path.c_str());
  std::printf("summary            %s\n", summary.c_str());
  std::printf("vertices           %d\nedges              %d\nfaces              %d\n", count(surface, "VertexCount"),
              count(surface, "EdgeCount"), count(surface, "FaceCount"));
  std::printf("Euler number       %d\n", count(surface, "EulerCharacteristic"));
  if (count(surface, "Genus") >= 0) std::printf("genus              %d\n", count(surface, "Genus"));
  else std::printf("genus              n/a (not an oriented manifold)\n");
  std::printf("components         %d\n", count(surface, "Components"));
  printLoops(surface);
  std::printf("area               %.6g mm^2\n", numberField(surface, "SurfaceArea").value_or(0));
  if (count(surface, "BoundaryLoops") == 0) {
    std::printf("volume             %.6g mm^3\n", numberField(surface, "EnclosedVolume").value_or(0));
  }
  std::printf("bounding box       (%.3f, %.3f, %.3f) to (%.3f, %.3f, %.3f) mm\n", b[0], b[2], b[4], b[1], b[3], b[5]);
  std::printf("space              %s (%s)\n", textField(surface, "CoordinateSpace").c_str(),
              textField(surface, "CoordinateSpaceReason").c_str());
  const std::pair<const char*, const char*> defects[] = {
      {"NonManifoldEdges", "non-manifold edges"},   {"InconsistentEdges", "inconsistent edges"},
      {"NonManifoldVertices", "non-manifold points"}, {"IsolatedVertices", "isolated vertices"},
      {"DegenerateFaces", "degenerate faces"},      {"DuplicateFaces", "duplicate faces"}};
  for (const auto& [field, words] : defects) {
    if (count(surface, field) > 0) std::printf("%-19s%d\n", words, count(surface, field));
  }
  printPlaces(surface, "vertex", surface->GetPointData()->GetArray("Defect"), false);
  printPlaces(surface, "face", surface->GetCellData()->GetArray("Defect"), true);
}

void runInfo(const InfoOptions& options, const Session& session) {
  requireWritable({options.json});
  const FileContent content = contentOfInput(options.surface);
  const bool loosePatch = content == FileContent::Patch && options.space.whole.empty();
  if (content == FileContent::Volume || content == FileContent::VertexData || loosePatch) {
    const OrderedJson info = loosePatch                        ? patchInfo(options.surface)
                             : content == FileContent::Volume ? volumeInfo(options.surface, options.volume, session)
                                                              : vertexDataInfo(options.surface, session);
    writeJson(options.json, info);
    printInfo(info);
    return;
  }
  const vtkSmartPointer<vtkPolyData> surface = readSurface(options.surface, session, options.space);
  vtkNew<vtkSurfaceTopologyReport> report;
  report->SetInputData(surface);
  update(report.Get(), session);
  OrderedJson json;
  json["file"] = options.surface;
  json["space"] = textField(surface, "CoordinateSpace");
  json["space_reason"] = textField(surface, "CoordinateSpaceReason");
  json.update(OrderedJson::parse(report->GetReport()));
  writeJson(options.json, json);
  printReport(report->GetOutput(), options.surface, report->GetSummary());
}

}  // namespace

void addInfo(CLI::App& app, Session& session) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* verb = addVerb(app, session, infoHelp());
  verb->add_option("FILE", options->surface,
                   "Surface (FreeSurfer, GIFTI, MZ3, OFF, OBJ, PLY, STL, VTK, VTP), per-vertex data or volume.")
      ->required();
  verb->add_option("--json", options->json, "Writes the report with every defect and its place.")->type_name("FILE");
  options->space.declare(verb);
  options->volume.declareFrame(verb);
  options->volume.declareTransform(verb);
  verb->callback([options, &session] { runInfo(*options, session); });
}

}  // namespace authalic::cli
