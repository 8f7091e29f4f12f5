#include <vtkNew.h>
#include <vtkRiemannMap.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> roads = {"boundary", "puncture"};
const std::vector<std::string> centres = {"area-centroid", "vertex", "face"};

class RiemannFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"riemann"}; }

  std::string description() const override {
    return "riemann: conformal; a disk to the unit --domain disk, with a face or vertex of your choice at the centre.";
  }

  std::map<std::string, std::string> sharedOptions() const override { return flowOptions(); }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--road", road_,
                         "boundary: prescribes the curvature of a circle there; puncture: takes out a face, makes the "
                         "rest a flat cylinder and closes it by the exponential."))
        ->type_name("ROAD")
        ->default_str(roads[static_cast<std::size_t>(defaults_->GetRoad())]);
    own(verb->add_option("--puncture", puncture_,
                         "Face taken out on the road puncture, from 0, without a vertex on the boundary; -1 is the "
                         "one farthest from it."))
        ->type_name("FACE")
        ->default_str(std::to_string(defaults_->GetPuncture()));
    own(verb->add_option("--centre", centre_,
                         "What goes to the centre: area-centroid, vertex:V or face:F (from 0)."))
        ->type_name("WHAT")
        ->default_str(centres[static_cast<std::size_t>(defaults_->GetCentre())]);
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session&) const override {
    if (shared.domain && shared.domain != "disk") {
      throw Failure(UsageProblem, "--domain must be disk for riemann; it is '" + *shared.domain +
                                      "' (yamabe --curvature maps to polygons, lscm with a free boundary).");
    }
    const auto map = vtkSmartPointer<vtkRiemannMap>::New();
    setFlowOptions(map, shared);
    if (road_) map->SetRoad(choice("--road", *road_, roads));
    if (puncture_ && map->GetRoad() != vtkRiemannMap::PUNCTURE) {
      throw Failure(UsageProblem, "--puncture needs --road puncture; the road boundary takes no face out.");
    }
    if (puncture_) map->SetPuncture(*puncture_);
    if (centre_) setCentre(map, *centre_);
    return map;
  }

 private:
  static void setCentre(vtkRiemannMap* map, const std::string& text) {
    if (text == centres.front()) return map->SetCentreToAreaCentroid();
    const std::size_t colon = text.find(':');
    const std::string what = text.substr(0, colon);
    int id = 0;
    if (colon == std::string::npos || (what != "vertex" && what != "face") ||
        !CLI::detail::lexical_cast(text.substr(colon + 1), id)) {
      throw Failure(UsageProblem, "--centre must be area-centroid, vertex:V or face:F; it is '" + text + "'.");
    }
    map->SetCentre(what == "face" ? vtkRiemannMap::FACE : vtkRiemannMap::VERTEX);
    map->SetCentreId(id);
  }

  vtkNew<vtkRiemannMap> defaults_;
  std::optional<std::string> road_, centre_;
  std::optional<int> puncture_;
};

}  // namespace

std::unique_ptr<MapFamily> riemannFamily() { return std::make_unique<RiemannFamily>(); }

}  // namespace authalic::cli
