#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <locale>

#include "Core/base/Error.h"
#include "Reports/Table.h"

using namespace authalic;

namespace {

struct CommaDecimals : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

using Integers = std::vector<std::int64_t>;
using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

}  // namespace

TEST(Table, WritesHeaderAndRowsWithTabs) {
  Table table;
  table.add("element_id", Integers{1, 20});
  table.add("area_mm2", Numbers{12.5, 1.0 / 3});
  table.add("label", Texts{"Précentral", "Insula L"});
  EXPECT_EQ(table.tsv(), "element_id\tarea_mm2\tlabel\n1\t12.5\tPrécentral\n20\t0.333333333\tInsula L\n");
  EXPECT_EQ(table.rowCount(), 2u);
}

TEST(Table, WritesWhatIsMissingAsNotAvailable) {
  Table table;
  table.add("x", Numbers{std::nan(""), std::numeric_limits<double>::infinity()});
  table.add("t", Texts{"", "a"});
  EXPECT_EQ(table.tsv(), "x\tt\nn/a\tn/a\nn/a\ta\n");
}

TEST(Table, WritesNumbersShortlyAndWithAPointInAnyLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaDecimals));
  EXPECT_EQ(tableNumber(1234567.25), "1234567.25");
  EXPECT_EQ(tableNumber(-0.5), "-0.5");
  Table table;
  table.add("n", Integers{1234567});
  EXPECT_EQ(table.tsv(), "n\n1234567\n");
  std::locale::global(before);
  EXPECT_EQ(tableNumber(0.0), "0");
  EXPECT_EQ(tableNumber(-0.0), "0");
  EXPECT_EQ(tableNumber(100.0), "100");
  EXPECT_EQ(tableNumber(1e-12), "1e-12");
  EXPECT_EQ(tableNumber(123456789.123), "123456789");
}

TEST(Table, KeepsCellsInTheirPlaceWhateverTheTextContains) {
  Table table;
  table.add("t", Texts{"a\tb\nc\rd", "bad \xFF\xC3 bytes", "\xE2\x82\xAC"});
  EXPECT_EQ(table.tsv(), "t\na b c d\nbad \xEF\xBF\xBD\xEF\xBF\xBD bytes\n\xE2\x82\xAC\n");
}

TEST(Table, DescribesItsColumnsInTheOrderGiven) {
  Table table;
  table.add("hemi", Texts{"L"}, {"Hemisphere", "Side", "", {{"R", "right"}, {"L", "left"}}});
  table.add("area_mm2", Numbers{1}, {"Area", "Native area", "mm^2", {}});
  EXPECT_EQ(table.sidecar(Json::object().set("GeneratedBy", "authalic")).text(false),
            R"({"GeneratedBy":"authalic","hemi":{"LongName":"Hemisphere","Description":"Side",)"
            R"("Levels":{"R":"right","L":"left"}},"area_mm2":{"LongName":"Area","Description":"Native area",)"
            R"("Units":"mm^2"}})");
}

TEST(Table, RefusesNamesThatAreNotSnakeCaseOrTaken) {
  Table table;
  for (const char* name : {"", "Area", "area mm", "2nd", "_a", "a-b"})
    EXPECT_THROW(table.add(name, Integers{1}), InvalidArgument) << name;
  table.add("a", Integers{1});
  EXPECT_THROW(table.add("a", Integers{1}), InvalidArgument);
  EXPECT_THROW(table.add("b", Integers{1, 2}), InvalidArgument);
  EXPECT_THROW(static_cast<void>(table.sidecar(Json(3))), InvalidArgument);
}

TEST(Table, WritesOnlyTheHeaderWithoutRows) {
  Table table;
  table.add("a", Integers{});
  table.add("b", Numbers{});
  EXPECT_EQ(table.tsv(), "a\tb\n");
}

TEST(TableNames, BecomeSnakeCase) {
  EXPECT_EQ(snakeCase("PET-SUV (left)"), "pet_suv_left");
  EXPECT_EQ(snakeCase("thickness"), "thickness");
  EXPECT_EQ(snakeCase("  T1 / T2  "), "t1_t2");
  EXPECT_EQ(snakeCase("18F-FDG"), "field_18f_fdg");
  EXPECT_EQ(snakeCase("é"), "field");
  EXPECT_EQ(snakeCase(""), "field");
}
