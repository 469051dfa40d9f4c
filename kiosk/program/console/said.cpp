#include "kiosk/program/console/said.h"

#include <algorithm>
#include <functional>

namespace onggi::console {

using files::Json;

std::string decoded(std::string_view text) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  std::string out;
  for (std::size_t n = 0; n < text.size(); ++n) {
    const int high = text[n] == '%' && n + 2 < text.size() ? digit(text[n + 1]) : -1;
    const int low = high >= 0 ? digit(text[n + 2]) : -1;
    if (low >= 0) {
      out += static_cast<char>(16 * high + low);
      n += 2;
    } else {
      out += text[n] == '+' ? ' ' : text[n];
    }
  }
  return out;
}

web::Answer json(const web::Ask& ask, const std::string& text) {
  const std::string tag = '"' + std::to_string(std::hash<std::string>{}(text)) + '"';
  web::Answer answer{.status = 200, .type = kJson, .body = text};
  if (ask.if_none_match == tag) answer = {.status = 304, .type = ""};
  answer.fields = {{"ETag", tag}};
  return answer;
}

web::Answer json(const Json& value) {
  return {.status = 200, .type = kJson, .body = value.text(-1)};
}

web::Answer refused(int status, const Problem& p) {
  return {
      .status = status,
      .type = kJson,
      .body = Json::object({{"where", p.where}, {"what", p.what}, {"remedy", p.remedy}}).text(-1)};
}

web::Answer refused(int status, const std::string& what, const std::string& remedy) {
  return refused(status, Problem{"", what, remedy});
}

web::Answer refused(const Problem& p) { return refused(p.exit_code == 1 ? 500 : 409, p); }

web::Answer page_of(int status, const std::string& says) {
  return {.status = status,
          .body =
              "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta "
              "name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>The "
              "staff’s page</title><link rel=\"stylesheet\" href=\"/staff.css\"></head><body>"
              "<main class=\"alone\"><p>" +
              says + "</p><p><a href=\"/\">To the staff’s page</a></p></main></body></html>"};
}

std::string Words::operator[](const char* key) const {
  if (!object_.is_object()) return {};
  const auto found = object_.find(key);
  return found != object_.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string query(const web::Ask& ask, std::string_view name) {
  return decoded(web::asked_for(ask.target, name));
}

std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> parts;
  while (!path.empty()) {
    path.remove_prefix(1);
    const std::size_t end = std::min(path.find('/'), path.size());
    parts.emplace_back(path.substr(0, end));
    path.remove_prefix(end);
  }
  return parts;
}

}  // namespace onggi::console
