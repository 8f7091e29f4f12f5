#include <algorithm>
#include <tuple>

#include <vtkAnnulusMap.h>
#include <vtkCircleDomainMap.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRiemannMap.h>
#include <vtkYamabeMap.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> metrics = {"vertex-scaling", "circle-packing"};
const std::vector<std::string> radii = {"tangent", "circumradius"};
const std::vector<std::string> riemannRoads = {"boundary", "puncture"};
const std::vector<std::string> circleRoads = {"curvature", "koebe"};

class ConformalFlowFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"riemann", "yamabe", "circle-domain", "annulus"}; }

  std::string description() const override {
    return "riemann, yamabe, circle-domain, annulus: angle-preserving, by flows of curvature. riemann: a "
           "disk onto the unit disk. yamabe: a disk to the plane, the boundary a circle or turning as "
           "--curvature says (--domain free). circle-domain: genus 0 with one or more boundary loops onto "
           "the unit disk without round holes. annulus: two loops onto a ring, or with --domain rectangle "
           "onto a rectangle that is periodic in x (cut open, with OriginalPointIds); the conformal modulus "
           "is in the report.";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {{"--tolerance", "max |K - target K| in radians (default: " + shown(defaults_->GetTolerance()) + ")"},
            {"--max-iterations",
             "Newton steps (default: " + std::to_string(defaults_->GetMaximumIterations()) + ")"},
            {"--no-unfold", "what the conformal map folds"}};
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--metric", metric_, "How lengths follow the scale factors: " + oneOf(metrics) + "."))
        ->type_name("HOW")->default_str(metrics.front());
    own(verb->add_option("--packing-radii", radii_, "First radii of a circle packing: " + oneOf(radii) + "."))
        ->type_name("HOW")->default_str(radii.front());
    own(verb->add_option("--road", road_, "riemann: " + oneOf(riemannRoads) + "; circle-domain: " +
                                              oneOf(circleRoads) + "."))
        ->type_name("HOW");
    own(verb->add_option("--centre", centre_,
                         "riemann, circle-domain: what goes to the centre of the disk: area, vertex:ID or face:ID."))
        ->type_name("WHAT")->default_str("area");
    own(verb->add_option("--start-vertex", startVertex_, "Vertex of the (outer) boundary at angle 0, from 0."))
        ->type_name("ID")->check(notNegative());
    own(verb->add_option("--outer-vertex", outerVertex_,
                         "annulus, circle-domain: a vertex of the loop that becomes the outer circle, from 0."))
        ->type_name("ID")->default_str("one of the longest loop")->check(notNegative());
    own(verb->add_option("--puncture", puncture_, "riemann by the road puncture: the face taken out, from 0."))
        ->type_name("FACE")->default_str("the farthest from the boundary")->check(notNegative());
    own(verb->add_option(
            "--curvature", curvature_,
            "yamabe: point array of SURFACE with the turning angles of the boundary (sum 2 pi, 0 inside)."))
        ->type_name("ARRAY");
    own(verb->add_flag("--refine", refine_,
                       "All but annulus: the map on the common refinement of SURFACE and flow, where nothing folds."));
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string& method, const SharedMapOptions& shared,
                                                 const Session&) const override {
    refuseWhatIsNotFor(method);
    const vtkSmartPointer<vtkConformalFlowAlgorithm> map = make(method, shared.domain);
    if (shared.tolerance) map->SetTolerance(*shared.tolerance);
    if (shared.maxIterations) map->SetMaximumIterations(*shared.maxIterations);
    map->SetUnfold(!shared.noUnfold);
    if (metric_) map->SetMetric(choice("--metric", *metric_, metrics));
    if (radii_ && map->GetMetric() != vtkConformalFlowAlgorithm::CIRCLE_PACKING) {
      throw Failure(UsageProblem, "--packing-radii needs --metric circle-packing.");
    }
    if (radii_) map->SetPackingRadii(choice("--packing-radii", *radii_, radii));
    if (auto* disk = vtkUnitDiskConformalAlgorithm::SafeDownCast(map)) place(disk);
    return map;
  }

 private:
  void refuseWhatIsNotFor(const std::string& method) const {
    const std::tuple<const char*, bool, std::vector<std::string>> owners[] = {
        {"--road", road_.has_value(), {"riemann", "circle-domain"}},
        {"--centre", centre_.has_value(), {"riemann", "circle-domain"}},
        {"--outer-vertex", outerVertex_.has_value(), {"annulus", "circle-domain"}},
        {"--puncture", puncture_.has_value(), {"riemann"}},
        {"--curvature", curvature_.has_value(), {"yamabe"}},
        {"--refine", refine_, {"riemann", "yamabe", "circle-domain"}}};
    for (const auto& [option, given, names] : owners) {
      if (!given || std::find(names.begin(), names.end(), method) != names.end()) continue;
      throw Failure(UsageProblem, std::string(option) + " belongs to " + oneOf(names) + "; method " + method +
                                      " has no such option.");
    }
  }

  static void requireDomain(const std::string& method, const std::optional<std::string>& domain,
                            const std::vector<std::string>& allowed) {
    if (!domain || std::find(allowed.begin(), allowed.end(), *domain) != allowed.end()) return;
    throw Failure(UsageProblem,
                  "--domain of method " + method + " is " + oneOf(allowed) + "; it is '" + *domain + "'.");
  }

  vtkSmartPointer<vtkConformalFlowAlgorithm> make(const std::string& method,
                                                  const std::optional<std::string>& domain) const {
    if (method == "riemann") return riemann(domain);
    if (method == "yamabe") return yamabe(domain);
    if (method == "annulus") return annulus(domain);
    requireDomain(method, domain, {"circle-domain"});
    const auto map = vtkSmartPointer<vtkCircleDomainMap>::New();
    if (road_) map->SetRoad(choice("--road", *road_, circleRoads));
    if (outerVertex_) map->SetOuterVertex(*outerVertex_);
    return map;
  }

  vtkSmartPointer<vtkConformalFlowAlgorithm> riemann(const std::optional<std::string>& domain) const {
    requireDomain("riemann", domain, {"disk"});
    const auto map = vtkSmartPointer<vtkRiemannMap>::New();
    if (road_) map->SetRoad(choice("--road", *road_, riemannRoads));
    if (puncture_ && map->GetRoad() != vtkRiemannMap::PUNCTURE) {
      throw Failure(UsageProblem, "--puncture FACE needs --road puncture.");
    }
    if (puncture_) map->SetPuncturedFace(*puncture_);
    return map;
  }

  vtkSmartPointer<vtkConformalFlowAlgorithm> yamabe(const std::optional<std::string>& domain) const {
    requireDomain("yamabe", domain, {"disk", "free"});
    if (domain && (*domain == "free") != curvature_.has_value()) {
      throw Failure(UsageProblem,
                    "--domain free and --curvature ARRAY belong together; without them the boundary becomes "
                    "a circle.");
    }
    const auto map = vtkSmartPointer<vtkYamabeMap>::New();
    if (curvature_) map->SetCurvatureArrayName(*curvature_);
    if (startVertex_) map->SetStartVertex(*startVertex_);
    map->SetRefine(refine_);
    return map;
  }

  vtkSmartPointer<vtkConformalFlowAlgorithm> annulus(const std::optional<std::string>& domain) const {
    requireDomain("annulus", domain, {"annulus", "rectangle"});
    const auto map = vtkSmartPointer<vtkAnnulusMap>::New();
    if (domain.value_or("annulus") == "rectangle") map->SetDomainToRectangle();
    if (outerVertex_) map->SetOuterVertex(*outerVertex_);
    if (startVertex_) map->SetStartVertex(*startVertex_);
    return map;
  }

  void place(vtkUnitDiskConformalAlgorithm* map) const {
    if (startVertex_) map->SetStartVertex(*startVertex_);
    map->SetRefine(refine_);
    const std::string centre = centre_.value_or("area");
    if (centre == "area") return;
    const std::size_t colon = centre.find(':');
    int id = -1;
    const std::string what = centre.substr(0, colon);
    if ((what != "vertex" && what != "face") || colon == std::string::npos ||
        !CLI::detail::lexical_cast(centre.substr(colon + 1), id) || id < 0) {
      throw Failure(UsageProblem, "--centre must be area, vertex:ID or face:ID; it is '" + centre + "'.");
    }
    map->SetCentre(what == "vertex" ? vtkUnitDiskConformalAlgorithm::VERTEX : vtkUnitDiskConformalAlgorithm::FACE);
    map->SetCentreId(id);
  }

  vtkNew<vtkRiemannMap> defaults_;
  std::optional<std::string> metric_, radii_, road_, centre_, curvature_;
  std::optional<int> startVertex_, outerVertex_, puncture_;
  bool refine_ = false;
};

}  // namespace

std::unique_ptr<MapFamily> conformalFlowFamily() { return std::make_unique<ConformalFlowFamily>(); }

}  // namespace authalic::cli
