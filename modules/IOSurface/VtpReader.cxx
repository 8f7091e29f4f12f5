#include "VtpReader.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <map>
#include <string_view>

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkZLibDataCompressor.h>

#include "Core/base/Error.h"
#include "Formats/TextNumbers.h"
#include "Formats/XmlReader.h"
#include "VtpBlocks.h"

namespace authalic {

namespace {

/// An element Array or DataArray.
struct VtpArray {
  XmlAttributes attributes;
  std::string text;
  [[nodiscard]] std::string get(const char* name) const {
    const auto found = attributes.find(name);
    return found == attributes.end() ? std::string() : found->second;
  }
};

/// The arrays of one of the elements of a piece, and which of them are active.
struct VtpSection {
  XmlAttributes attributes;
  std::vector<VtpArray> arrays;
};

using VtpPiece = std::map<std::string, VtpSection>;  // by name of the element; "Piece" for itself

constexpr std::array<const char*, 4> kCellKinds{"Verts", "Lines", "Strips", "Polys"};

/// Collects what the document says, without decoding it.
class VtpParser : public XmlReader {
 public:
  using XmlReader::XmlReader;
  void parse(std::string_view document) { walk(document); }

  XmlAttributes root;
  VtpSection fields;
  std::vector<VtpPiece> pieces;

 private:
  void start(const std::string& element, const XmlAttributes& attributes) override {
    keepText();
    stack_.push_back(element);
    if (stack_.size() == 1) {
      startRoot(element, attributes);
    } else if (stack_.size() == 3 && element == "Piece") {
      pieces.emplace_back()["Piece"].attributes = attributes;
    } else if (VtpSection* section = stack_.size() >= 3 ? currentSection() : nullptr) {
      if (element == "DataArray" || element == "Array") {
        section->arrays.push_back({attributes, ""});
        array_ = &section->arrays.back();
        arrayDepth_ = stack_.size();
      } else if (stack_.size() == 4) {
        section->attributes = attributes;
      }
    }
  }
  void end(const std::string&) override {
    keepText();
    if (stack_.size() == arrayDepth_) {
      array_ = nullptr;
      arrayDepth_ = 0;
    }
    stack_.pop_back();
  }
  void startRoot(const std::string& element, const XmlAttributes& attributes) {
    if (element != "VTKFile") {
      throw FormatError(path_, "A .vtp file has an element VTKFile, but this one has " + element.substr(0, 40) + ".");
    }
    root = attributes;
    if (root["type"] != "PolyData") {
      throw FormatError(path_, "A VTK file of type PolyData is needed, but this one is of type \"" +
                                   root["type"].substr(0, 40) + "\".");
    }
  }
  /// The text of an array itself, not of what is inside it.
  void keepText() {
    if (array_ && stack_.size() == arrayDepth_) {
      array_->text += text_;
    }
  }
  /// Field data of the whole, or an element of the last piece.
  VtpSection* currentSection() {
    if (stack_[1] != "PolyData" || array_) {
      return nullptr;
    }
    if (stack_[2] == "FieldData") {
      return &fields;
    }
    return stack_[2] == "Piece" && stack_.size() >= 4 && !pieces.empty() ? &pieces.back()[stack_[3]] : nullptr;
  }

  std::vector<std::string> stack_;
  VtpArray* array_ = nullptr;
  std::size_t arrayDepth_ = 0;
};

class Silence : public vtkCommand {
 public:
  static Silence* New() { return new Silence; }
  void Execute(vtkObject*, unsigned long, void*) override {}
};

/// Decodes the arrays of one file.
class VtpDecoder {
 public:
  VtpDecoder(const std::string& path, std::string_view appended, bool base64, const XmlAttributes& root)
      : path_(path), appended_(appended), base64_(base64) {
    const auto value = [&root](const char* name) {
      const auto found = root.find(name);
      return found == root.end() ? std::string() : found->second;
    };
    layout_.order = value("byte_order") == "BigEndian" ? ByteOrder::Big : ByteOrder::Little;
    layout_.words64 = value("header_type") == "UInt64";
    const std::string name = value("compressor");
    if (name == "vtkZLibDataCompressor") {
      compressor_ = vtkSmartPointer<vtkZLibDataCompressor>::New();
    } else if (name == "vtkLZ4DataCompressor") {
      compressor_ = vtkSmartPointer<vtkLZ4DataCompressor>::New();
    } else if (name == "vtkLZMADataCompressor") {
      compressor_ = vtkSmartPointer<vtkLZMADataCompressor>::New();
    } else if (!name.empty()) {
      throw FormatError(path_, "The arrays are compressed by \"" + name.substr(0, 40) + "\", which is not known.");
    }
    layout_.compressor = compressor_;
    if (compressor_) {  // what it would print is said by the exception
      compressor_->AddObserver(vtkCommand::ErrorEvent, vtkNew<Silence>());
    }
  }

  [[nodiscard]] vtkIdType count(const XmlAttributes& attributes, const char* name) const {
    const auto found = attributes.find(name);
    const auto number = parseNumber<std::int64_t>(found == attributes.end() ? "0" : trimmed(found->second));
    if (!number || *number < 0 || *number > std::numeric_limits<std::int32_t>::max()) {
      throw FormatError(path_, std::string(name) + " should be a count that a file can hold, but it is \"" +
                                   found->second.substr(0, 40) + "\"; the file is damaged.");
    }
    return static_cast<vtkIdType>(*number);
  }

  /// `tuples` tuples of numbers.
  [[nodiscard]] vtkSmartPointer<vtkDataArray> numbers(const VtpArray& from, vtkIdType tuples) const {
    auto array = newArray(from);
    const bool stated = from.attributes.count("NumberOfComponents") > 0;
    const vtkIdType components = stated ? count(from.attributes, "NumberOfComponents") : 1;
    if (components < 1 || components > 1024) {
      fail(from, "should have 1 to 1024 components");
    }
    const auto values = static_cast<std::uint64_t>(components) * static_cast<std::uint64_t>(tuples);
    const auto size = static_cast<std::uint64_t>(array->GetDataTypeSize());
    const std::vector<std::uint8_t> bytes = from.get("format") == "ascii" ? textBytes(from, array, values)
                                                                          : binaryBytes(from, values * size, size);
    array->SetNumberOfComponents(static_cast<int>(components));
    array->SetNumberOfTuples(tuples);
    if (!bytes.empty()) {
      std::memcpy(array->GetVoidPointer(0), bytes.data(), bytes.size());
    }
    array->SetName(from.attributes.count("Name") ? from.get("Name").c_str() : nullptr);
    for (vtkIdType k = 0; k < components; ++k) {
      const std::string name = from.get(("ComponentName" + std::to_string(k)).c_str());
      if (!name.empty()) {
        array->SetComponentName(k, name.c_str());
      }
    }
    return array;
  }

  /// Texts, each ended by a zero.
  [[nodiscard]] vtkSmartPointer<vtkStringArray> texts(const VtpArray& from, vtkIdType tuples) const {
    std::vector<std::uint8_t> bytes;
    if (from.get("format") == "ascii") {
      std::string_view rest = from.text;
      for (std::string_view word = nextToken(rest); !word.empty(); word = nextToken(rest)) {
        const auto number = parseNumber<int>(word);
        if (!number || *number < -128 || *number > 255) {
          fail(from, "should hold characters as numbers");
        }
        bytes.push_back(static_cast<std::uint8_t>(*number));
      }
    } else {
      bytes = textBlock(from);
    }
    auto array = vtkSmartPointer<vtkStringArray>::New();
    array->SetName(from.get("Name").c_str());
    auto begin = bytes.begin();
    for (vtkIdType i = 0; i < tuples; ++i) {
      const auto end = std::find(begin, bytes.end(), std::uint8_t{0});
      if (end == bytes.end()) {
        fail(from, "ends before its last text");
      }
      array->InsertNextValue(std::string(begin, end));
      begin = end + 1;
    }
    return array;
  }

  [[noreturn]] void fail(const VtpArray& from, const char* what) const {
    throw FormatError(path_, "The array \"" + from.get("Name").substr(0, 40) + "\" " + what + "; the file is damaged.");
  }

 private:
  [[nodiscard]] vtkSmartPointer<vtkDataArray> newArray(const VtpArray& from) const {
    static const std::map<std::string, int> types{
        {"Int8", VTK_TYPE_INT8},     {"UInt8", VTK_TYPE_UINT8},   {"Int16", VTK_TYPE_INT16},
        {"UInt16", VTK_TYPE_UINT16}, {"Int32", VTK_TYPE_INT32},   {"UInt32", VTK_TYPE_UINT32},
        {"Int64", VTK_TYPE_INT64},   {"UInt64", VTK_TYPE_UINT64}, {"Float32", VTK_TYPE_FLOAT32},
        {"Float64", VTK_TYPE_FLOAT64}};
    const auto type = types.find(from.get("type"));
    if (type == types.end()) {
      fail(from, ("has the type \"" + from.get("type").substr(0, 40) + "\", which is not read").c_str());
    }
    const bool ids = from.get("IdType") == "1" && type->first == "Int64";
    return vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(ids ? VTK_ID_TYPE : type->second));
  }

  /// Where the array begins, and whether it is base64 there.
  [[nodiscard]] std::string_view place(const VtpArray& from, bool& base64) const {
    const std::string format = from.get("format");
    if (format == "appended") {
      const auto offset = parseNumber<std::uint64_t>(trimmed(from.get("offset")));
      if (!offset || *offset > appended_.size()) {
        fail(from, "begins outside the file");
      }
      base64 = base64_;
      return appended_.substr(static_cast<std::size_t>(*offset));
    }
    if (format != "binary") {
      fail(from, "should be ascii, binary or appended");
    }
    base64 = true;
    const std::string_view text = from.text;
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    return begin == std::string_view::npos ? std::string_view() : text.substr(begin);
  }

  /// In the byte order of this machine.
  [[nodiscard]] std::vector<std::uint8_t> binaryBytes(const VtpArray& from, std::uint64_t expected,
                                                      std::uint64_t size) const {
    bool base64 = true;
    const std::string_view text = place(from, base64);
    auto bytes = vtpBytes(path_, text, base64, layout_, expected);
    const std::uint16_t probe = 1;
    const bool little = *reinterpret_cast<const std::uint8_t*>(&probe) == 1;
    if (little != (layout_.order == ByteOrder::Little)) {
      for (auto number = bytes.begin(); number != bytes.end(); number += static_cast<std::ptrdiff_t>(size)) {
        std::reverse(number, number + static_cast<std::ptrdiff_t>(size));
      }
    }
    return bytes;
  }

  /// The block of a text array, whose length only its header knows.
  [[nodiscard]] std::vector<std::uint8_t> textBlock(const VtpArray& from) const {
    bool base64 = true;
    const std::string_view text = place(from, base64);
    return vtpBytes(path_, text, base64, layout_, vtpLength(path_, text, base64, layout_));
  }

  template <class T>
  [[nodiscard]] bool putAscii(std::string_view word, std::vector<std::uint8_t>& bytes) const {
    const auto number = parseNumber<T>(word);
    if (number) {
      const auto* from = reinterpret_cast<const std::uint8_t*>(&*number);
      bytes.insert(bytes.end(), from, from + sizeof(T));
    }
    return number.has_value();
  }

  /// ASCII; a number takes at least two characters of the text.
  [[nodiscard]] std::vector<std::uint8_t> textBytes(const VtpArray& from, vtkDataArray* array,
                                                    std::uint64_t values) const {
    if (values > from.text.size()) {
      fail(from, "has fewer numbers than it should");
    }
    std::vector<std::uint8_t> bytes;
    std::string_view rest = from.text;
    for (std::uint64_t i = 0; i < values; ++i) {
      const std::string_view word = nextToken(rest);
      bool good = false;
      switch (array->GetDataType()) {
        vtkTemplateMacro(good = putAscii<VTK_TT>(word, bytes));
        default:
          break;
      }
      if (!good) {
        fail(from, "holds something that is no number of its type, or too few");
      }
    }
    if (!nextToken(rest).empty()) {
      fail(from, "holds more numbers than it should");
    }
    return bytes;
  }

  const std::string& path_;
  std::string_view appended_;
  bool base64_;
  VtpLayout layout_;
  vtkSmartPointer<vtkDataCompressor> compressor_;
};

vtkSmartPointer<vtkCellArray> cellsOf(const VtpDecoder& decoder, const VtpSection& section, vtkIdType cells,
                                      vtkIdType points) {
  const auto named = [&](const char* name) -> const VtpArray& {
    for (const VtpArray& array : section.arrays) {
      if (array.get("Name") == name) {
        return array;
      }
    }
    decoder.fail({{{"Name", name}}, ""}, "of cells is not there");
  };
  const VtpArray& ends = named("offsets");
  const auto read = decoder.numbers(ends, cells);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(cells + 1);
  offsets->SetValue(0, 0);
  for (vtkIdType i = 0; i < cells; ++i) {
    const double end = read->GetComponent(i, 0);
    if (!(end >= static_cast<double>(offsets->GetValue(i)) && end < 1e12)) {
      decoder.fail(ends, "should rise");
    }
    offsets->SetValue(i + 1, static_cast<vtkIdType>(end));
  }
  const VtpArray& ids = named("connectivity");
  const auto corners = decoder.numbers(ids, offsets->GetValue(cells));
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(corners->GetNumberOfTuples());
  for (vtkIdType i = 0; i < corners->GetNumberOfTuples(); ++i) {
    const double id = corners->GetComponent(i, 0);
    if (!(id >= 0 && id < static_cast<double>(points))) {
      decoder.fail(ids, "names a point that the file does not hold");
    }
    connectivity->SetValue(i, static_cast<vtkIdType>(id));
  }
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->SetData(offsets, connectivity);
  return result;
}

void addArrays(const VtpDecoder& decoder, const VtpSection& section, vtkIdType tuples, vtkFieldData* data) {
  const bool stated = tuples < 0;  // each array says how many
  for (const VtpArray& from : section.arrays) {
    const vtkIdType count = stated ? decoder.count(from.attributes, "NumberOfTuples") : tuples;
    if (from.get("type") == "String") {
      data->AddArray(decoder.texts(from, count));
    } else {
      data->AddArray(decoder.numbers(from, count));
    }
  }
}

void setActive(const VtpSection& section, vtkDataSetAttributes* data) {
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type) {
    const auto found = section.attributes.find(vtkDataSetAttributes::GetAttributeTypeAsString(type));
    if (found != section.attributes.end() && data->GetAbstractArray(found->second.c_str())) {
      data->SetActiveAttribute(found->second.c_str(), type);
    }
  }
}

vtkSmartPointer<vtkPolyData> surfaceOf(const VtpDecoder& decoder, VtpPiece& piece) {
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  const XmlAttributes& counts = piece["Piece"].attributes;
  const vtkIdType points = decoder.count(counts, "NumberOfPoints");
  if (points > 0) {
    const auto& arrays = piece["Points"].arrays;
    const VtpArray none{{{"Name", "Points"}}, ""};
    const auto coordinates = arrays.empty() ? nullptr : decoder.numbers(arrays.front(), points);
    if (!coordinates || coordinates->GetNumberOfComponents() != 3) {
      decoder.fail(arrays.empty() ? none : arrays.front(), "should hold three coordinates of each point");
    }
    vtkNew<vtkPoints> holder;
    holder->SetData(coordinates);
    surface->SetPoints(holder);
  }
  std::map<std::string, vtkSmartPointer<vtkCellArray>> cells;
  vtkIdType total = 0;
  for (const char* kind : kCellKinds) {
    const vtkIdType number = decoder.count(counts, (std::string("NumberOf") + kind).c_str());
    total += number;
    cells[kind] = number > 0 ? cellsOf(decoder, piece[kind], number, points) : vtkSmartPointer<vtkCellArray>::New();
  }
  surface->SetVerts(cells["Verts"]);
  surface->SetLines(cells["Lines"]);
  surface->SetStrips(cells["Strips"]);
  surface->SetPolys(cells["Polys"]);
  addArrays(decoder, piece["PointData"], points, surface->GetPointData());
  addArrays(decoder, piece["CellData"], total, surface->GetCellData());
  setActive(piece["PointData"], surface->GetPointData());
  setActive(piece["CellData"], surface->GetCellData());
  return surface;
}

void requireEnd(const std::string& path, std::string_view text) {
  constexpr std::string_view end = "</VTKFile>";
  const std::size_t last = text.find_last_not_of(std::string_view(" \t\r\n\0", 5));
  const std::string_view whole = text.substr(0, last == std::string_view::npos ? 0 : last + 1);
  if (whole.size() < end.size() || whole.substr(whole.size() - end.size()) != end) {
    throw FormatError(path, "A .vtp file ends with </VTKFile>, but this one does not; it is truncated.");
  }
}

}  // namespace

void readVtp(const std::string& path, const std::vector<std::uint8_t>& bytes, vtkPolyData* output) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.find("<VTKFile") == std::string_view::npos) {
    throw FormatError(path, "A .vtp file has an element VTKFile, but this one does not.");
  }
  requireEnd(path, text);
  // Raw bytes are no XML: what is appended is cut off before.
  const std::size_t at = text.find("<AppendedData");
  std::string_view appended;
  bool base64 = true;
  if (at != std::string_view::npos) {
    const std::size_t close = text.find('>', at);
    base64 = text.substr(at, close - at).find("raw") == std::string_view::npos;
    const std::size_t mark = text.find('_', close);
    appended = mark == std::string_view::npos ? std::string_view() : text.substr(mark + 1);
  }
  VtpParser parser(path);
  parser.parse(at == std::string_view::npos ? std::string(text.substr(0, text.rfind('>') + 1))
                                            : std::string(text.substr(0, at)) + "</VTKFile>");
  const VtpDecoder decoder(path, appended, base64, parser.root);
  if (parser.pieces.size() == 1) {
    output->ShallowCopy(surfaceOf(decoder, parser.pieces.front()));
  } else if (!parser.pieces.empty()) {
    vtkNew<vtkAppendPolyData> append;
    for (VtpPiece& piece : parser.pieces) {
      append->AddInputData(surfaceOf(decoder, piece));
    }
    append->Update();
    output->ShallowCopy(append->GetOutput());
  }
  addArrays(decoder, parser.fields, -1, output->GetFieldData());
}

}  // namespace authalic
