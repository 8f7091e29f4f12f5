/// @file
/// A table with typed, described columns, written as TSV with a JSON sidecar (BIDS).
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "Reports/Json.h"

namespace authalic {

/// What the sidecar says about a column. Empty fields are left out.
struct ColumnInfo {
  std::string longName;
  std::string description;
  std::string units;                                          ///< "mm", "mm^2", "1" …
  std::vector<std::pair<std::string, std::string>> levels{};  ///< value → meaning, in order
};

/// Columns of equal length under unique snake_case names.
///
/// TSV: UTF-8, one header line, tab between cells, newline after each row. A NaN, an infinity and an empty
/// text are `n/a`; numbers are the shortest text of at most 9 significant digits, with a point whatever the
/// locale; tabs and line breaks in a text become blanks. The same table is the same bytes.
class Table {
 public:
  using Values = std::variant<std::vector<std::int64_t>, std::vector<double>, std::vector<std::string>>;
  struct Column {
    std::string name;
    Values values;
    ColumnInfo info;
  };

  /// @throws InvalidArgument when the name is not snake_case ([a-z][a-z0-9_]*) or taken, or the length
  ///         differs from that of the columns before.
  void add(const std::string& name, Values values, ColumnInfo info = {});

  [[nodiscard]] const std::vector<Column>& columns() const noexcept { return columns_; }
  [[nodiscard]] std::size_t rowCount() const noexcept { return rows_; }

  /// Header and rows.
  [[nodiscard]] std::string tsv() const;
  /// One object per column with LongName, Description, Units, Levels; the members of `preamble` (an object)
  /// come first.
  /// @throws InvalidArgument when `preamble` is not an object.
  [[nodiscard]] Json sidecar(const Json& preamble = Json::object()) const;

 private:
  std::vector<Column> columns_;
  std::size_t rows_ = 0;
};

/// "PET-SUV (left)" → "pet_suv_left": lower case, every run of other characters one underscore, a leading
/// digit after "field_"; "field" when nothing is left.
[[nodiscard]] std::string snakeCase(const std::string& text);

/// The text of a number in a table: at most 9 significant digits, "n/a" when it is not finite.
[[nodiscard]] std::string tableNumber(double value);

}  // namespace authalic
