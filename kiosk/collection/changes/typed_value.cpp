#include "kiosk/collection/changes/typed_value.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "engine/base/nearest_name.h"
#include "kiosk/ground/toml/toml_reader.h"
#include "kiosk/ground/toml/toml_splice.h"
#include "kiosk/ground/toml/toml_text.h"

namespace onggi::changes {
namespace {

std::string id_of(const std::string& text, const toml::TomlPlaces& places, toml::Path element) {
  element.push_back("id");
  const toml::TomlPlaces::Value* value = places.value(element);
  if (value == nullptr) return "";
  const std::string written = text.substr(value->begin, value->end - value->begin);
  toml::TomlReader reader = toml::TomlReader::of_text("id = " + written, "id");
  std::string id;
  if (reader.ok()) reader.root().text("id", id);
  return id;
}

std::optional<std::size_t> number_in(const std::string& text) {
  std::size_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return number;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

bool is_quoted(const std::string& text) {
  return (text.starts_with('"') || text.starts_with('\'')) && toml::is_value(text);
}

bool is_number(const std::string& text, bool whole) {
  if (!toml::is_value(text)) return false;
  toml::TomlReader reader = toml::TomlReader::of_text("v = " + text, "v");
  double number = 0.0;
  int count = 0;
  constexpr int kMost = 2'147'483'647;
  return whole ? reader.root().integer("v", count, -kMost, kMost)
               : reader.root().number("v", number, -1e300, 1e300);
}

std::string list_of_texts(const std::string& typed) {
  std::string out;
  for (std::size_t at = 0; at <= typed.size();) {
    const std::size_t end = std::min(typed.find(',', at), typed.size());
    const std::string one = trimmed(typed.substr(at, end - at));
    if (!one.empty())
      out += (out.empty() ? "" : ", ") + (is_quoted(one) ? one : toml::quoted_text(one));
    at = end + 1;
  }
  return "[" + out + "]";
}

/// The kind of a value that is written; none where there is none.
std::optional<fields::FieldKind> kind_of(const std::string& was) {
  if (was.empty()) return std::nullopt;
  if (was[0] == '"' || was[0] == '\'') return fields::FieldKind::text;
  if (was == "true" || was == "false") return fields::FieldKind::boolean;
  if (was[0] != '[')
    return is_number(was, false) ? std::optional(fields::FieldKind::number) : std::nullopt;
  const auto first = was.find_first_not_of("[ \t\r\n");
  return first != std::string::npos && (was[first] == '"' || was[first] == '\'')
             ? fields::FieldKind::texts
             : fields::FieldKind::list;
}

std::string what_to_write(fields::FieldKind kind, const fields::Field* field) {
  const std::string words = "Write " + kind_words(kind);
  if (kind == fields::FieldKind::boolean) return words + ".";
  const bool number = kind == fields::FieldKind::whole || kind == fields::FieldKind::number;
  if (number && field != nullptr && field->range.empty())
    return words + " from " + bounds_words(*field) +
           (field->unit.empty() ? "" : " " + field->unit) + ", without the unit" +
           (kind == fields::FieldKind::number ? ". A part of one has a point: 1.5." : ".");
  if (field == nullptr || allowed_range(*field).empty()) return words + ".";
  return words + ": " + allowed_range(*field) + ".";
}

}  // namespace

Result<TypedKey> typed_key(const std::string& text, const toml::TomlPlaces& places,
                           const std::string& key, const std::string& name) {
  const toml::Path typed = toml::path_of(key);
  if (typed.empty())
    return problem(name, "\"" + toml::shown(key, 60) + "\" is not a key.",
                   "Write a key with points between its tables, such as idle.warn_after.");
  TypedKey out;
  toml::Path shown;
  for (const std::string& part : typed) {
    const std::size_t elements = places.elements(out.path);
    if (elements == 0) {
      out.path.push_back(part);
      out.names.push_back(part);
      shown.push_back(part);
      continue;
    }
    std::vector<std::string> ids;
    for (std::size_t n = 1; n <= elements; ++n) {
      toml::Path element = out.path;
      element.push_back(std::to_string(n));
      ids.push_back(id_of(text, places, element));
    }
    std::size_t chosen = elements;
    if (const auto found = std::ranges::find(ids, part); found != ids.end())
      chosen = static_cast<std::size_t>(found - ids.begin());
    else if (const auto number = number_in(part); number && *number >= 1 && *number <= elements)
      chosen = *number - 1;
    if (chosen == elements) {
      std::erase(ids, "");
      const std::string near = nearest_name(part, ids);
      return problem(name, "There is no " + shown.back() + " \"" + part + "\" in this file.",
                     !near.empty()  ? "Did you mean " + toml::key_text(shown) + "." + near + "?"
                     : !ids.empty() ? "Write one of: " + joined(ids) + "."
                                    : "Write a number from 1 to " + std::to_string(elements) + ".");
    }
    out.path.push_back(std::to_string(chosen + 1));
    shown.push_back(ids[chosen].empty() ? std::to_string(chosen + 1) : ids[chosen]);
  }
  out.shown = toml::key_text(shown);
  return out;
}

Result<std::string> typed_value(const std::string& typed_words, const fields::Field* field,
                                const std::string& was, const std::string& name) {
  const std::string typed = trimmed(typed_words);
  const auto kind = field != nullptr ? std::optional(field->kind) : kind_of(was);
  const auto wrong = [&] {
    return problem(name, "\"" + toml::shown(typed, 60) + "\" is not " + kind_words(*kind) + ".",
                   what_to_write(*kind, field));
  };
  if (!kind) return toml::is_value(typed) ? typed : toml::quoted_text(typed_words);
  switch (*kind) {
    case fields::FieldKind::boolean:
      if (typed != "true" && typed != "false") return wrong();
      return typed;
    case fields::FieldKind::whole:
    case fields::FieldKind::number:
      if (!is_number(typed, *kind == fields::FieldKind::whole)) return wrong();
      return typed;
    case fields::FieldKind::text:
      return is_quoted(typed) ? typed : toml::quoted_text(typed_words);
    case fields::FieldKind::texts:
      if (!typed.starts_with('[')) return list_of_texts(typed);
      break;
    case fields::FieldKind::list:
      if (!typed.starts_with('[')) {
        const std::string list = "[" + typed + "]";
        if (toml::is_value(list)) return list;
      }
      break;
  }
  if (!toml::is_value(typed)) return wrong();
  return typed;
}

}  // namespace onggi::changes
