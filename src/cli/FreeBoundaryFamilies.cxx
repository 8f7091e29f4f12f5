#include <vtkLeastSquaresConformalMap.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSymmetricDirichletMap.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> pins = {"two-vertices", "spectral"};
const std::vector<std::string> starts = {"tutte", "mean-value"};

class LeastSquaresConformalFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"lscm"}; }

  std::string description() const override {
    return "lscm: angle-preserving in the least-squares sense, with a free boundary (--domain free); a disk. Faces may "
           "fold; slim never folds.";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {{"--tolerance",
             "change of the boundary, --pins spectral (default: " + shown(defaults_->GetTolerance()) + ")"},
            {"--max-iterations",
             "with --pins spectral (default: " + std::to_string(defaults_->GetMaximumIterations()) + ")"}};
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--pins", pins_, "What keeps the map from shrinking to a point: " + oneOf(pins) + "."))
        ->type_name("HOW")->default_str(pins.front());
    own(verb->add_option("--pinned", pinned_,
                         "Two boundary vertices, from 0, that are held (spectral: that fix the turn)."))
        ->type_name("FIRST SECOND")
        ->expected(2)
        ->default_str("the farthest apart")
        ->check(notNegative());
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session&) const override {
    if (shared.domain && *shared.domain != "free") {
      throw Failure(UsageProblem, "--domain of method lscm is free; it is '" + *shared.domain + "'.");
    }
    const auto map = vtkSmartPointer<vtkLeastSquaresConformalMap>::New();
    if (pins_) map->SetPins(choice("--pins", *pins_, pins));
    if (!pinned_.empty()) {
      map->SetFirstPin(pinned_[0]);
      map->SetSecondPin(pinned_[1]);
    }
    if ((shared.tolerance || shared.maxIterations) && map->GetPins() != vtkLeastSquaresConformalMap::SPECTRAL) {
      throw Failure(UsageProblem, "--tolerance and --max-iterations of lscm need --pins spectral.");
    }
    if (shared.tolerance) map->SetTolerance(*shared.tolerance);
    if (shared.maxIterations) map->SetMaximumIterations(*shared.maxIterations);
    return map;
  }

 private:
  vtkNew<vtkLeastSquaresConformalMap> defaults_;
  std::optional<std::string> pins_;
  std::vector<int> pinned_;
};

class SymmetricDirichletFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"slim"}; }

  std::string description() const override {
    return "slim: as isometric as can be without a fold (symmetric Dirichlet energy); a disk, with a free "
           "boundary (--domain free, the default) or one that stays where the start has it, the unit circle "
           "unless --initial is a MAP.vtp (--domain disk).";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {{"--initial", oneOf(starts) + ", or an unfolded planar MAP.vtp (default: " + starts.front() + ")"},
            {"--tolerance", "of the Newton decrement (default: " + shown(defaults_->GetTolerance()) + ")"},
            {"--max-iterations",
             "Newton steps (default: " + std::to_string(defaults_->GetMaximumIterations()) + ")"}};
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session& session) const override {
    const std::string domain = shared.domain.value_or("free");
    if (domain != "free" && domain != "disk") {
      throw Failure(UsageProblem, "--domain of method slim is free or disk; it is '" + domain + "'.");
    }
    const auto map = vtkSmartPointer<vtkSymmetricDirichletMap>::New();
    if (domain == "disk") map->SetBoundaryToFixed();
    if (shared.tolerance) map->SetTolerance(*shared.tolerance);
    if (shared.maxIterations) map->SetMaximumIterations(*shared.maxIterations);
    if (!shared.initial) return map;
    if (isFile(*shared.initial)) map->SetInputData(1, readSurface(*shared.initial, session, shared.space));
    else map->SetInitialMethod(choice("--initial", *shared.initial, starts));
    return map;
  }

 private:
  vtkNew<vtkSymmetricDirichletMap> defaults_;
};

}  // namespace

std::unique_ptr<MapFamily> leastSquaresConformalFamily() { return std::make_unique<LeastSquaresConformalFamily>(); }
std::unique_ptr<MapFamily> symmetricDirichletFamily() { return std::make_unique<SymmetricDirichletFamily>(); }

}  // namespace authalic::cli
