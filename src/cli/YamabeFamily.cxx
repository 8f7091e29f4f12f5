#include <vtkPolyData.h>
#include <vtkYamabeMap.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

class YamabeFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"yamabe"}; }

  std::string description() const override {
    return "yamabe: conformal by curvature flow, in mm; a disk to a round --domain disk (default), or with "
           "--curvature to the --domain free whose boundary turns as you say.";
  }

  std::map<std::string, std::string> sharedOptions() const override { return flowOptions(); }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--curvature", curvature_,
                         "Angle by which the boundary turns at every vertex, radians, 0 at inner vertices, 2 pi in "
                         "all (a corner of a rectangle: pi/2, straight sides: 0): an array of SURFACE, or a file."))
        ->type_name("ARRAY|FILE");
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session&) const override {
    const bool free = !curvature_.empty();
    const std::string domain = shared.domain.value_or(free ? "free" : "disk");
    if (domain != "disk" && domain != "free") {
      throw Failure(UsageProblem, "--domain must be disk or free for yamabe; it is '" + domain +
                                      "' (corners come with --curvature).");
    }
    if (free && domain == "disk") {
      throw Failure(UsageProblem, "--domain disk and --curvature exclude each other: the curvature of a circle is "
                                  "found by yamabe; leave one out.");
    }
    if (!free && domain == "free") {
      throw Failure(UsageProblem, "--domain free needs --curvature ARRAY|FILE, which says how the boundary turns.");
    }
    const auto map = vtkSmartPointer<vtkYamabeMap>::New();
    setFlowOptions(map, shared);
    return map;
  }

  void addArrays(vtkSurfaceMapAlgorithm* map, vtkSmartPointer<vtkPolyData>& surface,
                 const Session& session) const override {
    if (curvature_.empty()) return;
    vtkYamabeMap::SafeDownCast(map)->SetCurvatureArrayName(arrayOf(surface, curvature_, session));
  }

 private:
  std::string curvature_;
};

}  // namespace

std::unique_ptr<MapFamily> yamabeFamily() { return std::make_unique<YamabeFamily>(); }

}  // namespace authalic::cli
