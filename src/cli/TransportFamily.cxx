#include <vtkNew.h>
#include <vtkOptimalTransportMap.h>
#include <vtkPolyAnnulusTransportMap.h>
#include <vtkPolyData.h>
#include <vtkSphericalTransportMap.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> initials = {"harmonic", "riemann"};
const std::vector<std::string> finishes = {"none", "authalic"};
const std::vector<std::string> starts = {"automatic", "voronoi", "coarse-to-fine"};
const std::vector<std::string> formulations = {"spherical", "stereographic"};

constexpr double kHalf = 0.5;  // the balance of "balanced" when none is asked for

class TransportFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"transport", "balanced"}; }

  std::string description() const override {
    return "transport: area-preserving, or to a measure of yours (--measure), by optimal transport: the power cell of "
           "every vertex has exactly its share at the least cost, and the vertex goes to its middle. Faces are not "
           "exact and may fold, --finish authalic removes both; a disk to --domain disk, square, rectangle:ASPECT or "
           "a convex polygon:FILE, a closed surface of genus 0 to --domain sphere, a surface with holes to --domain "
           "circle-domain (unit disk; holes are filled with masses of their own, and round after the finish). In the "
           "plane the source is uniform, or the density of --source, which every cell then has its share of.\n\n"
           "balanced: between a conformal and an area-preserving map of a disk or, with --domain sphere, a closed "
           "surface of genus 0: transport from the conformal map with --balance " + shown(kHalf) + " and --finish "
           "authalic, if not given.";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {{"--initial", oneOf(initials) +
                              " (riemann: to the disk), or a MAP.vtp to the same domain; the conformal map "
                              "for a sphere (default: " +
                              initials[static_cast<std::size_t>(defaults_->GetInitialMethod())] + ")"},
            {"--tolerance",
             "largest error of a cell / mean cell (default: " + shown(defaults_->GetTolerance()) + ")"},
            {"--max-iterations",
             "Newton steps (default: " + std::to_string(defaults_->GetMaximumIterations()) + ")"},
            {"--finish", oneOf(finishes) + " (default: " +
                             finishes[static_cast<std::size_t>(defaults_->GetFinish())] + "; balanced: authalic)"},
            {"--hole-areas", "--domain circle-domain"},
            {"--balance", "(default: " + shown(defaults_->GetBalance()) + "; balanced: " + shown(kHalf) + ")"}};
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--cells", cells_, "The power cells: a polygon per vertex, with Area and Potential."))
        ->type_name("CELLS.vtp");
    own(verb->add_option("--source", source_,
                         "Planar mesh of the source density: covers the domain; linear in every triangle. Not with "
                         "--finish authalic or --balance."))
        ->type_name("MESH");
    own(verb->add_option("--source-density", sourceDensity_, "Point array of MESH: the source density, above 0."))
        ->type_name("NAME");
    own(verb->add_option("--start", start_,
                         "Where Newton's method begins in the plane: at the Voronoi cells of the sites, or at a "
                         "transport to fewer sites; automatic: the second for large surfaces, where it gains."))
        ->type_name(oneOf(starts))->default_str(starts[static_cast<std::size_t>(defaults_->GetStart())]);
    own(verb->add_option("--hole-share", holeShare_,
                         "--domain circle-domain: part of the disk that all holes get together, in [0, 1), as "
                         "--hole-areas or else the conformal map divides it; 0 = as large as their areas are."))
        ->type_name("X")->default_str(shown(vtkNew<vtkPolyAnnulusTransportMap>()->GetHoleShare()));
    own(verb->add_option("--formulation", formulation_,
                         "--domain sphere: transport on the sphere (spherical), or in the plane of a projection "
                         "(stereographic), where the map depends on the pole."))
        ->type_name(oneOf(formulations))
        ->default_str(formulations[static_cast<std::size_t>(vtkNew<vtkSphericalTransportMap>()->GetFormulation())]);
    own(verb->add_option("--pole", pole_,
                         "--formulation stereographic: pole of the projection, a direction in the space of the "
                         "initial map (default: the middle of its largest face)."))
        ->type_name("X Y Z")->expected(3)->allow_extra_args(false);
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string& method, const SharedMapOptions& shared,
                                                 const Session& session) const override {
    if (!cells_.empty()) requireArrayFormat("--cells", cells_);
    const bool balanced = method == "balanced";
    if (shared.domain != "sphere" && (formulation_ || !pole_.empty())) {
      throw Failure(UsageProblem, "--formulation and --pole need --domain sphere.");
    }
    if (shared.domain == "sphere" && start_) {
      throw Failure(UsageProblem, "--start is not for --domain sphere; leave it out.");
    }
    requireSourceOptions(shared);
    if (shared.domain == "sphere" && shared.holeAreas.empty() && !holeShare_) {
      return configured(spherical(), balanced, shared, session);
    }
    if (shared.domain == "circle-domain") return holed(balanced, shared);
    if (!shared.holeAreas.empty() || holeShare_) {
      throw Failure(UsageProblem, "--hole-areas and --hole-share need --domain circle-domain with method transport.");
    }
    const auto map = vtkSmartPointer<vtkOptimalTransportMap>::New();
    setDiskDomain(map, shared.domain);
    if (start_) map->SetStart(choice("--start", *start_, starts));
    if (balanced) map->SetInitialMethodToRiemann();
    if (!source_.empty()) {
      map->SetInputData(2, readSurface(source_, session, {}));  // in the plane of the domain, not in --space
      map->SetSourceDensityArrayName(sourceDensity_);
    }
    return configured(map, balanced, shared, session);
  }

  void addArrays(vtkSurfaceMapAlgorithm* map, const SharedMapOptions& shared, vtkSmartPointer<vtkPolyData>& surface,
                 const Session& session) const override {
    const std::optional<std::string> array = balanceArray(shared, surface, session);
    if (!array) return;
    if (auto* disk = vtkOptimalTransportMap::SafeDownCast(map)) disk->SetBalanceArrayName(*array);
    if (auto* sphere = vtkSphericalTransportMap::SafeDownCast(map)) sphere->SetBalanceArrayName(*array);
  }

  std::vector<std::string> files() const override { return {cells_}; }

  void conclude(vtkSurfaceMapAlgorithm* map, const Session& session) const override {
    if (!cells_.empty()) writeSurface(cells_, vtkPolyData::SafeDownCast(map->GetOutputDataObject(1)));
    if (session.quiet) return;
    const auto number = [map](const char* field) { return numberField(map->GetOutput(), field); };
    const auto text = [&](const char* field) { return shown(number(field).value_or(0)); };
    const std::string cost = number("TransportCost") ? "Transport cost " + text("TransportCost") + "; " : "";
    if (number("FinishedCost")) {
      sayNote(cost + (cost.empty() ? "Vertices" : "vertices") + " moved for " + text("DisplacementCost") +
              " before the finish, with " + text("FlippedBeforeFinish") + " folded faces, and for " +
              text("FinishedCost") + " after it.");
    } else if (map->GetFlippedFaces() > 0) {
      sayNote(cost + text("FlippedFaces") +
              " faces are folded, --finish authalic unfolds them.");
    }
  }

 private:
  void requireSourceOptions(const SharedMapOptions& shared) const {
    if (source_.empty() != sourceDensity_.empty()) {
      throw Failure(UsageProblem, "--source MESH and --source-density NAME, an array of it, belong together; only " +
                                      std::string(source_.empty() ? "the second" : "the first") + " was given.");
    }
    const std::string domain = shared.domain.value_or("disk");
    if (source_.empty() || (domain != "sphere" && domain != "circle-domain")) return;
    throw Failure(UsageProblem, "--source is for --domain disk, square, rectangle:ASPECT or polygon:FILE; it is " +
                                    domain + ", where the source is uniform.");
  }

  vtkSmartPointer<vtkSphericalTransportMap> spherical() const {
    const auto map = vtkSmartPointer<vtkSphericalTransportMap>::New();
    if (formulation_) map->SetFormulation(choice("--formulation", *formulation_, formulations));
    if (pole_.empty()) return map;
    if (map->GetFormulation() != vtkSphericalTransportMap::STEREOGRAPHIC) {
      throw Failure(UsageProblem, "--pole needs --formulation stereographic.");
    }
    if (pole_[0] == 0 && pole_[1] == 0 && pole_[2] == 0) {
      throw Failure(UsageProblem, "--pole 0 0 0 is no direction; leave it out for the middle of the largest face.");
    }
    map->SetPole(pole_.data());
    return map;
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> holed(bool balanced, const SharedMapOptions& shared) const {
    if (balanced || shared.balance) {
      throw Failure(UsageProblem, "--domain circle-domain has no balance; take method transport without it.");
    }
    if (shared.initial) {
      throw Failure(UsageProblem, "--initial " + *shared.initial + " is not for --domain circle-domain; leave it out, "
                                  "the start is the conformal map.");
    }
    const auto map = vtkSmartPointer<vtkPolyAnnulusTransportMap>::New();
    if (start_) map->SetStart(choice("--start", *start_, starts));
    for (const double area : shared.holeAreas) map->AddHoleArea(area);
    if (holeShare_) map->SetHoleShare(*holeShare_);
    setLimits(map.Get(), shared);
    return map;
  }

  template <class Filter>
  void setLimits(Filter* map, const SharedMapOptions& shared) const {
    if (shared.tolerance) map->SetTolerance(*shared.tolerance);
    if (shared.maxIterations) map->SetMaximumIterations(*shared.maxIterations);
    if (shared.finish) map->SetFinish(choice("--finish", *shared.finish, finishes));
  }

  template <class Filter>
  vtkSmartPointer<Filter> configured(vtkSmartPointer<Filter> map, bool balanced, const SharedMapOptions& shared,
                                     const Session& session) const {
    if (balanced) map->SetBalance(kHalf), map->SetFinishToAuthalic();
    if (const std::optional<double> balance = balanceNumber(shared)) map->SetBalance(*balance);
    setLimits(map.Get(), shared);
    if (!shared.initial) return map;
    if (isFile(*shared.initial)) {
      map->SetInputData(1, readSurface(*shared.initial, session, shared.space));
    } else if (auto* disk = vtkOptimalTransportMap::SafeDownCast(map)) {
      disk->SetInitialMethod(choice("--initial", *shared.initial, initials));
    } else {
      throw Failure(UsageProblem, "--initial " + *shared.initial + " is not for --domain sphere; leave it out, the "
                                  "start is the conformal map.");
    }
    return map;
  }

  vtkNew<vtkOptimalTransportMap> defaults_;
  std::string cells_, source_, sourceDensity_;
  std::optional<double> holeShare_;
  std::optional<std::string> formulation_, start_;
  std::vector<double> pole_;
};

}  // namespace

std::unique_ptr<MapFamily> transportFamily() { return std::make_unique<TransportFamily>(); }

}  // namespace authalic::cli
