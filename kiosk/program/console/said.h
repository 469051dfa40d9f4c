#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/web/message.h"

namespace onggi::console {

inline constexpr const char* kJson = "application/json; charset=utf-8";

/// `text`, which is JSON, with a tag; 304 where the browser has this one.
web::Answer json(const web::Ask& ask, const std::string& text);
web::Answer json(const files::Json& value);

/// A Problem for the page to show: {where, what, remedy}.
web::Answer refused(int status, const Problem& p);
web::Answer refused(int status, const std::string& what, const std::string& remedy);
/// 500 for the machine's fault, else 409.
web::Answer refused(const Problem& p);

/// A page with one sentence, for an address that somebody opened: JSON would be a riddle. `says` is
/// plain words of ours.
web::Answer page_of(int status, const std::string& says);

/// The texts of a JSON object. A body that is none, and a value that is no text, are empty.
class Words {
 public:
  explicit Words(const std::string& body) : object_(nlohmann::json::parse(body, nullptr, false)) {}
  std::string operator[](const char* key) const;

 private:
  nlohmann::json object_;
};

/// The value of `name` in the query of `ask`, as it was typed: '+' and %20 are blanks.
std::string query(const web::Ask& ask, std::string_view name);

/// What stands for `text` in an address, as it was typed: '+' and %20 are blanks.
std::string decoded(std::string_view text);

/// The parts of a path: "keepsake", VISIT and FILE of "/keepsake/VISIT/FILE".
std::vector<std::string> parts_of(std::string_view path);

}  // namespace onggi::console
