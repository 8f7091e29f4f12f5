#include <utility>

#include <vtkLeastSquaresConformalMap.h>
#include <vtkNew.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> kinds = {"two-vertices", "spectral"};

class LeastSquaresFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"lscm"}; }

  std::string description() const override {
    return "lscm: conformal in the sense of least squares; a disk to --domain free (mm), the shape that distorts "
           "angles least; may fold and overlap.";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {{"--tolerance", "with --pins spectral, change of the boundary, of its mean radius (default: " +
                                shown(defaults_->GetTolerance()) + ")"},
            {"--max-iterations",
             "with --pins spectral (default: " + std::to_string(defaults_->GetMaximumIterations()) + ")"}};
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--pins", pins_,
                         "What keeps the map from shrinking: two-vertices (of the boundary, held at their distance) "
                         "or spectral (an eigenproblem; no vertex is special)."))
        ->type_name("KIND")
        ->default_str(kinds[static_cast<std::size_t>(defaults_->GetPins())]);
    own(verb->add_option("--pin-vertices", vertices_,
                         "The two boundary vertices, from 0; default: those farthest apart in space. With spectral "
                         "they only fix the rotation."))
        ->type_name("V W");
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session&) const override {
    if (shared.domain && shared.domain != "free") {
      throw Failure(UsageProblem, "--domain must be free for lscm, whose boundary takes its own shape; it is '" +
                                      *shared.domain + "' (harmonic and riemann map to a disk).");
    }
    const auto map = vtkSmartPointer<vtkLeastSquaresConformalMap>::New();
    if (pins_) map->SetPins(choice("--pins", *pins_, kinds));
    if ((shared.tolerance || shared.maxIterations) && map->GetPins() != vtkLeastSquaresConformalMap::SPECTRAL) {
      throw Failure(UsageProblem, "--tolerance and --max-iterations need --pins spectral; with two pins lscm is one "
                                  "linear solve.");
    }
    if (shared.tolerance) map->SetTolerance(*shared.tolerance);
    if (shared.maxIterations) map->SetMaximumIterations(*shared.maxIterations);
    map->SetFirstPin(vertices_.first);
    map->SetSecondPin(vertices_.second);
    return map;
  }

 private:
  vtkNew<vtkLeastSquaresConformalMap> defaults_;
  std::optional<std::string> pins_;
  std::pair<int, int> vertices_{defaults_->GetFirstPin(), defaults_->GetSecondPin()};
};

}  // namespace

std::unique_ptr<MapFamily> leastSquaresFamily() { return std::make_unique<LeastSquaresFamily>(); }

}  // namespace authalic::cli
