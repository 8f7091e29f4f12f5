#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "Core/base/Error.h"
#include "Reports/ElementReport.h"
#include "Reports/MapReport.h"
#include "Reports/Version.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

std::vector<std::string> keys(const Json& json) {
  std::vector<std::string> result;
  for (const Json::Member& member : std::get<Json::Object>(json.value())) result.push_back(member.first);
  return result;
}

Table elementsOfASquare(const std::string& fieldName) {
  const TriangleMesh mesh = gridMesh(8, 8);
  SurfaceField field{fieldName, std::vector<double>(81, 2.0), {}, "mm", "of the cortex"};
  const SurfaceLabels labels{std::vector<int>(81, 1), {{1, "Insula_L"}}};
  const ElementGrid grid = elementGrid(mesh, mesh.points().leftCols<2>(), {4});
  return elementReport(elementTable(mesh, grid, {field}, labels), "L");
}

}  // namespace

TEST(Json, KeepsTheOrderOfMembersAndReplacesInPlace) {
  Json json = Json::object();
  json.set("z", 1).set("a", true).set("m", "text").set("z", 2.5);
  EXPECT_EQ(json.text(false), R"({"z":2.5,"a":true,"m":"text"})");
  EXPECT_EQ(Json::arrayOf(std::vector<int>{3, 1, 2}).text(false), "[3,1,2]");
  EXPECT_EQ(Json::object().set("a", Json::array().add(Json())).text(), "{\n  \"a\": [\n    null\n  ]\n}\n");
}

TEST(Json, WritesNumbersThatReadBackAndNullForWhatIsNone) {
  EXPECT_EQ(Json(0.1).text(false), "0.1");
  EXPECT_EQ(std::stod(Json(1.0 / 3).text(false)), 1.0 / 3);
  EXPECT_EQ(Json(std::nan("")).text(false), "null");
  EXPECT_EQ(Json(-std::numeric_limits<double>::infinity()).text(false), "null");
}

TEST(Json, EscapesTextsAndReplacesBytesThatAreNotUtf8) {
  EXPECT_EQ(Json("a\"b\\\n").text(false), R"("a\"b\\\n")");
  EXPECT_EQ(Json("x\xFF").text(false), "\"x\xEF\xBF\xBD\"");
}

TEST(Json, RefusesMembersOfAnArrayAndItemsOfAnObject) {
  EXPECT_THROW(Json::array().set("a", 1), InvalidArgument);
  EXPECT_THROW(Json::object().add(1), InvalidArgument);
}

TEST(ElementReport, HasTheColumnsThatTablesOfElementsShare) {
  const Table table = elementsOfASquare("Thickness");
  std::vector<std::string> names;
  for (const Table::Column& column : table.columns()) names.push_back(column.name);
  const std::vector<std::string> expected{"element_id",     "hemi",           "u_min",
                                          "u_max",          "v_min",          "v_max",
                                          "centroid_x_mm",  "centroid_y_mm",  "centroid_z_mm",
                                          "n_vertices",     "area_mm2",       "area_ratio",
                                          "label_majority", "label_fraction", "grid_i",
                                          "grid_j",         "interior",       "thickness_n",
                                          "thickness_mean", "thickness_sd",   "thickness_median",
                                          "thickness_min",  "thickness_max",  "thickness_coverage"};
  EXPECT_EQ(names, expected);
  EXPECT_EQ(keys(table.sidecar()), expected);
  EXPECT_EQ(table.rowCount(), 4u);
  EXPECT_EQ(table.tsv(), elementsOfASquare("Thickness").tsv());
  const std::string firstRow = table.tsv().substr(table.tsv().find('\n') + 1);
  EXPECT_EQ(firstRow.substr(0, firstRow.find('\n')),
            "1\tL\t0\t0.5\t0\t0.5\t0.25\t0.25\t0\t25\t0.25\t1\tInsula_L\t1\t0\t0\t1\t25\t2\t0\t2\t2\t2\t1");
}

TEST(ElementReport, GivesUnitsOfTheFieldToItsStatistics) {
  const Json sidecar = elementsOfASquare("Thickness").sidecar();
  const std::string text = sidecar.text(false);
  EXPECT_NE(
      text.find(
          R"("thickness_mean":{"LongName":"Thickness, mean","Description":"mean of Thickness (of the cortex))"),
      std::string::npos);
  EXPECT_NE(text.find(R"("Units":"mm"})"), std::string::npos);
}

TEST(ElementReport, RefusesFieldsThatGetTheSameName) {
  const TriangleMesh mesh = gridMesh(2, 2);
  const SurfaceField a{"T 1", std::vector<double>(9, 1.0), {}, "", ""},
      b{"t-1", std::vector<double>(9, 1.0), {}, "", ""};
  const ElementGrid grid = elementGrid(mesh, mesh.points().leftCols<2>(), {1});
  EXPECT_THROW(static_cast<void>(elementReport(elementTable(mesh, grid, {a, b}), "")), InvalidArgument);
}

TEST(ElementReport, SaysHowEqualTheElementsAre) {
  const TriangleMesh mesh = gridMesh(4, 4, 20.0, 20.0);
  const Json report = elementGridReport(elementGrid(mesh, mesh.points().leftCols<2>() / 20, {16}));
  EXPECT_NE(report.text(false).find(R"("elements":16,"interior_elements":16,"columns":4,"rows":4)"),
            std::string::npos);
  EXPECT_NE(report.text(false).find(R"("target_area_mm2":25.0)"), std::string::npos);
}

TEST(RegionReport, NamesItsRegions) {
  const TriangleMesh mesh = gridMesh(2, 2);
  const SurfaceLabels labels{std::vector<int>(9, 4), {{4, "Cuneus"}, {6, "Absent"}}};
  const Table table =
      regionReport(regionTable(mesh, labels, {{"f", std::vector<double>(9, 1.5), {}, "", ""}}), "");
  EXPECT_EQ(table.tsv(),
            "label_id\tlabel_name\themi\tcentroid_x_mm\tcentroid_y_mm\tcentroid_z_mm\tn_vertices\tarea_mm2\t"
            "area_fraction\tf_n\tf_mean\tf_sd\tf_median\tf_min\tf_max\tf_coverage\n"
            "4\tCuneus\tn/a\t0.5\t0.5\t0\t9\t1\t1\t9\t1.5\t0\t1.5\t1.5\t1.5\t1\n"
            "6\tAbsent\tn/a\tn/a\tn/a\tn/a\t0\t0\t0\t0\tn/a\tn/a\tn/a\tn/a\tn/a\t0\n");
}

TEST(MapReport, HasEveryMember) {
  const TriangleMesh mesh = gridMesh(4, 4);
  MapReport report;
  report.method = "harmonic";
  report.status = Status::Converged;
  report.iterations = 2;
  report.residuals = {0.5, 0.25, 1e-9};
  report.seconds = {{"assembly", 0.5}, {"solve", 0.25}};
  report.metrics = measureDistortion(mesh, mesh.points().leftCols<2>()).summary;
  report.topology = inspect(mesh);
  report.options.set("domain", "square");
  report.more.set("boundary", "arc-length");
  const Json json = mapReport(report);
  EXPECT_EQ(keys(json),
            (std::vector<std::string>{"version", "method", "status", "iterations", "residual_history",
                                      "seconds", "metrics", "flips", "topology", "options", "boundary"}));
  const std::string text = json.text(false);
  EXPECT_NE(text.find(std::string(R"({"version":")") + version() +
                      R"(","method":"harmonic","status":"converged","iterations":2)"),
            std::string::npos);
  EXPECT_NE(text.find(R"("seconds":{"assembly":0.5,"solve":0.25,"total":0.75})"), std::string::npos);
  EXPECT_NE(text.find(R"("euler_characteristic":1,"genus":0)"), std::string::npos);
  EXPECT_NE(text.find(R"("flips":0)"), std::string::npos);
  EXPECT_EQ(text, mapReport(report).text(false));
}

TEST(MapReport, RefusesToReplaceItsOwnMembers) {
  MapReport report;
  report.more.set("status", "fine");
  EXPECT_THROW(static_cast<void>(mapReport(report)), InvalidArgument);
  report.more = Json(3);
  EXPECT_THROW(static_cast<void>(mapReport(report)), InvalidArgument);
}

TEST(MeshReportJson, PlacesDefectsAndCutsLongLists) {
  Faces book(3, 3);
  book << 0, 1, 2, 1, 0, 3, 0, 1, 4;
  Points3 points(5, 3);
  points << 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1;
  const Json json = meshReport(inspect(TriangleMesh(points, book)));
  EXPECT_NE(json.text(false).find(
                R"("non_manifold_edges":{"count":1,"first":[{"ids":[0,1],"place_mm":[1.0,0.0,0.0]}]})"),
            std::string::npos)
      << json.text(false);
  EXPECT_NE(json.text(false).find(R"("genus":null)"), std::string::npos);
  EXPECT_NE(meshReport(inspect(TriangleMesh(points, book)), 0)
                .text(false)
                .find(R"("non_manifold_edges":{"count":1,"first":[]})"),
            std::string::npos);
}
