#include "Reports/Json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "Core/base/Error.h"

namespace authalic {

namespace {

nlohmann::ordered_json convert(const Json& json);

struct Converter {
  nlohmann::ordered_json operator()(std::monostate) const { return nullptr; }
  nlohmann::ordered_json operator()(bool value) const { return value; }
  nlohmann::ordered_json operator()(std::int64_t value) const { return value; }
  nlohmann::ordered_json operator()(double value) const {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
  }
  nlohmann::ordered_json operator()(const std::string& value) const { return value; }
  nlohmann::ordered_json operator()(const Json::Array& items) const {
    nlohmann::ordered_json result = nlohmann::ordered_json::array();
    for (const Json& item : items) result.push_back(convert(item));
    return result;
  }
  nlohmann::ordered_json operator()(const Json::Object& members) const {
    nlohmann::ordered_json result = nlohmann::ordered_json::object();
    for (const auto& [key, value] : members) result[key] = convert(value);
    return result;
  }
};

nlohmann::ordered_json convert(const Json& json) {
  return std::visit(Converter{}, json.value());
}

}  // namespace

Json Json::array() {
  Json result;
  result.value_ = Array();
  return result;
}

Json Json::object() {
  Json result;
  result.value_ = Object();
  return result;
}

Json& Json::add(Json item) {
  Array* items = std::get_if<Array>(&value_);
  if (items == nullptr)
    throw InvalidArgument("A JSON array is required to add an item, but this is another value.");
  items->push_back(std::move(item));
  return *this;
}

Json& Json::set(const std::string& key, Json value) {
  Object* members = std::get_if<Object>(&value_);
  if (members == nullptr) {
    throw InvalidArgument("A JSON object is required to set '" + key + "', but this is another value.");
  }
  for (auto& [name, old] : *members) {
    if (name == key) {
      old = std::move(value);
      return *this;
    }
  }
  members->emplace_back(key, std::move(value));
  return *this;
}

std::string Json::text(bool pretty) const {
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  return convert(*this).dump(pretty ? 2 : -1, ' ', false, replace) + (pretty ? "\n" : "");
}

}  // namespace authalic
