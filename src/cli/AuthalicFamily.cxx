#include <vtkAuthalicMap.h>
#include <vtkCircleDomainAuthalicMap.h>
#include <vtkFlatConeAuthalicMap.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSphericalAuthalicMap.h>
#include <vtkToroidalAuthalicMap.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> initials = {"tutte", "harmonic", "mean-value"};

class AuthalicFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"authalic"}; }

  std::string description() const override {
    return "authalic: area-preserving, or to a measure of yours (--measure), exactly at every vertex and "
           "without a fold; a disk to --domain disk, square, rectangle:ASPECT or polygon:FILE, a closed "
           "surface of genus 0 to --domain sphere, a torus to --domain torus (flat, cut open, with "
           "OriginalPointIds), a closed surface of genus 2 or more to --domain flat-cones (flat but for cones, cut "
           "open), a surface with holes to --domain circle-domain (unit disk without round "
           "holes) or annulus (one hole, in the middle), a tube also to --domain periodic-rectangle (cut open).";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {
        {"--initial",
         oneOf(initials) + " for a disk, or a MAP.vtp to the same disk, polygon or sphere (default: tutte)"},
        {"--tolerance",
         "residual sqrt(D_area - 2) of faces (default: " + shown(defaults_->GetTolerance()) + ")"},
        {"--max-iterations", "steps (default: " + std::to_string(defaults_->GetMaximumIterations()) + ")"},
        {"--hole-areas", "--domain circle-domain and annulus"},
        {"--balance", "(default: " + shown(defaults_->GetBalance()) + ")"}};
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--vertex-tolerance", vertexTolerance_, "Largest |ln r| of a vertex star, > 0."))
        ->type_name("X")->default_str(shown(defaults_->GetVertexTolerance()));
    own(verb->add_flag("--hold-centres", holdCentres_,
                       "Holes stay where the conformal map has them (--domain circle-domain)."));
    own(verb->add_flag("--free-radii", freeRadii_,
                       "Radii of holes are found with the map, not from areas (--domain circle-domain, annulus)."));
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session& session) const override {
    const std::optional<double> weight = balanceNumber(shared);
    if ((holdCentres_ || freeRadii_) && shared.domain != "circle-domain" && shared.domain != "annulus") {
      throw Failure(UsageProblem, "--hold-centres and --free-radii need --domain circle-domain or annulus.");
    }
    if (const auto holed = holedFilter<vtkCircleDomainAuthalicMap>(shared)) {
      holed->SetHoldCentres(holdCentres_);
      holed->SetFreeRadii(freeRadii_);
      return configured(holed, shared, session);
    }
    if (shared.domain == "sphere") {
      const auto map = vtkSmartPointer<vtkSphericalAuthalicMap>::New();
      if (weight) map->SetBalance(*weight);
      return configured(map, shared, session);
    }
    if (shared.domain == "torus") return configured(vtkSmartPointer<vtkToroidalAuthalicMap>::New(), shared, session);
    if (shared.domain == "flat-cones") {
      return configured(vtkSmartPointer<vtkFlatConeAuthalicMap>::New(), shared, session);
    }
    const auto map = vtkSmartPointer<vtkAuthalicMap>::New();
    setDiskDomain(map, shared.domain);
    if (weight) map->SetBalance(*weight);
    return configured(map, shared, session);
  }

  void addArrays(vtkSurfaceMapAlgorithm* map, const SharedMapOptions& shared, vtkSmartPointer<vtkPolyData>& surface,
                 const Session& session) const override {
    const std::optional<std::string> array = balanceArray(shared, surface, session);
    if (!array) return;
    if (auto* disk = vtkAuthalicMap::SafeDownCast(map)) disk->SetBalanceArrayName(*array);
    if (auto* sphere = vtkSphericalAuthalicMap::SafeDownCast(map)) sphere->SetBalanceArrayName(*array);
  }

 private:
  template <class Filter>
  vtkSmartPointer<Filter> configured(vtkSmartPointer<Filter> map, const SharedMapOptions& shared,
                                     const Session& session) const {
    if (shared.tolerance) map->SetTolerance(*shared.tolerance);
    if (shared.maxIterations) map->SetMaximumIterations(*shared.maxIterations);
    if (vertexTolerance_) map->SetVertexTolerance(*vertexTolerance_);
    setInitial(map, vtkAuthalicMap::SafeDownCast(map), shared, initials, session);
    return map;
  }

  vtkNew<vtkAuthalicMap> defaults_;
  std::optional<double> vertexTolerance_;
  bool holdCentres_ = false, freeRadii_ = false;
};

}  // namespace

std::unique_ptr<MapFamily> authalicFamily() { return std::make_unique<AuthalicFamily>(); }

}  // namespace authalic::cli
