/// @file
/// The methods of `authalic map`, in families that share a filter and their options.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkSurfaceMapAlgorithm.h>

#include "Files.h"

class vtkDiskMapAlgorithm;

namespace authalic::cli {

/// Options that several families know.
struct SharedMapOptions {
  std::optional<std::string> domain, initial, finish;
  std::optional<double> tolerance;
  std::optional<int> maxIterations;
  bool noUnfold = false;
  std::optional<std::string> balance;
  std::vector<double> holeAreas;
  SpaceOption space;
};

/// One filter with the names of its methods and its options on the command line.
class MapFamily {
 public:
  virtual ~MapFamily() = default;

  /// Names of METHOD, in the order of the filter's enumeration where it has one.
  [[nodiscard]] virtual std::vector<std::string> methods() const = 0;
  /// What they do, for which surfaces, to which domains: a paragraph of the help page.
  [[nodiscard]] virtual std::string description() const = 0;
  /// What those of "--initial", "--tolerance", "--max-iterations", "--finish", "--no-unfold" and "--hole-areas" mean
  /// that the methods take, with the default.
  [[nodiscard]] virtual std::map<std::string, std::string> sharedOptions() const { return {}; }
  /// Declare the family's own options through own().
  virtual void declare(CLI::App*) {}
  /// The filter with all options set.
  /// @throws Failure when an option cannot be used
  [[nodiscard]] virtual vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string& method,
                                                                       const SharedMapOptions& shared,
                                                                       const Session& session) const = 0;

  /// Adds arrays that options name as files to the surface, and names them to the filter.
  virtual void addArrays(vtkSurfaceMapAlgorithm*, const SharedMapOptions&, vtkSmartPointer<vtkPolyData>&,
                         const Session&) const {}
  /// Further files that the family's options name, to be written.
  [[nodiscard]] virtual std::vector<std::string> files() const { return {}; }
  /// Writes them, and says what a user of the method looks for, after the filter has run.
  virtual void conclude(vtkSurfaceMapAlgorithm*, const Session&) const {}

  /// Options declared by this family, whether given or not.
  [[nodiscard]] const std::vector<CLI::Option*>& ownOptions() const noexcept { return own_; }

 protected:
  /// Remembers an option as the family's and groups it on the help page.
  CLI::Option* own(CLI::Option* option);

 private:
  std::vector<CLI::Option*> own_;
};

[[nodiscard]] std::unique_ptr<MapFamily> barycentricFamily();
[[nodiscard]] std::unique_ptr<MapFamily> lieFlowFamily();
[[nodiscard]] std::unique_ptr<MapFamily> lieAdvectionFamily();
[[nodiscard]] std::unique_ptr<MapFamily> stretchFamily();
[[nodiscard]] std::unique_ptr<MapFamily> stretchEnergyFamily();
[[nodiscard]] std::unique_ptr<MapFamily> authalicFamily();
[[nodiscard]] std::unique_ptr<MapFamily> conformalFlowFamily();
[[nodiscard]] std::unique_ptr<MapFamily> leastSquaresConformalFamily();
[[nodiscard]] std::unique_ptr<MapFamily> symmetricDirichletFamily();
[[nodiscard]] std::unique_ptr<MapFamily> sphereFamily();
[[nodiscard]] std::unique_ptr<MapFamily> transportFamily();

/// Whether an option that takes a name or a file was given a file.
[[nodiscard]] bool isFile(const std::string& nameOrPath);

/// circle-domain, annulus, periodic-rectangle: the domains of maps of surfaces with holes, in the order of the filters'
/// enumerations.
[[nodiscard]] const std::vector<std::string>& holedDomains();

/// The filter for one of them, with the areas of its holes; null for other domains.
/// @throws Failure when there are hole areas for a domain without holes
template <class Filter>
vtkSmartPointer<Filter> holedFilter(const SharedMapOptions& shared) {
  const auto& domains = holedDomains();
  const auto found = std::find(domains.begin(), domains.end(), shared.domain.value_or("disk"));
  if (!shared.holeAreas.empty() && (found == domains.end() || *found == "periodic-rectangle")) {
    throw Failure(UsageProblem, "--hole-areas need --domain circle-domain or annulus.");
  }
  if (found == domains.end()) return nullptr;
  const auto filter = vtkSmartPointer<Filter>::New();
  filter->SetDomain(static_cast<int>(found - domains.begin()));
  for (const double area : shared.holeAreas) filter->AddHoleArea(area);
  return filter;
}

/// Sets the planar domain that `text` names (disk, square, rectangle:ASPECT, polygon:FILE); the disk when there is
/// none.
/// @throws Failure
void setDiskDomain(vtkDiskMapAlgorithm* filter, const std::optional<std::string>& text);

/// Sets --initial, when it is given: a file as the second input, where the filter has one; a name as the initial method
/// of `disk`, the same filter where it maps a disk, else null.
/// @throws Failure when the filter of the domain takes neither
template <class DiskFilter>
void setInitial(vtkSurfaceMapAlgorithm* filter, DiskFilter* disk, const SharedMapOptions& shared,
                const std::vector<std::string>& names, const Session& session) {
  if (!shared.initial) return;
  if (isFile(*shared.initial) && filter->GetNumberOfInputPorts() > 1) {
    filter->SetInputData(1, readSurface(*shared.initial, session, shared.space));
  } else if (disk) {
    disk->SetInitialMethod(choice("--initial", *shared.initial, names));
  } else {
    throw Failure(UsageProblem, "--initial " + *shared.initial + " is not for --domain " + *shared.domain +
                                    "; leave it out, the start is found by the method.");
  }
}

/// --balance where it is one number.
/// @throws Failure when it is outside [0, 1], or the domain is neither disk nor sphere
[[nodiscard]] std::optional<double> balanceNumber(const SharedMapOptions& shared);

/// The point array that --balance names, or reads from a file; none when it is a number.
[[nodiscard]] std::optional<std::string> balanceArray(const SharedMapOptions& shared,
                                                      vtkSmartPointer<vtkPolyData>& surface, const Session& session);

/// A number as the help page shows it.
[[nodiscard]] std::string shown(double value);

}  // namespace authalic::cli
