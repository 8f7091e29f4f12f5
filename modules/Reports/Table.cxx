#include "Reports/Table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "Core/base/Error.h"

namespace authalic {

namespace {

bool isSnakeCase(const std::string& name) {
  if (name.empty() || name[0] < 'a' || name[0] > 'z') return false;
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

std::size_t lengthOf(const Table::Values& values) {
  return std::visit([](const auto& items) { return items.size(); }, values);
}

/// Length of the UTF-8 sequence at `position`, or 0 when there is none.
std::size_t sequenceLength(const std::string& text, std::size_t position) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char lead = byte(position);
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || position + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(position + k) & 0xC0u) != 0x80u) return 0;
  }
  const bool overlong = length > 2 && ((lead == 0xE0 && byte(position + 1) < 0xA0) ||
                                       (lead == 0xF0 && byte(position + 1) < 0x90));
  const bool outside =
      (lead == 0xED && byte(position + 1) > 0x9F) || (lead == 0xF4 && byte(position + 1) > 0x8F);
  return overlong || outside ? 0 : length;
}

std::string cellText(const std::string& text) {
  if (text.empty()) return "n/a";
  std::string result;
  for (std::size_t k = 0; k < text.size();) {
    const std::size_t length = sequenceLength(text, k);
    if (length == 0) {
      result += "\xEF\xBF\xBD";
      ++k;
      continue;
    }
    if (length == 1 && static_cast<unsigned char>(text[k]) < 0x20) {
      result += ' ';
    } else {
      result.append(text, k, length);
    }
    k += length;
  }
  return result;
}

std::string cell(const Table::Values& values, std::size_t row) {
  if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&values))
    return std::to_string((*integers)[row]);
  if (const auto* numbers = std::get_if<std::vector<double>>(&values)) return tableNumber((*numbers)[row]);
  return cellText(std::get<std::vector<std::string>>(values)[row]);
}

}  // namespace

void Table::add(const std::string& name, Values values, ColumnInfo info) {
  if (!isSnakeCase(name)) {
    throw InvalidArgument("A column name in snake_case is required, but it is '" + name +
                          "'; use lower-case letters, digits and underscores.");
  }
  for (const Column& column : columns_) {
    if (column.name == name) {
      throw InvalidArgument("Different column names are required, but '" + name +
                            "' is given twice; rename one.");
    }
  }
  const std::size_t length = lengthOf(values);
  if (!columns_.empty() && length != rows_) {
    throw InvalidArgument("Columns of equal length are required, but '" + name + "' has " +
                          std::to_string(length) + " rows and the table " + std::to_string(rows_) + ".");
  }
  rows_ = length;
  columns_.push_back({name, std::move(values), std::move(info)});
}

std::string Table::tsv() const {
  std::string result;
  for (std::size_t c = 0; c < columns_.size(); ++c) result += (c > 0 ? "\t" : "") + columns_[c].name;
  result += '\n';
  for (std::size_t row = 0; row < rows_; ++row) {
    for (std::size_t c = 0; c < columns_.size(); ++c)
      result += (c > 0 ? "\t" : "") + cell(columns_[c].values, row);
    result += '\n';
  }
  return result;
}

Json Table::sidecar(const Json& preamble) const {
  Json result = Json::object();
  const Json::Object* members = std::get_if<Json::Object>(&preamble.value());
  if (members == nullptr) throw InvalidArgument("The preamble of a sidecar must be a JSON object.");
  for (const auto& [key, value] : *members) result.set(key, value);
  for (const Column& column : columns_) {
    Json entry = Json::object();
    if (!column.info.longName.empty()) entry.set("LongName", column.info.longName);
    if (!column.info.description.empty()) entry.set("Description", column.info.description);
    if (!column.info.units.empty()) entry.set("Units", column.info.units);
    if (!column.info.levels.empty()) {
      Json levels = Json::object();
      for (const auto& [value, meaning] : column.info.levels) levels.set(value, meaning);
      entry.set("Levels", levels);
    }
    result.set(column.name, entry);
  }
  return result;
}

std::string snakeCase(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
      result += c;
    } else if (c >= 'A' && c <= 'Z') {
      result += static_cast<char>(c - 'A' + 'a');
    } else if (!result.empty() && result.back() != '_') {
      result += '_';
    }
  }
  while (!result.empty() && result.back() == '_') result.pop_back();
  if (result.empty()) return "field";
  return result[0] >= '0' && result[0] <= '9' ? "field_" + result : result;
}

std::string tableNumber(double value) {
  if (!std::isfinite(value)) return "n/a";
  if (value == 0.0) return "0";
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 9);
  return std::string(buffer.data(), end.ptr);
}

}  // namespace authalic
