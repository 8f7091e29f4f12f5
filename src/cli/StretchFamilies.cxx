#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStretchEnergyMap.h>
#include <vtkStretchMinimisation.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> barycentric = {"tutte", "harmonic", "mean-value"};
const std::vector<std::string> boundaries = {"inverted", "held"};

class StretchFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"stretch"}; }

  std::string description() const override {
    return "stretch: little stretch, by a barycentric map that is reweighted until the stretch does not fall; a disk "
           "to --domain disk, square, rectangle:ASPECT or polygon:FILE. For comparison with the literature.";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {{"--max-iterations", "rounds (default: " + std::to_string(defaults_->GetMaximumIterations()) + ")"}};
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--weights", weights_, "Of the first map: " + oneOf(barycentric) + "."))
        ->type_name("HOW")
        ->default_str(barycentric[static_cast<std::size_t>(defaults_->GetWeights())]);
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session&) const override {
    const auto map = vtkSmartPointer<vtkStretchMinimisation>::New();
    setDiskDomain(map, shared.domain);
    if (shared.maxIterations) map->SetMaximumIterations(*shared.maxIterations);
    if (weights_) map->SetWeights(choice("--weights", *weights_, barycentric));
    return map;
  }

 private:
  vtkNew<vtkStretchMinimisation> defaults_;
  std::optional<std::string> weights_;
};

class StretchEnergyFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"stretch-energy"}; }

  std::string description() const override {
    return "stretch-energy: area-preserving, or to a measure of yours (--measure), as the fixed point of a "
           "stretch-weighted Laplacian; a disk to --domain disk, square, rectangle:ASPECT or polygon:FILE. For "
           "comparison with the literature; authalic is exact and never folds.";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {{"--initial", oneOf(barycentric) + ", or a MAP.vtp to the same domain (default: " +
                              barycentric[static_cast<std::size_t>(defaults_->GetInitialMethod())] + ")"},
            {"--tolerance", "part by which a round lowers sqrt(sum m (r - 1)^2) of the faces (default: " +
                                shown(defaults_->GetTolerance()) + ")"},
            {"--max-iterations", "rounds (default: " + std::to_string(defaults_->GetMaximumIterations()) + ")"}};
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--boundary", boundary_,
                         "On the disk: " + oneOf(boundaries) + ", from the inversion of the inner vertices or where "
                         "the initial map has it."))
        ->type_name("HOW")
        ->default_str(boundaries[static_cast<std::size_t>(defaults_->GetBoundary())]);
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session& session) const override {
    const auto map = vtkSmartPointer<vtkStretchEnergyMap>::New();
    setDiskDomain(map, shared.domain);
    if (shared.tolerance) map->SetTolerance(*shared.tolerance);
    if (shared.maxIterations) map->SetMaximumIterations(*shared.maxIterations);
    if (boundary_) map->SetBoundary(choice("--boundary", *boundary_, boundaries));
    if (!shared.initial) return map;
    if (isFile(*shared.initial)) map->SetInputData(1, readSurface(*shared.initial, session, shared.space));
    else map->SetInitialMethod(choice("--initial", *shared.initial, barycentric));
    return map;
  }

 private:
  vtkNew<vtkStretchEnergyMap> defaults_;
  std::optional<std::string> boundary_;
};

}  // namespace

std::unique_ptr<MapFamily> stretchFamily() { return std::make_unique<StretchFamily>(); }
std::unique_ptr<MapFamily> stretchEnergyFamily() { return std::make_unique<StretchEnergyFamily>(); }

}  // namespace authalic::cli
