// Writes what Authalic's readers make of a file as plain arrays, for the comparison with other readers:
//   format_dump surface|scalars|annot|label|volume FILE PREFIX [FRAME]
//   format_dump patch FILE PREFIX WHOLE; cifti FILE PREFIX STRUCTURE; sparse FILE PREFIX VERTICES
//   format_dump write-gifti|write-freesurfer|write-off|write-shape|write-label|write-volume FILE OUT
//   format_dump write-annot|write-mz3|write-paint FILE OUT
// Arrays go to PREFIX.<name> (little endian), facts to PREFIX.txt. A FormatError goes to stderr, exit code 5.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>

#include "Core/base/Error.h"
#include "Formats/Cifti.h"
#include "Formats/FreeSurferPatch.h"
#include "Formats/Gifti.h"
#include "Formats/Morphometry.h"
#include "Formats/Mz3.h"
#include "Formats/SurfaceFile.h"
#include "Formats/VolumeFile.h"

namespace {

using namespace authalic;

template <class T>
void dump(const std::string& path, const std::vector<T>& values) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(T)));
}

void dumpSurface(const std::string& path, const std::string& prefix) {
  SurfaceFile surface = readSurface(path);
  dump(prefix + ".points", surface.points);
  dump(prefix + ".faces", surface.faces);
  std::ofstream facts(prefix + ".txt");
  facts << "space " << coordinateSpaceName(surface.space) << "\nreason " << surface.spaceReason << "\n";
  toScannerRas(surface);
  dump(prefix + ".scanner", surface.points);
}

void dumpAnnot(const std::string& path, const std::string& prefix) {
  const Annotation annotation = readAnnot(path);
  dump(prefix + ".labels", annotation.labels);
  std::ofstream facts(prefix + ".txt");
  for (const Region& region : annotation.regions) {
    facts << region.id << "\t" << region.name;
    for (const auto part : region.rgba) {
      facts << "\t" << int{part};
    }
    facts << "\n";
  }
}

void dumpVolume(const std::string& path, const std::string& prefix, int frame) {
  const VolumeFile file = readVolume(path, frame);
  dump(prefix + ".values", file.scalars().values);
  std::ofstream facts(prefix + ".txt");
  const auto& d = file.dimensions();
  facts << d[0] << " " << d[1] << " " << d[2] << " " << file.frames << "\n" << std::setprecision(17);
  for (int r = 0; r < 4; ++r) {
    facts << file.voxelToWorld().row(r) << "\n";
  }
  facts << (file.isInteger() ? "integer" : "float") << "\n"
        << coordinateSpaceName(file.space) << "\n"
        << file.spaceReason << "\n";
  for (const auto& warning : file.warnings) {
    facts << warning << "\n";
  }
}

void dumpPatch(const std::string& path, const std::string& prefix, const std::string& whole) {
  const PatchFile patch = readPatch(path);
  const SurfaceFile surface = patchSurface(path, patch, readSurface(whole));
  dump(prefix + ".points", surface.points);
  dump(prefix + ".faces", surface.faces);
  dump(prefix + ".vertices", patch.vertices);
  dump(prefix + ".border", std::vector<int>(patch.border.begin(), patch.border.end()));
}

/// The maps of one structure after each other; names of maps and regions as facts.
void dumpCifti(const std::string& path, const std::string& prefix, const std::string& structure) {
  const CiftiFile file = readCifti(path);
  const CiftiSurface& surface = ciftiSurface(path, file, structure, 0);
  std::vector<float> all;
  std::ofstream facts(prefix + ".txt");
  for (const CiftiMap& map : file.maps) {
    const auto values = onCiftiSurface(surface, map, file.labels ? -1 : std::nanf(""));
    all.insert(all.end(), values.begin(), values.end());
    facts << map.name << "\n";
    for (const Region& region : map.regions) {
      facts << "\t" << region.id << "\t" << region.name << "\n";
    }
  }
  dump(prefix + ".values", all);
}

void dumpMz3(const std::string& path, const std::string& prefix) {
  const Mz3File file = readMz3(path);
  dump(prefix + ".points", file.points);
  dump(prefix + ".faces", file.faces);
  std::vector<float> all;
  for (const auto& layer : file.layers) {
    all.insert(all.end(), layer.begin(), layer.end());
  }
  dump(prefix + ".values", all);
}

void rewriteVolume(const std::string& path, const std::string& out) {
  const VolumeFile file = readVolume(path);
  std::visit([&out](const auto& volume) { writeVolume(out, volume); }, file.volume);
}

/// Actions with a third argument that is no frame; false when the action is none of them.
bool runWithWords(const std::string& action, const std::string& in, const std::string& out, const std::string& more) {
  if (action == "patch") {
    dumpPatch(in, out, more);
  } else if (action == "cifti") {
    dumpCifti(in, out, more);
  } else if (action == "sparse") {
    dump(out + ".values", readVertexScalars(in, std::stoul(more)));
  } else if (action == "mz3") {
    dumpMz3(in, out);
  } else if (action == "write-annot") {
    writeAnnot(out, readAnnot(in));
  } else if (action == "write-mz3") {
    writeMz3(out, readSurface(in));
  } else if (action == "write-paint") {
    writePaint(out, readVertexScalars(in));
  } else {
    return false;
  }
  return true;
}

int run(const std::string& action, const std::string& in, const std::string& out, int frame) {
  if (action == "surface") {
    dumpSurface(in, out);
  } else if (action == "scalars") {
    dump(out + ".values", readVertexScalars(in));
  } else if (action == "annot") {
    dumpAnnot(in, out);
  } else if (action == "label") {
    dump(out + ".vertices", readLabel(in).vertices);
  } else if (action == "volume") {
    dumpVolume(in, out, frame);
  } else if (action == "write-gifti") {
    writeGiftiSurface(out, readSurface(in));
  } else if (action == "write-freesurfer") {
    writeFreeSurferSurface(out, readSurface(in));
  } else if (action == "write-off") {
    writeOff(out, readSurface(in));
  } else if (action == "write-shape") {
    writeGiftiScalars(out, {{"values", readVertexScalars(in)}}, "CortexLeft");
  } else if (action == "write-label") {
    writeGiftiLabels(out, readAnnot(in), "CortexLeft");
  } else if (action == "write-volume") {
    rewriteVolume(in, out);
  } else {
    std::cerr << "no action of that name: " << action << "\n";
    return 2;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "format_dump ACTION FILE OUT [FRAME]\n";
    return 2;
  }
  try {
    if (runWithWords(argv[1], argv[2], argv[3], argc > 4 ? argv[4] : "")) {
      return 0;
    }
    return run(argv[1], argv[2], argv[3], argc > 4 ? std::stoi(argv[4]) : 0);
  } catch (const FormatError& error) {
    std::cerr << error.what() << "\n";
    return 5;
  }
}
