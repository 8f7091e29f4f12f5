#include <vtkNew.h>
#include <vtkOptimalTransportMap.h>
#include <vtkPolyData.h>

#include "MapFamily.h"

namespace authalic::cli {
namespace {

const std::vector<std::string> initials = {"harmonic", "riemann"};
const std::vector<std::string> finishes = {"none", "authalic"};

class TransportFamily : public MapFamily {
 public:
  std::vector<std::string> methods() const override { return {"transport"}; }

  std::string description() const override {
    return "transport: area-preserving, or to a measure of yours (--measure), by optimal transport: the "
           "power cell of "
           "every vertex has exactly its share at the least cost, and the vertex goes to its middle. Faces "
           "are not exact "
           "and may fold, --finish authalic removes both; a disk to --domain disk, square, rectangle:ASPECT "
           "or a convex "
           "polygon:FILE.";
  }

  std::map<std::string, std::string> sharedOptions() const override {
    return {{"--initial", oneOf(initials) + " (riemann: to the disk), or a MAP.vtp to the same domain (default: " +
                              initials[static_cast<std::size_t>(defaults_->GetInitialMethod())] + ")"},
            {"--tolerance", "largest error of a cell / mean cell (default: " + shown(defaults_->GetTolerance()) + ")"},
            {"--max-iterations", "Newton steps (default: " + std::to_string(defaults_->GetMaximumIterations()) + ")"},
            {"--finish", oneOf(finishes) + " (default: " +
                             finishes[static_cast<std::size_t>(defaults_->GetFinish())] + ")"}};
  }

  void declare(CLI::App* verb) override {
    own(verb->add_option("--cells", cells_, "The power cells: a polygon per vertex, with Area and Potential."))
        ->type_name("CELLS.vtp");
  }

  vtkSmartPointer<vtkSurfaceMapAlgorithm> filter(const std::string&, const SharedMapOptions& shared,
                                                 const Session& session) const override {
    const auto map = vtkSmartPointer<vtkOptimalTransportMap>::New();
    setDiskDomain(map, shared.domain);
    if (shared.tolerance) map->SetTolerance(*shared.tolerance);
    if (shared.maxIterations) map->SetMaximumIterations(*shared.maxIterations);
    if (shared.finish) map->SetFinish(choice("--finish", *shared.finish, finishes));
    if (!cells_.empty()) requireArrayFormat("--cells", cells_);
    if (!shared.initial) return map;
    if (isFile(*shared.initial)) map->SetInputData(1, readSurface(*shared.initial, session, shared.space));
    else map->SetInitialMethod(choice("--initial", *shared.initial, initials));
    return map;
  }

  std::vector<std::string> files() const override { return {cells_}; }

  void conclude(vtkSurfaceMapAlgorithm* map, const Session& session) const override {
    if (!cells_.empty()) writeSurface(cells_, vtkPolyData::SafeDownCast(map->GetOutputDataObject(1)));
    if (session.quiet) return;
    const auto number = [map](const char* field) { return numberField(map->GetOutput(), field); };
    const auto text = [&](const char* field) { return shown(number(field).value_or(0)); };
    if (number("FinishedCost")) {
      sayNote("Transport cost " + text("TransportCost") + "; vertices moved for " + text("DisplacementCost") +
              " before the finish, with " + text("FlippedBeforeFinish") + " folded faces, and for " +
              text("FinishedCost") + " after it.");
    } else if (map->GetFlippedFaces() > 0) {
      sayNote("Transport cost " + text("TransportCost") + "; " + text("FlippedFaces") +
              " faces are folded, --finish authalic unfolds them.");
    }
  }

 private:
  vtkNew<vtkOptimalTransportMap> defaults_;
  std::string cells_;
};

}  // namespace

std::unique_ptr<MapFamily> transportFamily() { return std::make_unique<TransportFamily>(); }

}  // namespace authalic::cli
