#include "kiosk/ground/files/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace onggi::files {

struct JsonWriter {
  using Out = nlohmann::ordered_json;
  static Out of(const Json& json) {
    return std::visit([](const auto& value) { return JsonWriter::of(value); }, json.value_);
  }
  static Out of(const std::vector<Json>& list) {
    Out out = Out::array();
    for (const Json& value : list) out.push_back(of(value));
    return out;
  }
  static Out of(const std::vector<Json::Member>& members) {
    Out out = Out::object();
    for (const auto& [key, value] : members) out[key] = of(value);
    return out;
  }
  template <class Plain>
  static Out of(const Plain& value) {
    return value;
  }
};

Json Json::object(std::initializer_list<Member> members) {
  Json out;
  out.value_ = std::vector<Member>(members);
  return out;
}

Json Json::list(std::initializer_list<Json> values) {
  Json out;
  out.value_ = std::vector<Json>(values);
  return out;
}

Json& Json::operator[](const std::string& key) {
  auto& members = std::get<std::vector<Member>>(value_);
  const auto found = std::ranges::find(members, key, &Member::first);
  return found != members.end() ? found->second : members.emplace_back(key, Json()).second;
}

void Json::push_back(Json value) {
  std::get<std::vector<Json>>(value_).push_back(std::move(value));
}

std::string Json::text(int indent) const {
  return JsonWriter::of(*this).dump(indent, ' ', false,
                                    nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace onggi::files
