#include <vtkNew.h>
#include <vtkRiemannMap.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> roads = {"boundary", "puncture"};

class RiemannFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"riemann"}; }

  std::string description() const override {
    return "riemann: conformal; a disk to the unit --domain disk, with a face or vertex of your choice at the centre.";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    auto options = flowOptions();
    options["--road"] =
        "boundary prescribes the curvature of a circle there, puncture takes out a face, makes the rest "
        "a flat cylinder and closes it by the exponential (default: " +
        roads[static_cast<std::size_t>(defaults_->GetRoad())] + ")";
    options["--centre"] = diskCentreMeaning();
    return options;
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--puncture", puncture_,
                         "Face taken out on the road puncture, from 0, without a vertex on the boundary; -1 is the "
                         "one farthest from it."))
        ->type_name("FACE")
        ->default_str(std::to_string(defaults_->GetPuncture()));
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session&) const override {
    if (shared.domain && shared.domain != "disk") {
      throw Failure(UsageProblem, "--domain must be disk for riemann; it is '" + *shared.domain +
                                      "' (yamabe --curvature maps to polygons, lscm with a free boundary).");
    }
    const auto map = vtkSmartPointer<vtkRiemannMap>::New();
    setFlowOptions(map, shared);
    if (shared.road) map->SetRoad(choice("--road", *shared.road, roads));
    if (puncture_ && map->GetRoad() != vtkRiemannMap::PUNCTURE) {
      throw Failure(UsageProblem, "--puncture needs --road puncture; the road boundary takes no face out.");
    }
    if (puncture_) map->SetPuncture(*puncture_);
    if (shared.centre) {
      const auto [what, id] = diskCentre(*shared.centre);
      map->SetCentre(what);
      map->SetCentreId(id);
    }
    return map;
  }

 private:
  vtkNew<vtkRiemannMap> defaults_;
  std::optional<int> puncture_;
};

}  // namespace

std::unique_ptr<MapFamily> riemannFamily() { return std::make_unique<RiemannFamily>(); }

}  // namespace authalic::cli
