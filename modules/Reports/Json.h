/// @file
/// A JSON value whose objects keep the order in which members were added.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace authalic {

/// null, boolean, integer, number, string, array or object. Built once, written once: there is no parser.
///
/// The text depends on the values alone: members in the order added, numbers in the shortest form that reads
/// back to the same double, NaN and infinities as null (JSON has none), bytes that are not UTF-8 as U+FFFD.
class Json {
 public:
  Json() = default;
  Json(bool value) : value_(value) {}               // NOLINT(google-explicit-constructor)
  Json(int value) : value_(std::int64_t{value}) {}  // NOLINT(google-explicit-constructor)
  Json(std::int64_t value) : value_(value) {}       // NOLINT(google-explicit-constructor)
  Json(std::size_t value) : Json(static_cast<std::int64_t>(value)) {}  // NOLINT(google-explicit-constructor)
  Json(double value) : value_(value) {}                    // NOLINT(google-explicit-constructor)
  Json(const char* value) : value_(std::string(value)) {}  // NOLINT(google-explicit-constructor)
  Json(std::string value) : value_(std::move(value)) {}    // NOLINT(google-explicit-constructor)

  [[nodiscard]] static Json array();
  [[nodiscard]] static Json object();
  template <class Container>
  [[nodiscard]] static Json arrayOf(const Container& items) {
    Json result = array();
    for (const auto& item : items) result.add(Json(item));
    return result;
  }

  /// Appends to an array. @throws InvalidArgument when this is not an array.
  Json& add(Json item);
  /// Sets a member of an object; an existing member keeps its place. @throws InvalidArgument when this is no
  ///         object.
  Json& set(const std::string& key, Json value);

  /// Two spaces per level and a newline at the end when `pretty`, else one line without it.
  [[nodiscard]] std::string text(bool pretty = true) const;

  using Array = std::vector<Json>;
  using Member = std::pair<std::string, Json>;
  using Object = std::vector<Member>;
  using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Object>;
  [[nodiscard]] const Value& value() const noexcept { return value_; }

 private:
  Value value_;
};

}  // namespace authalic
