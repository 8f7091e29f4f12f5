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
           "holes) or annulus (one hole, in the middle).";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {
        {"--initial",
         oneOf(initials) + " for a disk, or a MAP.vtp to the same disk, polygon or sphere (default: tutte)"},
        {"--tolerance",
         "residual sqrt(D_area - 2) of faces (default: " + shown(defaults_->GetTolerance()) + ")"},
        {"--max-iterations", "steps (default: " + std::to_string(defaults_->GetMaximumIterations()) + ")"}};
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--vertex-tolerance", vertexTolerance_, "Largest |ln r| of a vertex star, > 0."))
        ->type_name("X")->default_str(shown(defaults_->GetVertexTolerance()));
    own(verb->add_option("--balance", balance_,
                         "A disk to the disk: weight of the areas against the angles, 0 (conformal) to 1."))
        ->type_name("T")->default_str(shown(defaults_->GetBalance()))->check(CLI::Range(0.0, 1.0));
    own(verb->add_option(
            "--hole-areas", holeAreas_,
            "--domain circle-domain and annulus: area of every hole but the longest loop, mm^2, > 0, in the "
            "order of the loops' smallest vertex ids; by default, of the cones that close them."))
        ->type_name("AREA...");
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session& session) const override {
    if (balance_ && shared.domain.value_or("disk") != "disk") {
      throw Failure(UsageProblem, "--balance needs --domain disk; it is '" + *shared.domain + "'.");
    }
    if (shared.domain == "circle-domain" || shared.domain == "annulus") return holed(shared, session);
    if (!holeAreas_.empty()) {
      throw Failure(UsageProblem, "--hole-areas need --domain circle-domain or annulus.");
    }
    if (shared.domain == "sphere") return configured(vtkSmartPointer<vtkSphericalAuthalicMap>::New(), shared, session);
    if (shared.domain == "torus") return configured(vtkSmartPointer<vtkToroidalAuthalicMap>::New(), shared, session);
    if (shared.domain == "flat-cones") {
      return configured(vtkSmartPointer<vtkFlatConeAuthalicMap>::New(), shared, session);
    }
    const auto map = vtkSmartPointer<vtkAuthalicMap>::New();
    setDiskDomain(map, shared.domain);
    if (balance_) map->SetBalance(*balance_);
    return configured(map, shared, session);
  }

 private:
  vtkSmartPointer<vtkSurfaceMapAlgorithm> holed(const SharedMapOptions& shared, const Session& session) const {
    const auto map = vtkSmartPointer<vtkCircleDomainAuthalicMap>::New();
    map->SetConcentric(shared.domain == "annulus");
    for (const double area : holeAreas_) map->AddHoleArea(area);
    return configured(map, shared, session);
  }

  template <class Filter>
  vtkSmartPointer<Filter> configured(vtkSmartPointer<Filter> map, const SharedMapOptions& shared,
                                     const Session& session) const {
    if (shared.tolerance) map->SetTolerance(*shared.tolerance);
    if (shared.maxIterations) map->SetMaximumIterations(*shared.maxIterations);
    if (vertexTolerance_) map->SetVertexTolerance(*vertexTolerance_);
    if (!shared.initial) return map;
    if (isFile(*shared.initial) && map->GetNumberOfInputPorts() > 1) {
      map->SetInputData(1, readSurface(*shared.initial, session, shared.space));
    } else if (auto* disk = vtkAuthalicMap::SafeDownCast(map)) {
      disk->SetInitialMethod(choice("--initial", *shared.initial, initials));
    } else {
      throw Failure(UsageProblem, "--initial " + *shared.initial + " is not for --domain " + *shared.domain +
                                      "; leave it out, the start is found by the method.");
    }
    return map;
  }

  vtkNew<vtkAuthalicMap> defaults_;
  std::optional<double> vertexTolerance_, balance_;
  std::vector<double> holeAreas_;
};

}  // namespace

std::unique_ptr<MapFamily> authalicFamily() { return std::make_unique<AuthalicFamily>(); }

}  // namespace authalic::cli
