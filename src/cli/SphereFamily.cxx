#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSphericalConformalMap.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> roads = {"harmonic", "stereographic", "mean-curvature-flow", "welding"};
const std::vector<std::string> starts = {"dipole", "tutte", "gauss-map"};
const std::vector<std::string> rotations = {"surface", "principal-axes", "landmarks", "none"};

class SphereFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"sphere", "welding"}; }

  std::string description() const override {
    return "sphere: angle-preserving; a closed surface of genus 0 to the unit sphere, by one of the roads of "
           "--initial, its centre of mass at 0. welding: the same by that road.";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {{"--initial", "the road: " + oneOf(roads) + " (default: " + nameOf(roads, defaults_->GetInitialMethod()) +
                              "); welding has its own"},
            {"--tolerance", "residual of the road (default: its own; none for stereographic)"},
            {"--max-iterations", "of the road (default: its own)"},
            {"--no-unfold", "what the road folds"}};
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--rotation", rotation_, "How the sphere is turned: " + oneOf(rotations) + "."))
        ->type_name("HOW")->default_str(nameOf(rotations, defaults_->GetRotation()));
    own(verb->add_option("--landmarks", landmarks_,
                         "Turn by two vertices: the first to the north pole, the second to y = 0, x > 0."))
        ->type_name("NORTH MERIDIAN")->expected(2)->check(notNegative());
    own(verb->add_option("--harmonic-start", start_, "Where the road harmonic starts: " + oneOf(starts) + "."))
        ->type_name("HOW")->default_str(nameOf(starts, defaults_->GetHarmonicStart()));
    own(verb->add_option("--punctured-face", puncturedFace_,
                         "Face that holds the pole (stereographic, dipole, tutte), from 0."))
        ->type_name("FACE")->default_str("the most regular")->check(notNegative());
    own(verb->add_option("--corrected-share", correctedShare_,
                         "Share of the area that stereographic places anew in a second chart, 0 to below 1."))
        ->type_name("X")->default_str(shown(defaults_->GetCorrectedShare()));
    own(verb->add_option("--time-step", timeStep_, "Step of mean-curvature-flow, the area being 4 pi, > 0."))
        ->type_name("X")->default_str(shown(defaults_->GetTimeStep()));
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string& method, const SharedMapOptions& shared,
                                                 const Session&) const override {
    if (shared.domain && *shared.domain != "sphere") {
      throw Failure(UsageProblem, "Method " + method + " has the domain sphere only; it is '" + *shared.domain + "'.");
    }
    const auto map = vtkSmartPointer<vtkSphericalConformalMap>::New();
    setRoad(map, method, shared);
    setRotation(map);
    if (start_) map->SetHarmonicStart(choice("--harmonic-start", *start_, starts));
    if (puncturedFace_) map->SetPuncturedFace(*puncturedFace_);
    if (correctedShare_) map->SetCorrectedShare(*correctedShare_);
    if (timeStep_) map->SetTimeStep(*timeStep_);
    map->SetUnfold(!shared.noUnfold);
    return map;
  }

 private:
  static std::string nameOf(const std::vector<std::string>& names, int value) {
    return names[static_cast<std::size_t>(value)];
  }

  static void setRoad(vtkSphericalConformalMap* map, const std::string& method, const SharedMapOptions& shared) {
    if (method == "welding") {
      if (shared.initial.value_or("welding") != "welding") {
        throw Failure(UsageProblem, "Method welding is a road of its own; for --initial " + *shared.initial +
                                        " take method sphere.");
      }
      map->SetInitialMethodToWelding();
    } else if (shared.initial) {
      map->SetInitialMethod(choice("--initial", *shared.initial, roads));
    }
    if (shared.tolerance) {
      if (!(*shared.tolerance > 0)) {
        throw Failure(UsageProblem, "--tolerance must be above 0; it is " + shown(*shared.tolerance) + ".");
      }
      map->SetTolerance(*shared.tolerance);
    }
    if (shared.maxIterations) map->SetMaximumIterations(*shared.maxIterations);
  }

  void setRotation(vtkSphericalConformalMap* map) const {
    if (!landmarks_.empty()) {
      map->SetRotationToLandmarks();
      map->SetNorthVertex(landmarks_[0]);
      map->SetMeridianVertex(landmarks_[1]);
    }
    if (!rotation_) return;
    const int rotation = choice("--rotation", *rotation_, rotations);
    const bool needsLandmarks = rotation == vtkSphericalConformalMap::TO_LANDMARKS;
    if (needsLandmarks == landmarks_.empty()) {
      throw Failure(UsageProblem, "--rotation landmarks and --landmarks NORTH MERIDIAN belong together.");
    }
    map->SetRotation(rotation);
  }

  vtkNew<vtkSphericalConformalMap> defaults_;
  std::optional<std::string> start_, rotation_;
  std::vector<int> landmarks_;
  std::optional<int> puncturedFace_;
  std::optional<double> correctedShare_, timeStep_;
};

}  // namespace

std::unique_ptr<MapFamily> sphereFamily() { return std::make_unique<SphereFamily>(); }

}  // namespace authalic::cli
