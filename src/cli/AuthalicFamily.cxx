#include <vtkAuthalicMap.h>
#include <vtkCircleDomainAuthalicMap.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSphericalAuthalicMap.h>
#include <vtkToroidalAuthalicMap.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

class AuthalicFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"authalic"}; }

  std::string description() const override {
    return "authalic: area-preserving, or to a measure of yours (--measure), exactly at every vertex and "
           "without a fold; a "
           "disk to --domain disk, square, rectangle:ASPECT or polygon:FILE, a closed surface of genus 0 to "
           "--domain sphere, a torus to --domain torus (flat, cut open, with OriginalPointIds), a "
           "surface with holes to --domain circle-domain (unit disk without round holes) or annulus (one hole, in the "
           "middle).";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {
        {"--initial", "a MAP.vtp to the same disk, polygon or sphere (default: Tutte's)"},
        {"--tolerance",
         "residual sqrt(D_area - 2) of faces (default: " + shown(defaults_->GetTolerance()) + ")"},
        {"--outer-vertex",
         "of circle-domain and annulus, a vertex of the loop that becomes the unit circle, from 0; "
         "-1 is the longest loop (default: -1)"},
        {"--max-iterations", "steps (default: " + std::to_string(defaults_->GetMaximumIterations()) + ")"}};
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--vertex-tolerance", vertexTolerance_, "Largest |ln r| of a vertex star, > 0."))
        ->type_name("X")->default_str(shown(defaults_->GetVertexTolerance()));
    own(verb->add_option(
            "--hole-areas", holeAreas_,
            "Of circle-domain and annulus: area of every hole but the outer loop, mm^2, > 0, in the order of "
            "the loops' smallest vertex ids; by default, of the cones that close them."))
        ->type_name("AREA...");
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session& session) const override {
    if (shared.domain == "circle-domain" || shared.domain == "annulus") return holed(shared, session);
    if (!holeAreas_.empty() || shared.outerVertex) {
      throw Failure(UsageProblem, "--hole-areas and --outer-vertex need --domain circle-domain or annulus.");
    }
    if (shared.domain == "sphere") return configured(vtkSmartPointer<vtkSphericalAuthalicMap>::New(), shared, session);
    if (shared.domain == "torus") return configured(vtkSmartPointer<vtkToroidalAuthalicMap>::New(), shared, session);
    const auto map = vtkSmartPointer<vtkAuthalicMap>::New();
    setDiskDomain(map, shared.domain);
    return configured(map, shared, session);
  }

 private:
  vtkSmartPointer<vtkSurfaceMapAlgorithm> holed(const SharedMapOptions& shared, const Session& session) const {
    const auto map = vtkSmartPointer<vtkCircleDomainAuthalicMap>::New();
    map->SetConcentric(shared.domain == "annulus");
    if (shared.outerVertex) map->SetOuterVertex(*shared.outerVertex);
    for (const double area : holeAreas_) map->AddHoleArea(area);
    return configured(map, shared, session);
  }

  template <class Filter>
  vtkSmartPointer<Filter> configured(vtkSmartPointer<Filter> map, const SharedMapOptions& shared,
                                     const Session& session) const {
    if (shared.tolerance) map->SetTolerance(*shared.tolerance);
    if (shared.maxIterations) map->SetMaximumIterations(*shared.maxIterations);
    if (vertexTolerance_) map->SetVertexTolerance(*vertexTolerance_);
    if (shared.initial) {
      if (map->GetNumberOfInputPorts() < 2) {
        throw Failure(UsageProblem,
                      "--initial is not for --domain " + *shared.domain + "; the start is found with it.");
      }
      map->SetInputData(1, readSurface(*shared.initial, session, shared.space));
    }
    return map;
  }

  vtkNew<vtkAuthalicMap> defaults_;
  std::optional<double> vertexTolerance_;
  std::vector<double> holeAreas_;
};

}  // namespace

std::unique_ptr<MapFamily> authalicFamily() { return std::make_unique<AuthalicFamily>(); }

}  // namespace authalic::cli
