#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSymmetricDirichletMap.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> initials = {"tutte", "harmonic", "mean-value"};
const std::vector<std::string> boundaries = {"free", "fixed"};

class IsometricFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"slim"}; }

  std::string description() const override {
    return "slim: as isometric as can be (symmetric Dirichlet energy), never folds; a disk with a --domain free "
           "boundary (default; mm), or with the boundary fixed on --domain disk, square, rectangle:ASPECT or "
           "polygon:FILE, or where --initial MAP.vtp has it (--boundary fixed).";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {{"--initial", oneOf(initials) + ", or a MAP.vtp in the plane without folds (default: " +
                              initials[static_cast<std::size_t>(defaults_->GetInitialMethod())] + ")"},
            {"--tolerance", "Newton decrement (default: " + shown(defaults_->GetTolerance()) + ")"},
            {"--max-iterations", "Newton steps (default: " + std::to_string(defaults_->GetMaximumIterations()) + ")"}};
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--boundary", boundary_,
                         "What the boundary of --initial MAP.vtp may do: " + oneOf(boundaries) + "."))
        ->type_name("HOW")
        ->default_str(boundaries[static_cast<std::size_t>(defaults_->GetBoundary())]);
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session& session) const override {
    const auto map = vtkSmartPointer<vtkSymmetricDirichletMap>::New();
    const bool given = shared.initial && isFile(*shared.initial);
    setBoundary(map, shared.domain, given);
    if (shared.tolerance) map->SetTolerance(*shared.tolerance);
    if (shared.maxIterations) map->SetMaximumIterations(*shared.maxIterations);
    if (given) map->SetInputData(1, readSurface(*shared.initial, session, shared.space));
    else if (shared.initial) map->SetInitialMethod(choice("--initial", *shared.initial, initials));
    return map;
  }

 private:
  void setBoundary(vtkSymmetricDirichletMap* map, const std::optional<std::string>& domain, bool given) const {
    if (boundary_ && !given) {
      throw Failure(UsageProblem,
                    "--boundary needs --initial MAP.vtp; without it --domain says what the boundary does.");
    }
    if (boundary_) map->SetBoundary(choice("--boundary", *boundary_, boundaries));
    if (!domain || domain == "free") {
      if (domain && map->GetBoundary() == vtkSymmetricDirichletMap::FIXED) {
        throw Failure(UsageProblem, "--domain free and --boundary fixed exclude each other; leave one out.");
      }
      return;
    }
    if (given) {
      throw Failure(UsageProblem, "--domain " + *domain + " cannot be asked for with --initial MAP.vtp, whose boundary "
                                  "is where it is; --boundary fixed keeps it there.");
    }
    setDiskDomain(map, domain);
    map->SetBoundaryToFixed();
  }

  vtkNew<vtkSymmetricDirichletMap> defaults_;
  std::optional<std::string> boundary_;
};

}  // namespace

std::unique_ptr<MapFamily> isometricFamily() { return std::make_unique<IsometricFamily>(); }

}  // namespace authalic::cli
