#include "Files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkSurfaceFileReader.h>
#include <vtkSurfaceFileWriter.h>
#include <vtkVertexDataReader.h>
#include <vtkVertexDataWriter.h>
#include <vtkVolumeFileReader.h>
#include <vtkVolumeFileWriter.h>

#include "Core/base/Error.h"
#include "Formats/AtomicFile.h"
#include "Reports/Table.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> spaces = {"stated", "scanner-ras", "tkras", "lps", "voxel"};
const std::vector<std::string> transforms = {"automatic", "sform", "qform"};

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

std::string arrayNames(vtkPolyData* surface) {
  std::string names;
  for (vtkDataSetAttributes* data : {static_cast<vtkDataSetAttributes*>(surface->GetPointData()),
                                     static_cast<vtkDataSetAttributes*>(surface->GetCellData())}) {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
      if (data->GetArrayName(i)) names += (names.empty() ? "" : ", ") + std::string(data->GetArrayName(i));
    }
  }
  return names.empty() ? "none" : names;
}

template <class Writer>
Losses write(Writer* writer, const std::string& path, vtkDataObject* object) {
  writer->SetFileName(path.c_str());
  writer->SetInputData(object);
  runAlgorithm(writer, [writer] { writer->Write(); }, [writer] { return writer->GetErrorKind(); });
  Losses losses;
  for (int i = 0; i < writer->GetNumberOfLosses(); ++i) losses.emplace_back(writer->GetLoss(i));
  return losses;
}

}  // namespace

FileContent contentOfInput(const std::string& path) {
  try {
    return contentOf(path);
  } catch (const Error& e) {
    throw Failure(FileProblem, e.what());
  }
}

bool isDataFile(const std::string& path) {
  for (const char* ending : {".func.gii", ".shape.gii", ".label.gii", ".txt", ".curv", ".thickness", ".sulc", ".area",
                             ".annot", ".label", ".w", ".mgh", ".mgz"}) {
    if (endsWith(path, ending)) return true;
  }
  return false;
}

void SpaceOption::declare(CLI::App* verb) {
  verb->add_option("--space", name,
                   "Space of the surface's coordinates: what the file states, or stated by you: " + oneOf(spaces) +
                       ". tkras and voxel need the volume geometry, of --volume or in the file.")
      ->type_name("SPACE")
      ->capture_default_str();
  verb->add_option("--volume", volume, "The volume whose tkras or voxels the surface is in.")->type_name("FILE");
  verb->add_option("--whole", whole, "The surface that a FreeSurfer patch was cut from, which has its faces.")
      ->type_name("FILE");
}

ReadSurface readWholeSurface(const std::string& path, const Session& session, const SpaceOption& space) {
  vtkNew<vtkSurfaceFileReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetAssumeSpace(choice("--space", space.name, spaces));
  if (!space.volume.empty()) reader->SetVolumeFileName(space.volume.c_str());
  if (!space.whole.empty()) reader->SetWholeFileName(space.whole.c_str());
  update(reader.Get(), session);
  return {reader->GetOutput(), reader->GetNotRead()};
}

vtkSmartPointer<vtkPolyData> readSurface(const std::string& path, const Session& session, const SpaceOption& space) {
  return readWholeSurface(path, session, space).surface;
}

void VolumeOption::declareTransform(CLI::App* verb) {
  verb->add_option("--transform", transform,
                   "Which transform of a NIfTI volume places it: " + oneOf(transforms) +
                       ". Needed where the two put voxels elsewhere.")
      ->type_name("NAME")
      ->capture_default_str();
}

void VolumeOption::declareFrame(CLI::App* verb) {
  verb->add_option("--frame", frame, "Which frame of a volume of several, from 0.")
      ->type_name("N")
      ->check(notNegative());
}

namespace {

/// Refuses a volume whose two transforms put voxels more than half a voxel apart.
void requireOnePlace(vtkImageData* volume, const std::string& path) {
  const double apart = numberField(volume, "TransformDisagreement").value_or(0);
  const double* size = volume->GetSpacing();
  if (apart <= 0.5 * std::min({size[0], size[1], size[2]})) return;
  std::ostringstream words;
  words << path << ": one place is required, but the sform and the qform put voxels up to " << apart
        << " mm apart, over half a voxel; say which holds with --transform sform or --transform qform (authalic info "
           "shows both).";
  throw Failure(UsageProblem, words.str());
}

void requireOneFrame(vtkImageData* volume, const std::string& path) {
  const int frames = static_cast<int>(numberField(volume, "Frames").value_or(1));
  if (frames == 1) return;
  throw Failure(UsageProblem, path + ": a volume of one frame is required, but it has " + std::to_string(frames) +
                                  "; choose one with --frame 0 to " + std::to_string(frames - 1) + ".");
}

}  // namespace

vtkSmartPointer<vtkImageData> readVolume(const std::string& path, const Session& session, const VolumeOption& option) {
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetFrame(option.frame.value_or(0));
  reader->SetAllFrames(option.allFrames);
  reader->SetKeepNumbers(option.keepNumbers);
  reader->SetTransform(choice("--transform", option.transform, transforms));
  updateAlgorithm(reader, session, [&reader] { return reader->GetErrorKind(); });
  if (option.onlyWhatIsClear && option.transform == transforms[0]) requireOnePlace(reader->GetOutput(), path);
  if (option.onlyWhatIsClear && !option.frame && !option.allFrames) requireOneFrame(reader->GetOutput(), path);
  return reader->GetOutput();
}

ReadSurface readVertexData(vtkPolyData* surface, const std::string& path, const std::string& structure,
                           const std::string& arrayName, const Session& session) {
  vtkNew<vtkVertexDataReader> reader;
  if (surface) reader->SetInputData(surface);
  reader->SetFileName(path.c_str());
  if (!structure.empty()) reader->SetStructure(structure.c_str());
  if (!arrayName.empty()) reader->SetArrayName(arrayName.c_str());
  update(reader.Get(), session);
  return {reader->GetOutput(), reader->GetNotRead()};
}

std::string addVertexData(vtkSmartPointer<vtkPolyData>& surface, const std::string& path, const std::string& arrayName,
                          const Session& session, const std::string& structure) {
  const vtkSmartPointer<vtkPolyData> before = surface;
  surface = readVertexData(before, path, structure, arrayName, session).surface;
  vtkPointData* data = surface->GetPointData();
  if (!arrayName.empty() && data->HasArray(arrayName.c_str())) return arrayName;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {  // the first that is new, or took the place of one of its name
    const char* name = data->GetArrayName(i);
    if (name && data->GetAbstractArray(i) != before->GetPointData()->GetAbstractArray(name)) return name;
  }
  throw Failure(FileProblem, path + ": an array per vertex is required, but the file gave none.");
}

std::string arrayOf(vtkSmartPointer<vtkPolyData>& surface, const std::string& arrayOrFile, const Session& session) {
  if (surface->GetPointData()->HasArray(arrayOrFile.c_str()) || surface->GetCellData()->HasArray(arrayOrFile.c_str())) {
    return arrayOrFile;
  }
  std::error_code ignored;
  if (!std::filesystem::exists(arrayOrFile, ignored)) {
    const bool looksLikePath = arrayOrFile.find_first_of("./") != std::string::npos;
    throw Failure(looksLikePath ? FileProblem : UsageProblem,
                  arrayOrFile + ": the name of an array of the surface or of a file is required, but there is neither; "
                                "the surface has " + arrayNames(surface) + ".");
  }
  return addVertexData(surface, arrayOrFile, "", session);
}

void requireWritable(const std::vector<std::string>& paths) {
  std::set<std::string> seen;
  for (const std::string& path : paths) {
    if (path.empty()) continue;
    try {
      const AtomicFile probe(path);
    } catch (const Error& e) {
      throw Failure(FileProblem, e.what());
    }
    if (!seen.insert(std::filesystem::absolute(path).lexically_normal().string()).second) {
      throw Failure(UsageProblem, path + ": every output needs a name of its own, but two have this one.");
    }
  }
}

void requireArrayFormat(const std::string& option, const std::string& path) {
  if (endsWith(path, ".vtp") || endsWith(path, ".vtk")) return;
  throw Failure(UsageProblem, option + " must end in .vtp, which keeps the arrays of a map; it is '" + path + "'.");
}

void requireFolder(const std::string& path) {
  namespace fs = std::filesystem;
  if (path.empty()) throw Failure(UsageProblem, "The name of a folder is required, but it is empty.");
  std::error_code ignored;
  fs::path nearest = fs::absolute(path);
  while (!fs::exists(nearest, ignored) && nearest.has_relative_path()) nearest = nearest.parent_path();
  if (!fs::is_directory(nearest, ignored)) {
    throw Failure(FileProblem, path + ": a folder is required, but " + nearest.string() + " is a file.");
  }
  try {
    const AtomicFile probe((nearest / "authalic.probe").string());
  } catch (const Error&) {
    throw Failure(FileProblem, path + ": a folder that can be written to is required, but " + nearest.string() +
                                   " does not allow it.");
  }
}

Losses writeSurface(const std::string& path, vtkPolyData* surface, bool lps) {
  vtkNew<vtkSurfaceFileWriter> writer;
  if (lps) writer->SetWriteSpaceToLPS();
  return write(writer.Get(), path, surface);
}

Losses writeVertexData(const std::string& path, vtkPolyData* surface, const std::vector<std::string>& arrays) {
  vtkNew<vtkVertexDataWriter> writer;
  for (const std::string& array : arrays) writer->AddArrayName(array.c_str());
  return write(writer.Get(), path, surface);
}

Losses writeSurfaceOrData(const std::string& path, vtkPolyData* surface, const std::vector<std::string>& arrays) {
  return isDataFile(path) ? writeVertexData(path, surface, arrays) : writeSurface(path, surface);
}

Losses writeVolume(const std::string& path, vtkImageData* volume) {
  vtkNew<vtkVolumeFileWriter> writer;
  return write(writer.Get(), path, volume);
}

void writeText(const std::string& path, const std::string& text) {
  try {
    writeFileAtomically(path, text);
  } catch (const Error& e) {
    throw Failure(FileProblem, e.what());
  }
}

void writeJson(const std::string& path, const OrderedJson& json) {
  if (!path.empty()) writeText(path, json.dump(2) + "\n");
}

std::string textField(vtkDataObject* object, const char* name) {
  auto* array = vtkStringArray::SafeDownCast(object->GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() > 0 ? array->GetValue(0) : std::string();
}

std::optional<double> numberField(vtkDataObject* object, const char* name) {
  vtkDataArray* array = object->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfTuples() == 0) return std::nullopt;
  return array->GetComponent(0, 0);
}

OrderedJson fieldsAsJson(vtkDataObject* object) {
  OrderedJson result = OrderedJson::object();
  vtkFieldData* fields = object->GetFieldData();
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i) {
    vtkAbstractArray* array = fields->GetAbstractArray(i);
    OrderedJson values = OrderedJson::array();
    for (vtkIdType v = 0; v < array->GetNumberOfValues(); ++v) {
      const vtkVariant value = array->GetVariantValue(v);
      if (value.IsString()) values.push_back(std::string(value.ToString()));
      else if (value.IsFloat() || value.IsDouble()) values.push_back(value.ToDouble());
      else values.push_back(value.ToLongLong());
    }
    std::string key;
    for (const char c : std::string(array->GetName() ? array->GetName() : "field")) {
      if (std::isupper(static_cast<unsigned char>(c)) && !key.empty() &&
          std::islower(static_cast<unsigned char>(key.back()))) {
        key += '_';
      }
      key += c;
    }
    result[snakeCase(key)] = values.size() == 1 ? values[0] : values;
  }
  return result;
}

void requireScannerSpace(vtkDataObject* object, const std::string& path, const std::string& remedy) {
  if (textField(object, "CoordinateSpace") == "scanner-ras") return;
  const std::string reason = textField(object, "CoordinateSpaceReason");
  throw Failure(UsageProblem, path + ": coordinates in scanner RAS are required, but their space is unknown" +
                                  (reason.empty() ? "" : " (" + reason + ")") + "; " + remedy);
}

std::vector<std::vector<double>> readNumbers(const std::string& path) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path)) {
    throw Failure(FileProblem, path + ": a text file of numbers is required; it cannot be read.");
  }
  std::vector<std::vector<double>> rows;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    std::istringstream words(line.substr(0, line.find('#')));
    std::vector<double> row;
    for (std::string word; words >> word;) {
      std::size_t used = 0;
      try {
        row.push_back(std::stod(word, &used));
      } catch (const std::exception&) {
        used = 0;
      }
      if (used != word.size()) {
        throw Failure(FileProblem,
                      path + ": line " + std::to_string(number) + " has '" + word + "', which is no number.");
      }
    }
    if (!row.empty()) rows.push_back(row);
  }
  return rows;
}

}  // namespace authalic::cli
