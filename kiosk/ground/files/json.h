#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace onggi::files {

/// A value to write as JSON: reports, and the heads of files. Objects keep the order in which their
/// members were added. Write-only.
class Json {
 public:
  using Member = std::pair<std::string, Json>;  ///< Key and value.

  Json() = default;  ///< null
  Json(bool value) : value_(value) {}
  Json(double value) : value_(value) {}
  Json(const char* text) : value_(std::string(text)) {}
  Json(std::string text) : value_(std::move(text)) {}
  template <std::integral Whole>
  Json(Whole value)
      : value_(
            static_cast<std::conditional_t<std::is_signed_v<Whole>, std::int64_t, std::uint64_t>>(
                value)) {}
  static Json object(std::initializer_list<Member> members = {});
  static Json list(std::initializer_list<Json> values = {});
  template <class Values>
  static Json list_of(const Values& values) {
    Json out = list();
    for (const auto& value : values) out.push_back(value);
    return out;
  }

  /// The member `key` of an object; a new member is added at the end.
  Json& operator[](const std::string& key);
  /// Appends to a list.
  void push_back(Json value);

  /// Indents by `indent` spaces a level; below 0: all on one line. Invalid UTF-8 is repaired.
  /// Numbers have the fewest digits that read back as the same value.
  std::string text(int indent = 2) const;

 private:
  friend struct JsonWriter;
  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string,
               std::vector<Json>, std::vector<Member>>
      value_;
};

}  // namespace onggi::files
