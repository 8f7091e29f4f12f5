#include "Reports/ElementReport.h"

#include <functional>

namespace authalic {

namespace {

template <class T, class Rows, class Get>
Table::Values values(const Rows& rows, const Get& get) {
  std::vector<T> result;
  result.reserve(rows.size());
  for (const auto& row : rows) result.push_back(get(row));
  return result;
}

template <class Rows, class Get>
Table::Values reals(const Rows& rows, const Get& get) {
  return values<double>(rows, get);
}
template <class Rows, class Get>
Table::Values integers(const Rows& rows, const Get& get) {
  return values<std::int64_t>(rows, get);
}
template <class Rows, class Get>
Table::Values texts(const Rows& rows, const Get& get) {
  return values<std::string>(rows, get);
}

const char* const kWeighting =
    "weighted by the native area that each vertex stands for; vertices without a value are left out";

template <class Rows>
void addField(Table& table, const Rows& rows, const SurfaceField& field, std::size_t f) {
  const std::string name = snakeCase(field.name), weighting = std::string(", ") + kWeighting;
  const std::string about = field.description.empty() ? "" : " (" + field.description + ")";
  const auto add = [&](const char* suffix, const char* what, const std::string& how,
                       double FieldStatistics::*value) {
    table.add(
        name + suffix, reals(rows, [&](const auto& row) { return row.fields[f].*value; }),
        {field.name + ", " + what, std::string(what) + " of " + field.name + about + how, field.units, {}});
  };
  table.add(name + "_n", integers(rows, [&](const auto& row) { return row.fields[f].n; }),
            {field.name + ", n", "Vertices with a value of " + field.name + about, "", {}});
  add("_mean", "mean", weighting, &FieldStatistics::mean);
  add("_sd", "standard deviation", weighting + "; population sd", &FieldStatistics::sd);
  add("_median", "median", weighting, &FieldStatistics::median);
  add("_min", "minimum", "", &FieldStatistics::minimum);
  add("_max", "maximum", "", &FieldStatistics::maximum);
  table.add(name + "_coverage", reals(rows, [&](const auto& row) { return row.fields[f].coverage; }),
            {field.name + ", coverage",
             "Share of the area, from 0 to 1, for which samples of " + field.name + " exist",
             "1",
             {}});
}

template <class Rows>
void addCentroid(Table& table, const Rows& rows) {
  const char* const axes[3] = {"x", "y", "z"};
  const char* const meanings[3] = {"to the right", "to the front", "upward"};
  for (int k = 0; k < 3; ++k) {
    table.add(
        std::string("centroid_") + axes[k] + "_mm",
        reals(rows, [k](const auto& row) { return row.centroid[k]; }),
        {std::string("Centroid ") + axes[k],
         std::string("Area-weighted centroid, scanner RAS, ") + meanings[k] + "; need not lie on the surface",
         "mm",
         {}});
  }
}

template <class Rows>
void addHemisphere(Table& table, const Rows& rows, const std::string& hemi) {
  table.add("hemi", texts(rows, [&](const auto&) { return hemi; }),
            {"Hemisphere", "", "", {{"L", "left"}, {"R", "right"}}});
}

template <class Rows>
void addSize(Table& table, const Rows& rows) {
  table.add("n_vertices", integers(rows, [](const auto& row) { return row.vertices; }),
            {"Vertices",
             "Vertices that stand for a part of the area; one at a border counts on each side",
             "",
             {}});
  table.add("area_mm2", reals(rows, [](const auto& row) { return row.area; }),
            {"Area", "Native area on the surface", "mm^2", {}});
}

void addDomain(Table& table, const std::vector<ElementRow>& rows) {
  const auto add = [&](const char* name, const char* what, double ElementRow::*value) {
    table.add(name, reals(rows, [value](const ElementRow& row) { return row.*value; }),
              {what, std::string(what) + " of the element in the domain of the map", "1", {}});
  };
  add("u_min", "Smallest u", &ElementRow::uMin);
  add("u_max", "Largest u", &ElementRow::uMax);
  add("v_min", "Smallest v", &ElementRow::vMin);
  add("v_max", "Largest v", &ElementRow::vMax);
}

void addMajority(Table& table, const ElementTable& elements) {
  table.add("label_majority",
            texts(elements.rows,
                  [&](const ElementRow& row) {
                    return row.majority < 0 ? std::string()
                                            : elements.regions[static_cast<std::size_t>(row.majority)].name;
                  }),
            {"Majority label", "Named region with the largest area in the element", "", {}});
  table.add(
      "label_fraction", reals(elements.rows, [](const ElementRow& row) { return row.majorityFraction; }),
      {"Majority share", "Share of the element's area that the majority label holds, from 0 to 1", "1", {}});
}

}  // namespace

Table elementReport(const ElementTable& elements, const std::string& hemi) {
  const std::vector<ElementRow>& rows = elements.rows;
  Table table;
  table.add(
      "element_id", integers(rows, [](const ElementRow& row) { return row.id; }),
      {"Element", "Number of the element, from 1, by rows of the grid; the key in label files", "", {}});
  addHemisphere(table, rows, hemi);
  addDomain(table, rows);
  addCentroid(table, rows);
  addSize(table, rows);
  table.add("area_ratio", reals(rows, [](const ElementRow& row) { return row.areaRatio; }),
            {"Area ratio",
             "Native area over the area that an exactly area-preserving map gives the element",
             "1",
             {}});
  addMajority(table, elements);
  table.add("grid_i", integers(rows, [](const ElementRow& row) { return row.i; }),
            {"Column", "Grid column, from 0", "", {}});
  table.add("grid_j", integers(rows, [](const ElementRow& row) { return row.j; }),
            {"Row", "Grid row, from 0", "", {}});
  table.add("interior", integers(rows, [](const ElementRow& row) { return row.interior ? 1 : 0; }),
            {"Interior",
             "Whether the element is one whole cell of the grid",
             "",
             {{"0", "cut by the rim of the domain or joined by a sliver"}, {"1", "one whole cell"}}});
  for (std::size_t f = 0; f < elements.fields.size(); ++f) addField(table, rows, elements.fields[f], f);
  return table;
}

Table regionReport(const RegionTable& regions, const std::string& hemi) {
  const std::vector<RegionRow>& rows = regions.rows;
  Table table;
  table.add("label_id", integers(rows, [](const RegionRow& row) { return row.id; }),
            {"Label", "Number in the atlas", "", {}});
  table.add("label_name", texts(rows, [](const RegionRow& row) { return row.name; }),
            {"Region", "Name in the atlas", "", {}});
  addHemisphere(table, rows, hemi);
  addCentroid(table, rows);
  addSize(table, rows);
  table.add("area_fraction", reals(rows, [](const RegionRow& row) { return row.fraction; }),
            {"Area share", "Share of the surface's area", "1", {}});
  for (std::size_t f = 0; f < regions.fields.size(); ++f) addField(table, rows, regions.fields[f], f);
  return table;
}

Json elementGridReport(const ElementGrid& grid) {
  const ElementDeviation& deviation = grid.deviation;
  Json result = Json::object();
  result.set("elements", grid.elements.size())
      .set("interior_elements", deviation.interiorElements)
      .set("columns", grid.lines.columns)
      .set("rows", grid.lines.rows)
      .set("surface_area_mm2", grid.surfaceArea)
      .set("target_area_mm2", grid.surfaceArea * grid.lines.cellArea() / grid.imageArea)
      .set("interior_area_deviation_max", deviation.interiorMaximum)
      .set("interior_area_deviation_mean", deviation.interiorMean)
      .set("area_deviation_max", deviation.maximum)
      .set("area_deviation_mean", deviation.mean)
      .set("flipped_faces", grid.flippedFaces.size())
      .set("zero_area_faces", grid.zeroAreaFaces.size());
  return result;
}

}  // namespace authalic
