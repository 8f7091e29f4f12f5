#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>

#include <vtkDataArray.h>
#include <vtkElementGrid.h>
#include <vtkElementStatistics.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include "Files.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> frames = {"automatic", "unit-disk", "bounding-box"};

struct ElementsOptions {
  std::string map, output, regions, labels, labelNames, hemisphere, grid, surface, json;
  std::vector<std::string> fields;
  std::optional<int> elements;
  std::optional<double> area, mergeBelow;
  std::optional<std::string> frame;
};

VerbHelp elementsHelp() {
  VerbHelp help;
  help.name = "elements";
  help.summary = "cortical elements of equal area, and statistics on them";
  help.synopsis = "elements MAP -o ELEMENTS.tsv [OPTIONS]";
  help.description =
      "Lays an isotropic grid on the image of an area-preserving map; the preimage of a cell is an element. "
      "Faces that straddle a line are split exactly. ELEMENTS.tsv has one row per element: id, area in mm², "
      "centroid, majority label, and n, mean, sd, median, min, max and coverage of every field, weighted by "
      "area; ELEMENTS.json describes the columns.\n\n"
      "Fields are the arrays that authalic sample left on MAP (those with a Coverage array), or those named with "
      "--field.";
  help.examples = {"authalic elements lh.pet.vtp -o lh.elements.tsv --elements 400 --hemi L",
                   "authalic elements lh.pet.vtp -o lh.elements.tsv --labels AAL --label-names aal.txt "
                   "--regions lh.regions.tsv --grid lh.grid.vtp"};
  help.references = {"Zou, Hu, Gu, Hua 2011 (cortical elements)"};
  return help;
}

/// "12 Name ..." per line; # starts a comment.
void addNamedRegions(vtkElementStatistics* statistics, const std::string& path) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path)) {
    throw Failure(FileProblem, path + ": a text file of label numbers and names is required; it cannot be read.");
  }
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    int id = 0;
    std::string name;
    if (words >> id >> name && id != 0) statistics->AddRegion(id, name);
  }
}

void addTableRegions(vtkElementStatistics* statistics, vtkPolyData* map, const std::string& array) {
  auto* names = vtkStringArray::SafeDownCast(map->GetFieldData()->GetAbstractArray((array + "Names").c_str()));
  vtkDataArray* ids = map->GetFieldData()->GetArray((array + "Ids").c_str());
  for (vtkIdType i = 0; names && ids && i < names->GetNumberOfValues(); ++i) {
    statistics->AddRegion(static_cast<int>(ids->GetComponent(i, 0)), names->GetValue(i));
  }
}

void setGrid(vtkElementGrid* grid, const ElementsOptions& o) {
  if (o.elements) grid->SetNumberOfElements(*o.elements);
  if (o.area) grid->SetElementArea(*o.area);
  if (o.mergeBelow) grid->SetMergeBelow(*o.mergeBelow);
  if (o.frame) grid->SetFrame(choice("--frame", *o.frame, frames));
}

/// Where the description of a table goes.
std::string sidecar(const std::string& table) {
  return table.empty() ? table : std::filesystem::path(table).replace_extension(".json").string();
}

void checkWritten(bool written, const std::string& path) {
  if (!written) throw Failure(FileProblem, path + ": the table cannot be written there.");
}

void runElements(const ElementsOptions& o, const Session& session) {
  if (!o.grid.empty()) requireArrayFormat("--grid", o.grid);
  requireWritable({o.output, sidecar(o.output), o.regions, sidecar(o.regions), o.grid, o.json});
  vtkSmartPointer<vtkPolyData> map = readSurface(o.map, session, SpaceOption());
  vtkNew<vtkElementStatistics> statistics;
  for (const std::string& field : o.fields) statistics->AddFieldArray(arrayOf(map, field, session));
  if (!o.labels.empty()) {
    statistics->SetLabelArrayName(arrayOf(map, o.labels, session));
    if (o.labelNames.empty()) addTableRegions(statistics, map, statistics->GetLabelArrayName());
    else addNamedRegions(statistics, o.labelNames);
  } else if (!o.regions.empty()) {
    throw Failure(UsageProblem,
                  "--regions needs --labels: the array or file that says which region a vertex belongs to.");
  }
  vtkNew<vtkElementGrid> grid;
  setGrid(grid, o);
  grid->SetInputData(map);
  update(grid.Get(), session);
  statistics->SetHemisphere(o.hemisphere);
  statistics->SetInputData(grid->GetOutput());
  update(statistics.Get(), session);
  checkWritten(statistics->WriteElements(o.output), o.output);
  if (!o.regions.empty()) checkWritten(statistics->WriteRegions(o.regions), o.regions);
  if (!o.grid.empty()) writeSurface(o.grid, grid->GetOutput());
  writeJson(o.json, fieldsAsJson(grid->GetOutput()));
}

}  // namespace

void addElements(CLI::App& app, Session& session) {
  auto o = std::make_shared<ElementsOptions>();
  vtkNew<vtkElementGrid> defaults;
  std::ostringstream merge;
  merge << defaults->GetMergeBelow();
  CLI::App* verb = addVerb(app, session, elementsHelp());
  verb->add_option("MAP", o->map, "A MAP.vtp of authalic map, with sampled arrays if any.")->required();
  verb->add_option("-o,--output", o->output, "One row per element; the description goes beside it as .json.")
      ->type_name("ELEMENTS.tsv")
      ->required();
  CLI::Option* count =
      verb->add_option("--elements", o->elements, "How many elements are wanted; the nearest grid is taken.")
          ->type_name("N")
          ->check(CLI::Range(1, 4000000))
          ->default_str(std::to_string(defaults->GetNumberOfElements()));
  verb->add_option("--area", o->area, "Wanted native area of an element, mm².")
      ->type_name("MM2")
      ->check(positive())
      ->excludes(count);
  verb->add_option("--frame", o->frame, "The rectangle that is divided: " + oneOf(frames) + ".")
      ->type_name("NAME")->default_str(frames[static_cast<std::size_t>(defaults->GetFrame())]);
  verb->add_option("--merge-below", o->mergeBelow,
                   "A cell covered by less than this fraction joins a neighbour, 0 to 0.5.")
      ->type_name("X")
      ->check(CLI::Range(0.0, 0.5))
      ->default_str(merge.str());
  verb->add_option("--field", o->fields, "Arrays of MAP, or files with one number per vertex.")
      ->type_name("ARRAY|FILE...");
  verb->add_option("--labels", o->labels, "Label per vertex: an array of MAP, or a file.")->type_name("ARRAY|FILE");
  verb->add_option("--label-names", o->labelNames, "Text file: number and name of a region per line.")
      ->type_name("FILE");
  verb->add_option("--regions", o->regions, "One row per region.")->type_name("REGIONS.tsv");
  verb->add_option("--hemi", o->hemisphere, "What the column hemi says: L or R.")
      ->type_name("L|R")
      ->check(CLI::IsMember({"L", "R"}));
  verb->add_option("--grid", o->grid, "The map with ElementId per vertex and face.")->type_name("MAP.vtp");
  verb->add_option("--json", o->json, "Grid and deviations of element areas.")->type_name("FILE");
  verb->callback([o, &session] { runElements(*o, session); });
}

}  // namespace authalic::cli
