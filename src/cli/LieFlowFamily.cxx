#include <vtkCircleDomainLieFlow.h>
#include <vtkDiscreteLieFlow.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSphericalLieFlow.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> initials = {"tutte", "harmonic", "mean-value"};
const std::vector<std::string> finishes = {"none", "unfold", "match"};

class LieFlowFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"lie-flow"}; }

  std::string description() const override {
    return "lie-flow: area-preserving, or to a measure of yours (--measure); a disk to --domain disk, square, "
           "rectangle:ASPECT or polygon:FILE (convex or not), a closed surface of genus 0 to --domain sphere, a "
           "surface with holes to --domain circle-domain or annulus, a tube also to --domain periodic-rectangle (cut "
           "open, with OriginalPointIds).";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {{"--initial", oneOf(initials) + " for a disk, or a MAP.vtp to the same disk, polygon or sphere (default: " +
                              initials[static_cast<std::size_t>(defaults_->GetInitialMethod())] +
                              "; on the sphere, a conformal map)"},
            {"--tolerance",
             "residual sqrt(sum m (r - 1)^2) of vertex stars (default: " + shown(defaults_->GetTolerance()) + ")"},
            {"--max-iterations",
             "steps of the flow (default: " + std::to_string(defaults_->GetMaximumIterations()) + ")"},
            {"--hole-areas", "--domain circle-domain and annulus"},
            {"--finish", "after the flow, on the input's connectivity: " + oneOf(finishes) + " areas (default: " +
                             finishes[static_cast<std::size_t>(defaults_->GetFinish())] + ")"}};
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--step-ratio", stepRatio_,
                         "Step as a part of the first flip of a triangle, between 0 and 1."))
        ->type_name("X")
        ->default_str(shown(defaults_->GetStepRatio()));
    own(verb->add_option("--fixed-step", fixedStep_,
                         "This step instead of the adaptive one; 0 = adaptive. May collapse the mesh."))
        ->type_name("X")
        ->default_str(shown(defaults_->GetFixedStep()));
    own(verb->add_flag("--keep-initial", keepInitial_,
                       "Disks: flow from the initial map however far off it is: nearer to transport, slower."));
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session& session) const override {
    const auto holed = holedFilter<vtkCircleDomainLieFlow>(shared);
    if (keepInitial_ && (holed || shared.domain == "sphere")) {
      throw Failure(UsageProblem, "--keep-initial is for disks: --domain disk, square, rectangle or polygon.");
    }
    if (holed) return configured(holed, shared, session);
    if (shared.domain == "sphere") return configured(vtkSmartPointer<vtkSphericalLieFlow>::New(), shared, session);
    const auto flow = vtkSmartPointer<vtkDiscreteLieFlow>::New();
    setDiskDomain(flow, shared.domain);
    flow->SetKeepInitial(keepInitial_);
    return configured(flow, shared, session);
  }

 private:
  template <class Filter>
  vtkSmartPointer<Filter> configured(vtkSmartPointer<Filter> flow, const SharedMapOptions& shared,
                                     const Session& session) const {
    if (shared.tolerance) flow->SetTolerance(*shared.tolerance);
    if (shared.maxIterations) flow->SetMaximumIterations(*shared.maxIterations);
    if (fixedStep_) flow->SetFixedStep(*fixedStep_);
    if (stepRatio_) flow->SetStepRatio(*stepRatio_);
    if (shared.finish) flow->SetFinish(choice("--finish", *shared.finish, finishes));
    setInitial(flow, vtkDiscreteLieFlow::SafeDownCast(flow), shared, initials, session);
    return flow;
  }

  vtkNew<vtkDiscreteLieFlow> defaults_;
  std::optional<double> fixedStep_, stepRatio_;
  bool keepInitial_ = false;
};

}  // namespace

std::unique_ptr<MapFamily> lieFlowFamily() { return std::make_unique<LieFlowFamily>(); }

}  // namespace authalic::cli
