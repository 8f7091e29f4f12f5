#include <vtkBarycentricMap.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

class BarycentricFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"tutte", "harmonic", "mean-value"}; }

  std::string description() const override {
    return "tutte (combinatorial; never folds on a convex domain), harmonic (cotangent weights; low angle "
           "distortion, may fold), mean-value (nearly harmonic; never folds on a convex domain): a disk to --domain "
           "disk, square, rectangle:ASPECT or polygon:FILE.";
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string& method, const SharedMapOptions& shared,
                                                 const Session&) const override {
    const auto map = vtkSmartPointer<vtkBarycentricMap>::New();
    map->SetMethod(choice("METHOD", method, methods()));
    setDiskDomain(map, shared.domain);
    return map;
  }
};

}  // namespace

std::unique_ptr<MapFamily> barycentricFamily() { return std::make_unique<BarycentricFamily>(); }

}  // namespace authalic::cli
