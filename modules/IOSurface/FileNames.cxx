#include "FileNames.h"

#include <algorithm>
#include <cctype>

#include "Core/base/Error.h"

namespace authalic {

std::string extensionOf(const std::string& path) {
  std::string name = path.substr(path.find_last_of('/') + 1);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (name.size() > 3 && name.compare(name.size() - 3, 3, ".gz") == 0) {
    name.resize(name.size() - 3);
  }
  const auto dot = name.rfind('.');
  return dot == std::string::npos ? std::string() : name.substr(dot);
}

bool isPatchName(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1).find(".patch.") != std::string::npos;
}

std::string arrayNameOf(const std::string& path) {
  std::string name = path.substr(path.find_last_of('/') + 1);
  for (const char* end : {".gz", ".gii", ".func", ".shape", ".label", ".time", ".annot", ".mgh", ".mgz", ".txt", ".nii",
                          ".dscalar", ".dlabel", ".dtseries", ".w", ".mz3"}) {
    const std::string extension(end);
    if (name.size() > extension.size() &&
        name.compare(name.size() - extension.size(), extension.size(), extension) == 0) {
      name.resize(name.size() - extension.size());
    }
  }
  const bool hemisphere =
      name.size() > 3 && (name.compare(0, 3, "lh.") == 0 || name.compare(0, 3, "rh.") == 0);
  return hemisphere ? name.substr(3) : name;
}

void requireUncompressedName(const std::string& path) {
  if (path.size() > 3 && path.compare(path.size() - 3, 3, ".gz") == 0) {
    throw InvalidArgument(path + ": A name without .gz is required, because compressed files of this kind are read but "
                                 "not written; leave .gz off and run gzip on the file.");
  }
}

}  // namespace authalic
