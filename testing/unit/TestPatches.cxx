/// A patch of an image of any domain has the areas of its faces in the whole.
#include <gtest/gtest.h>

#include "Core/authalic/PeriodicAreas.h"
#include "Core/authalic/Patches.h"
#include "Core/authalic/SeamedAreas.h"
#include "Core/mesh/HighGenusMesh.h"
#include "Core/mesh/TorusMesh.h"
#include "Core/topology/CutGraph.h"
#include "support/HighGenusMeshes.h"
#include "support/TorusMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// Around every 50th face, two rings; also after one of its vertices moved.
void expectTheAreasOfTheWhole(const AreaFunctional& areas, Coordinates image) {
  FaceFlags chosen = FaceFlags::Constant(areas.faces().rows(), false);
  for (Eigen::Index f = 0; f < chosen.size(); f += 50) chosen[f] = true;
  const std::vector<Patch> patches = patchesAround(chosen, 2, areas);
  ASSERT_FALSE(patches.empty());
  for (const Patch& patch : patches) {
    const std::unique_ptr<AreaFunctional> inPatch = areas.inPatch(patch, image);
    Coordinates points = image(patch.vertices, Eigen::all);
    for (std::size_t v = 0; v < patch.vertices.size(); ++v) {
      ASSERT_TRUE(patch.freedom[v] == 0 || areas.freedom(patch.vertices[v]) == 2);
      if (patch.freedom[v] > 0) points.row(static_cast<Eigen::Index>(v)) += Eigen::RowVector2d(1e-3, -2e-3);
    }
    image(patch.vertices, Eigen::all) = points;
    const Eigen::VectorXd expected = areas.areas(image)(patch.faces);
    EXPECT_LT((inPatch->areas(points) - expected).cwiseAbs().maxCoeff(), 1e-14);
  }
}

}  // namespace

TEST(Patches, HaveTheAreasOfAPeriodicImage) {
  const TorusMesh torus(torusMesh(24, 12));
  const CutGraph cut = cutToFundamentalDomain(torus.mesh(), torus.topology());
  const Points2 shifts = cut.windings.cast<double>();
  const PeriodicAreas areas(torus.mesh().faces(), shifts, std::vector<char>(24 * 12, 2));
  expectTheAreasOfTheWhole(areas, torus.mesh().points().leftCols(2));
}

TEST(Patches, HaveTheAreasOfAnImageOnAFlatConeSurfaceWithAndWithoutParameters) {
  const HighGenusMesh surface(slabMesh(2, 4));
  const Faces& faces = surface.mesh().faces();
  const FlatConeSurface flat = flatConeSurface(surface, SolverBackend::Automatic);
  expectTheAreasOfTheWhole(SeamedAreas(faces, flat), flat.places);
  const Eigen::Index n = flat.places.rows(), count = flat.translations.size();
  Coordinates image(n + count, 2);
  image.topRows(n) = flat.places;
  image.bottomRows(count) << flat.translations.real(), flat.translations.imag();
  image.bottomRows(count).array() += 0.01;
  for (const int v : flat.cones) image.row(v).setConstant(7);  // says nothing there
  expectTheAreasOfTheWhole(SeamedAreas(faces, flat, cornerMoves(surface.topology(), flat)), image);
}
