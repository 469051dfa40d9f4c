#include "kiosk/collection/changes/draft.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <utility>

#include "kiosk/collection/changes/typed_value.h"
#include "kiosk/ground/files/crc32.h"
#include "kiosk/ground/toml/toml_places.h"
#include "kiosk/ground/toml/toml_splice.h"
#include "kiosk/ground/toml/toml_tables.h"

namespace onggi::changes {
namespace {

/// The table or element at the path that a person typed; none where there is none.
std::optional<toml::Path> table_path(const std::string& text, const std::string& key) {
  const toml::TomlPlaces places(text);
  const auto found = typed_key(text, places, key, "");
  if (!found) return std::nullopt;
  const bool there = std::ranges::any_of(
      places.headers(), [&](const auto& header) { return header.path == found->path; });
  return there ? std::optional(found->path) : std::nullopt;
}

/// Adds the table `key` or takes it out.
Result<void> change_table(Draft& draft, const fields::OptionalTable& table, const Change& change,
                          const std::string& name) {
  const toml::Path typed = toml::path_of(change.key);
  if (change.value && *change.value != kNewTable)
    return problem(name, change.key + " is a table, not a value.",
                   "Write {} to add it, or name one of its keys: " + change.key + ".KEY.");
  const auto there = table_path(draft.text, change.key);
  if (there.has_value() == change.value.has_value()) return {};
  if (!change.value && table.is_list) {
    const toml::TomlPlaces places(draft.text);
    const auto key = typed_key(draft.text, places, change.key, name);
    // Behind one that goes, the numbers of the others are other ones.
    if (key && key->shown != toml::key_text(typed))
      return problem(name, change.key + " is meant by its number.",
                     "Write its id: " + key->shown + ".");
    if (places.elements({table.name}) == 1)
      return problem(name, change.key + " is the last one of this file.",
                     "Add another first. Or take the file out of the exhibit.");
  }
  auto done = !change.value    ? toml::without_table(draft.text, *there, name)
              : !table.is_list ? toml::with_table(draft.text, typed, name)
                               : toml::with_element(draft.text, {table.name}, typed.back(), name);
  if (!done) return tl::unexpected(done.error());
  if (done->text == draft.text) return {};
  draft.values.push_back({change.key, done->was, change.value.value_or(""), done->is, true});
  draft.text = std::move(done->text);
  return {};
}

}  // namespace

Result<void> make_change(Draft& draft, const fields::FieldList* list, const Change& change,
                         const std::string& name) {
  if (list != nullptr)
    if (const auto* table = fields::find_table(*list, toml::path_of(change.key)))
      return change_table(draft, *table, change, name);
  const toml::TomlPlaces places(draft.text);
  const auto found = typed_key(draft.text, places, change.key, name);
  if (!found) return tl::unexpected(found.error());
  const fields::Field* field = list == nullptr ? nullptr : fields::find_field(*list, found->names);
  if (list != nullptr && field == nullptr)
    return problem(name, toml::key_text(found->names) + " is not a key of this file.",
                   fields::right_key(*list, toml::key_text(found->names)));
  std::string was;
  if (const toml::TomlPlaces::Value* old = places.value(found->path))
    was = draft.text.substr(old->begin, old->end - old->begin);
  ChangedValue value{found->shown, was, {}, {}, false};
  if (change.value) {
    auto is = typed_value(*change.value, field, was, name + ", " + found->shown);
    if (!is) return tl::unexpected(is.error());
    value.is = std::move(*is);
  }
  if (value.is == was) return {};
  auto done = change.value ? toml::with_value(draft.text, found->path, value.is, name)
                           : toml::without_value(draft.text, found->path, name);
  if (!done) return tl::unexpected(done.error());
  if (done->added) value.put = done->is;
  draft.text = std::move(done->text);
  draft.values.push_back(std::move(value));
  draft.restarts_console = draft.restarts_console || (field != nullptr && field->restarts_console);
  return {};
}

std::string line_of_key(const std::string& text, const std::string& name, const std::string& key) {
  const toml::TomlPlaces places(text);
  const auto found = typed_key(text, places, key, "");
  if (!found) return "";
  std::size_t at = std::string::npos;
  for (const toml::TomlPlaces::Header& header : places.headers())
    if (header.path == found->path && !header.path.empty()) at = header.begin;
  if (const toml::TomlPlaces::Value* value = places.value(found->path)) at = value->begin;
  if (at == std::string::npos) return "";
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
  return name + ":" + std::to_string(1 + std::count(text.begin(), end, '\n')) + ":";
}

std::string tag_of(const std::string& text) {
  const std::uint32_t sum =
      files::crc32({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  std::array<char, 32> out{};
  std::snprintf(out.data(), out.size(), "%zx-%08x", text.size(), static_cast<unsigned>(sum));
  return out.data();
}

}  // namespace onggi::changes
