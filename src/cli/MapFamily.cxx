#include "MapFamily.h"

#include <sstream>
#include <utility>

#include <vtkDiskMapAlgorithm.h>

namespace authalic::cli {
namespace {

/// Name and argument of "rectangle:2".
std::pair<std::string, std::string> split(const std::string& text) {
  const std::size_t colon = text.find(':');
  return {text.substr(0, colon), colon == std::string::npos ? std::string() : text.substr(colon + 1)};
}

void setPolygon(vtkDiskMapAlgorithm* filter, const std::string& path) {
  for (const std::vector<double>& row : readNumbers(path)) {
    if (row.size() != 2) throw Failure(FileProblem, path + ": two numbers per line (x y of a corner) are required.");
    filter->AddPolygonCorner(row[0], row[1]);
  }
  filter->SetDomainToPolygon();
}

void setRectangle(vtkDiskMapAlgorithm* filter, const std::string& aspect) {
  double number = 0;
  if (!CLI::detail::lexical_cast(aspect, number)) {
    throw Failure(UsageProblem, "--domain rectangle:ASPECT needs a number (width / height); it is '" + aspect + "'.");
  }
  filter->SetAspect(number);
  filter->SetDomainToRectangle();
}

}  // namespace

CLI::Option* MapFamily::own(CLI::Option* option) {
  own_.push_back(option);
  const std::vector<std::string> names = methods();
  return option->group("Options of " + (names.size() == 1 ? names.front() : oneOf(names)));
}

void setDiskDomain(vtkDiskMapAlgorithm* filter, const std::optional<std::string>& text) {
  const auto [name, argument] = split(text.value_or("disk"));
  if (name == "disk" && argument.empty()) return filter->SetDomainToDisk();
  if (name == "square" && argument.empty()) return filter->SetDomainToSquare();
  if (name == "polygon" && !argument.empty()) return setPolygon(filter, argument);
  if (name == "rectangle" && !argument.empty()) return setRectangle(filter, argument);
  for (const char* other :
       {"sphere", "annulus", "circle-domain", "periodic-rectangle", "torus", "flat-cones", "free"}) {
    if (name == other) {
      throw Failure(UsageProblem, "--domain " + name + " is not for maps of a disk by this method; take disk, square, "
                                  "rectangle:ASPECT or polygon:FILE.");
    }
  }
  throw Failure(UsageProblem,
                "--domain must be disk, square, rectangle:ASPECT or polygon:FILE; it is '" + *text + "'.");
}

std::optional<double> balanceNumber(const SharedMapOptions& shared) {
  if (!shared.balance) return std::nullopt;
  const std::string domain = shared.domain.value_or("disk");
  if (domain != "disk" && domain != "sphere") {
    throw Failure(UsageProblem, "--balance needs --domain disk or sphere; it is '" + domain + "'.");
  }
  double number = 0;
  if (!CLI::detail::lexical_cast(*shared.balance, number)) return std::nullopt;
  if (number >= 0 && number <= 1) return number;
  throw Failure(UsageProblem,
                "--balance must be from 0 (conformal) to 1 (area-preserving); it is " + *shared.balance + ".");
}

std::optional<std::string> balanceArray(const SharedMapOptions& shared, vtkSmartPointer<vtkPolyData>& surface,
                                        const Session& session) {
  if (!shared.balance || balanceNumber(shared)) return std::nullopt;
  return arrayOf(surface, *shared.balance, session);
}

const std::vector<std::string>& holedDomains() {
  static const std::vector<std::string> names = {"circle-domain", "annulus", "periodic-rectangle"};
  return names;
}

bool isFile(const std::string& nameOrPath) { return nameOrPath.find('.') != std::string::npos; }

std::string shown(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

}  // namespace authalic::cli
