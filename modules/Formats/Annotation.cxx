#include <algorithm>
#include <map>

#include "Formats/AtomicFile.h"
#include "Formats/ByteCursor.h"
#include "Formats/Gifti.h"
#include "Formats/InputFile.h"
#include "Formats/Morphometry.h"
#include "Formats/SurfaceParsers.h"

namespace authalic {

namespace {

std::int32_t packedColour(const Region& region) {
  return region.rgba[0] | region.rgba[1] << 8 | region.rgba[2] << 16;
}

/// r, g, b and transparency (255 minus opacity), each a 32-bit integer.
void parseColour(ByteCursor& cursor, Region& region) {
  for (std::size_t i = 0; i < 4; ++i) {
    const auto part = cursor.next<std::int32_t>("a colour");
    if (part < 0 || part > 255) {
      cursor.fail("A colour should lie between 0 and 255, but is " + std::to_string(part) +
                  "; the table is damaged.");
    }
    region.rgba[i] = static_cast<std::uint8_t>(i == 3 ? 255 - part : part);
  }
}

std::string parseName(ByteCursor& cursor, const char* what) {
  const auto length = cursor.next<std::int32_t>(what);
  if (length < 0) {
    cursor.fail(std::string("The length of ") + what + " is negative; the table is damaged.");
  }
  return cursor.text(static_cast<std::uint64_t>(length), what);
}

void parseOldTable(ByteCursor& cursor, std::int32_t entries, std::vector<Region>& regions) {
  static_cast<void>(parseName(cursor, "the name of the colour table"));
  cursor.need(static_cast<std::uint64_t>(entries), 20, "the colour table");
  for (std::int32_t i = 0; i < entries; ++i) {
    Region region;
    region.id = i;
    region.name = parseName(cursor, "the name of a region");
    parseColour(cursor, region);
    regions.push_back(std::move(region));
  }
}

void parseNewTable(ByteCursor& cursor, std::vector<Region>& regions) {
  static_cast<void>(cursor.next<std::int32_t>("the largest region id"));
  static_cast<void>(parseName(cursor, "the name of the colour table"));
  const auto entries = cursor.next<std::int32_t>("the number of regions");
  if (entries < 0) {
    cursor.fail("The number of regions is negative; the table is damaged.");
  }
  cursor.need(static_cast<std::uint64_t>(entries), 24, "the colour table");
  for (std::int32_t i = 0; i < entries; ++i) {
    Region region;
    region.id = cursor.next<std::int32_t>("the id of a region");
    region.name = parseName(cursor, "the name of a region");
    parseColour(cursor, region);
    regions.push_back(std::move(region));
  }
}

/// Packed colours per vertex → ids of the table.
void colourToId(Annotation& annotation) {
  std::map<std::int32_t, std::int32_t> ids;
  for (const Region& region : annotation.regions) {
    const auto [at, fresh] = ids.emplace(packedColour(region), region.id);
    if (!fresh && at->second != region.id) {
      annotation.warnings.push_back("Region \"" + region.name + "\" has the colour of region " +
                                    std::to_string(at->second) + "; its vertices are counted as that one's.");
    }
  }
  std::int64_t strays = 0;
  for (std::int32_t& label : annotation.labels) {
    const auto found = ids.find(label);
    strays += found == ids.end() && label != 0 ? 1 : 0;
    label = found == ids.end() ? -1 : found->second;
  }
  if (strays > 0) {
    annotation.warnings.push_back(std::to_string(strays) +
                                  " vertices have a colour that is not in the table.");
  }
}

Annotation parseAnnot(const std::string& path, const FileBytes& bytes) {
  ByteCursor cursor(path, bytes);
  const auto vertices = cursor.next<std::int32_t>("the number of vertices");
  if (vertices < 1) {
    cursor.fail("The header claims " + std::to_string(vertices) +
                " vertices; this is not a FreeSurfer annotation.");
  }
  cursor.need(static_cast<std::uint64_t>(vertices), 8, "the list of labels");
  Annotation annotation;
  annotation.labels.assign(static_cast<std::size_t>(vertices), 0);
  for (std::int32_t i = 0; i < vertices; ++i) {
    const auto vertex = cursor.next<std::int32_t>("a vertex");
    const auto value = cursor.next<std::int32_t>("a label");
    if (vertex < 0 || vertex >= vertices) {
      cursor.fail("Vertex " + std::to_string(vertex) + " is labelled, but the file is for " +
                  std::to_string(vertices) + " vertices; it is not a FreeSurfer annotation or is damaged.");
    }
    annotation.labels[static_cast<std::size_t>(vertex)] = value;
  }
  if (cursor.remaining() == 0 || cursor.next<std::int32_t>("the mark of a colour table") == 0) {
    return annotation;
  }
  const auto layout = cursor.next<std::int32_t>("the layout of the colour table");
  if (layout > 0) {
    parseOldTable(cursor, layout, annotation.regions);
  } else if (layout == -2) {
    parseNewTable(cursor, annotation.regions);
  } else {
    cursor.fail("The colour table has layout " + std::to_string(layout) + ", which is not known.");
  }
  colourToId(annotation);
  return annotation;
}

}  // namespace

Annotation giftiAnnotation(const std::string& path, const GiftiFile& file) {
  for (const GiftiArray& array : file.arrays) {
    const bool flat =
        array.dimensions.size() == 1 || (array.dimensions.size() == 2 && array.dimensions[1] == 1);
    if (array.intent != GiftiIntent::Label || !flat) {
      continue;
    }
    Annotation annotation;
    annotation.regions = file.labels;
    annotation.labels.reserve(array.values.size());
    for (const double value : array.values) {
      if (!(value >= -2147483648.0 && value <= 2147483647.0) || value != static_cast<std::int32_t>(value)) {
        throw FormatError(path,
                          "Labels are whole numbers of 32 bits, but one is " + std::to_string(value) + ".");
      }
      annotation.labels.push_back(static_cast<std::int32_t>(value));
    }
    return annotation;
  }
  throw FormatError(path,
                    "A region per vertex is needed, but the GIFTI file has no LABEL array of that shape.");
}

Annotation readAnnot(const std::string& path, std::size_t vertexCount) {
  const FileBytes bytes = readBytes(path);
  const FileKind kind = recognise(bytes);
  if (kind == FileKind::Gifti) {
    GiftiFile file = readGifti(path);
    spreadNodeIndex(path, file, vertexCount);
    return giftiAnnotation(path, file);
  }
  if (kind != FileKind::Other) {
    throw FormatError(path,
                      std::string("An annotation is needed, but the file is ") + fileKindName(kind) + ".");
  }
  return parseAnnot(path, bytes);
}

namespace {

/// Ids of regions → the colours that stand for them in the file.
std::map<std::int32_t, std::int32_t> colorsOf(const std::string& path, const Annotation& annotation) {
  std::map<std::int32_t, std::int32_t> colors;
  std::map<std::int32_t, const Region*> taken;
  for (const Region& region : annotation.regions) {
    const auto [at, fresh] = taken.emplace(packedColour(region), &region);
    if (!fresh || region.id < 0 || !colors.emplace(region.id, packedColour(region)).second) {
      throw FormatError(path, "An annotation tells regions apart by colour and numbers them from 0, but region \"" +
                                  region.name + "\" (number " + std::to_string(region.id) +
                                  ") has a negative number, or a number or colour that another has" +
                                  (fresh ? "" : " (\"" + at->second->name + "\")") +
                                  "; give each its own, or write .label.gii.");
    }
  }
  return colors;
}

void encodeName(FileBytes& bytes, const std::string& name) {
  encode(bytes, static_cast<std::int32_t>(name.size() + 1), ByteOrder::Big);
  bytes.insert(bytes.end(), name.begin(), name.end());
  bytes.push_back(0);
}

void encodeTable(FileBytes& bytes, const std::vector<Region>& regions) {
  std::int32_t largest = -1;
  for (const Region& region : regions) {
    largest = std::max(largest, region.id);
  }
  encode(bytes, std::int32_t{1}, ByteOrder::Big);
  encode(bytes, std::int32_t{-2}, ByteOrder::Big);
  encode(bytes, largest + 1, ByteOrder::Big);
  encodeName(bytes, "authalic");
  encode(bytes, static_cast<std::int32_t>(regions.size()), ByteOrder::Big);
  for (const Region& region : regions) {
    encode(bytes, region.id, ByteOrder::Big);
    encodeName(bytes, region.name);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::int32_t part = region.rgba[i];
      encode(bytes, i == 3 ? 255 - part : part, ByteOrder::Big);
    }
  }
}

}  // namespace

void writeAnnot(const std::string& path, const Annotation& annotation) {
  const auto colors = colorsOf(path, annotation);
  const bool blackRegion =
      std::any_of(colors.begin(), colors.end(), [](const auto& entry) { return entry.second == 0; });
  FileBytes bytes;
  encode(bytes, static_cast<std::int32_t>(annotation.labels.size()), ByteOrder::Big);
  for (std::size_t i = 0; i < annotation.labels.size(); ++i) {
    const std::int32_t label = annotation.labels[i];
    const auto color = colors.find(label);
    const bool none = color == colors.end();
    if (none && (label != -1 || blackRegion)) {
      throw FormatError(path, "Vertex " + std::to_string(i) + " has label " + std::to_string(label) +
                                  (label != -1 ? ", which the table does not have; add it to the table."
                                               : " (no region), which an annotation stores as black, but a region is "
                                                 "black; give that one another colour."));
    }
    encode(bytes, static_cast<std::int32_t>(i), ByteOrder::Big);
    encode(bytes, none ? 0 : color->second, ByteOrder::Big);
  }
  encodeTable(bytes, annotation.regions);
  writeFileAtomically(path, bytes);
}

}  // namespace authalic
