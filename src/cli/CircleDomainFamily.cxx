#include <vtkCircleDomainMap.h>
#include <vtkNew.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> roads = {"curvature", "koebe"};

class CircleDomainFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"circle-domain"}; }

  std::string description() const override {
    return "circle-domain: conformal; a surface of genus 0 with boundary loops to the unit disk without round holes "
           "(--domain circle-domain). Centre and radius of every loop are in field data and report.";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    auto options = flowOptions();
    options["--road"] = "curvature is one flow with the curvature of circles on every loop, koebe makes one loop after "
                        "the other round (default: " + roads[static_cast<std::size_t>(defaults_->GetRoad())] + ")";
    options["--centre"] = diskCentreMeaning();
    options["--outer-vertex"] =
        "a vertex of the loop that becomes the unit circle, from 0; -1 is the longest loop (default: -1)";
    return options;
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--roundness-tolerance", roundness_,
                         "--road koebe: how far a round loop may be from its circle, relative, > 0."))
        ->type_name("X")
        ->default_str(shown(defaults_->GetRoundnessTolerance()));
    own(verb->add_option("--max-rounds", maxRounds_, "--road koebe: most rounds over all loops."))
        ->type_name("N")
        ->check(notNegative())
        ->default_str(std::to_string(defaults_->GetMaximumRounds()));
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session&) const override {
    if (shared.domain && shared.domain != "circle-domain") {
      throw Failure(UsageProblem, "--domain must be circle-domain for circle-domain; it is '" + *shared.domain +
                                      "' (annulus maps two loops to concentric circles or a rectangle).");
    }
    const auto map = vtkSmartPointer<vtkCircleDomainMap>::New();
    setFlowOptions(map, shared);
    if (shared.road) map->SetRoad(choice("--road", *shared.road, roads));
    if (map->GetRoad() != vtkCircleDomainMap::KOEBE && (roundness_ || maxRounds_)) {
      throw Failure(UsageProblem, "--roundness-tolerance and --max-rounds need --road koebe; the road curvature takes "
                                  "one round.");
    }
    if (shared.outerVertex) map->SetOuterVertex(*shared.outerVertex);
    if (roundness_) map->SetRoundnessTolerance(*roundness_);
    if (maxRounds_) map->SetMaximumRounds(*maxRounds_);
    if (shared.centre) {
      const auto [what, id] = diskCentre(*shared.centre);
      map->SetCentre(what);
      map->SetCentreId(id);
    }
    return map;
  }

 private:
  vtkNew<vtkCircleDomainMap> defaults_;
  std::optional<double> roundness_;
  std::optional<int> maxRounds_;
};

}  // namespace

std::unique_ptr<MapFamily> circleDomainFamily() { return std::make_unique<CircleDomainFamily>(); }

}  // namespace authalic::cli
