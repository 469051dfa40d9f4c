#include "kiosk/ground/fields/field.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "engine/base/nearest_name.h"
#include "kiosk/ground/toml/toml_splice.h"

namespace onggi::fields {
namespace {

/// "LANGUAGE", "VESSEL", "DATE".
bool is_any_name(const std::string& part) {
  return part.size() > 1 && std::ranges::all_of(part, [](char c) { return c >= 'A' && c <= 'Z'; });
}

std::string last_of(const std::string& name) { return name.substr(name.rfind('.') + 1); }

}  // namespace

std::string Field::name() const { return table.empty() ? key : table + "." + key; }

std::string bounds_words(const Field& field) {
  const auto end = [&field](double value) {
    return field.kind == FieldKind::whole ? std::to_string(static_cast<long long>(value))
                                          : number_words(value);
  };
  return end(field.least) + " to " + end(field.most);
}

std::string number_words(double value) {
  std::array<char, 40> text{};
  char* const end = text.data() + text.size();
  // Shortest; written out unless that takes many digits.
  constexpr double kLarge = 1e9, kSmall = 1e-6;
  const double size = std::abs(value);
  const bool out = size == 0.0 || (size >= kSmall && size < kLarge);
  const auto done = std::to_chars(text.data(), end, value,
                                  out ? std::chars_format::fixed : std::chars_format::scientific);
  return {text.data(), done.ptr};
}

std::string allowed_range(const Field& field) {
  if (!field.range.empty()) return field.range;
  if (field.kind == FieldKind::boolean) return "true or false";
  if (!field.choices.empty()) {
    std::string all;
    for (const std::string& choice : field.choices)
      all += (all.empty() ? "`\"" : ", `\"") + choice + "\"`";
    return all;
  }
  if (field.kind != FieldKind::whole && field.kind != FieldKind::number) return "";
  return (field.unit.empty() ? "" : field.unit + ", ") + bounds_words(field);
}

std::string page_row(const Field& field) {
  const std::string key = field.shown_key.empty() ? "`" + field.key + "`" : field.shown_key;
  std::string row = "| " + key + " | " + field.words;
  if (field.restarts_console) row += "; start onggi-console again after a change";
  if (!field.page.empty()) {
    std::string stem = std::filesystem::path(field.page).stem().string();
    std::replace(stem.begin(), stem.end(), '_', ' ');
    row += " ([" + stem + "](../" + field.page + "))";
  }
  // Texts and lists stand as code.
  const char* const mark = field.usual.starts_with('"') || field.usual.starts_with('[') ? "`" : "";
  return row + " | " + allowed_range(field) + " | " + mark + field.usual + mark + " |";
}

const Field* find_field(const FieldList& list, const toml::Path& names) {
  if (names.empty()) return nullptr;
  const auto found = std::ranges::find_if(
      list.fields, [&names](const Field& field) { return field.matches(names); });
  return found == list.fields.end() ? nullptr : &*found;
}

const OptionalTable* find_table(const FieldList& list, const toml::Path& path) {
  const auto found = std::ranges::find_if(list.tables, [&path](const OptionalTable& table) {
    return path.size() == (table.is_list ? 2u : 1u) && path[0] == table.name;
  });
  return found == list.tables.end() ? nullptr : &*found;
}

bool Field::matches(const toml::Path& names) const {
  toml::Path own;  // of a list's own names none has quotes
  std::istringstream parts(name());
  for (std::string part; std::getline(parts, part, '.');) own.push_back(part);
  return own.size() == names.size() &&
         std::equal(own.begin(), own.end(), names.begin(),
                    [](const std::string& part, const std::string& given) {
                      return is_any_name(part) || part == given;
                    });
}

std::string right_key(const FieldList& list, const std::string& wrong) {
  const toml::Path given = toml::path_of(wrong);
  std::vector<std::string> names, lasts;
  for (const Field& field : list.fields) {
    if (field.name().starts_with(wrong + "."))
      return "It is a table. Name one of its keys: " + field.name() + ".";
    if (field.any_key) continue;
    // A language in the middle is the one that was given.
    toml::Path name = toml::path_of(field.name());
    const bool alike = name.size() == given.size();
    if (std::ranges::any_of(name, is_any_name) && !alike) continue;
    for (std::size_t n = 0; n < name.size(); ++n)
      if (is_any_name(name[n])) name[n] = given[n];
    names.push_back(toml::key_text(name));
    lasts.push_back(field.key);
  }
  const auto ask = [](const std::string& name) { return "Did you mean " + name + "?"; };
  // The key alone, or below a wrong table.
  std::string all;
  int found = 0;
  for (std::size_t n = 0; n < names.size(); ++n)
    if (lasts[n] == last_of(wrong)) all += (found++ == 0 ? "" : " or ") + names[n];
  if (found > 0 && found <= 3) return ask(all);
  if (const std::string near = nearest_name(wrong, names); !near.empty()) return ask(near);
  if (const std::string near = nearest_name(last_of(wrong), lasts); !near.empty())
    return ask(names[static_cast<std::size_t>(std::ranges::find(lasts, near) - lasts.begin())]);
  return "onggi check --fields shows every key.";
}

std::string kind_words(FieldKind kind) {
  switch (kind) {
    case FieldKind::boolean:
      return "true or false";
    case FieldKind::whole:
      return "a whole number";
    case FieldKind::number:
      return "a number";
    case FieldKind::text:
      return "a text";
    case FieldKind::texts:
      return "a list of texts";
    case FieldKind::list:
      break;
  }
  return "a list";
}

}  // namespace onggi::fields
