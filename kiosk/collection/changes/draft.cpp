#include "kiosk/collection/changes/draft.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

#include "kiosk/collection/changes/typed_value.h"
#include "kiosk/ground/files/crc32.h"
#include "kiosk/ground/toml/toml_places.h"
#include "kiosk/ground/toml/toml_splice.h"

namespace onggi::changes {

Result<void> make_change(Draft& draft, const fields::FieldList* list, const Change& change,
                         const std::string& name) {
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
  ChangedValue value{found->shown, was, {}, {}};
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
  const toml::TomlPlaces::Value* value = found ? places.value(found->path) : nullptr;
  if (value == nullptr) return "";
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(value->begin);
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
