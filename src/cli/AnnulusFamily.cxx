#include <vtkAnnulusMap.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> domains = {"annulus", "rectangle"};

class AnnulusFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"annulus"}; }

  std::string description() const override {
    return "annulus: conformal; a surface with two boundary loops to a concentric --domain annulus (default), or to a "
           "--domain rectangle that is periodic in x with period 1: cut open, with OriginalPointIds. Height, "
           "circumference and conformal modulus are in field data and report.";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    auto options = flowOptions();
    options["--outer-vertex"] =
        "a vertex of the loop that becomes the outer circle or y = 0, from 0; -1 is the longer loop (default: -1)";
    return options;
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session&) const override {
    const auto map = vtkSmartPointer<vtkAnnulusMap>::New();
    setFlowOptions(map, shared);
    if (shared.domain) map->SetDomain(choice("--domain", *shared.domain, domains));
    if (shared.outerVertex) map->SetOuterVertex(*shared.outerVertex);
    return map;
  }
};

}  // namespace

std::unique_ptr<MapFamily> annulusFamily() { return std::make_unique<AnnulusFamily>(); }

}  // namespace authalic::cli
