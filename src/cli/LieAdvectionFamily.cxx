#include <vtkLieAdvection.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSphericalLieAdvection.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> initials = {"tutte", "harmonic", "mean-value"};

class LieAdvectionFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"lie-advection"}; }

  std::string description() const override {
    return "lie-advection: area-preserving, or to a measure of yours (--measure), as far as a number of steps "
           "(--steps) takes it; a disk to --domain disk, square, rectangle:ASPECT or polygon:FILE, a closed surface of "
           "genus 0 to --domain sphere. For comparison with the literature; authalic is exact.";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {{"--initial", oneOf(initials) + " for a disk, or a MAP.vtp to the same domain (default: " +
                              initials[static_cast<std::size_t>(defaults_->GetInitialMethod())] +
                              "; on the sphere, a conformal map)"}};
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--steps", steps_, "Steps; the error falls as they grow, the time grows with them."))
        ->type_name("K")
        ->check(CLI::Range(1, 1000000))
        ->default_str(std::to_string(defaults_->GetNumberOfSteps()));
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session& session) const override {
    if (shared.domain == "sphere") {
      return configured(vtkSmartPointer<vtkSphericalLieAdvection>::New(), shared, session);
    }
    const auto advection = vtkSmartPointer<vtkLieAdvection>::New();
    setDiskDomain(advection, shared.domain);
    return configured(advection, shared, session);
  }

 private:
  template <class Filter>
  vtkSmartPointer<Filter> configured(vtkSmartPointer<Filter> advection, const SharedMapOptions& shared,
                                     const Session& session) const {
    if (steps_) advection->SetNumberOfSteps(*steps_);
    setInitial(advection, vtkLieAdvection::SafeDownCast(advection), shared, initials, session);
    return advection;
  }

  vtkNew<vtkLieAdvection> defaults_;
  std::optional<int> steps_;
};

}  // namespace

std::unique_ptr<MapFamily> lieAdvectionFamily() { return std::make_unique<LieAdvectionFamily>(); }

}  // namespace authalic::cli
