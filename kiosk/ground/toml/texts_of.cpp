#include "kiosk/ground/toml/texts_of.h"

#include <algorithm>
#include <utility>

#include "kiosk/ground/toml/toml_reader_impl.h"

namespace onggi::toml {
namespace {

using Placed = std::pair<Place, std::string>;

void gather(const ::toml::node& node, const AsciiToml& file, std::vector<Placed>& out) {
  if (const std::string* text = as<std::string>(node)) {
    const auto& begin = node.source().begin;
    out.emplace_back(file.original({begin.line, begin.column}), *text);
  } else if (const ::toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table) gather(value, file, out);
  } else if (const ::toml::array* list = node.as_array()) {
    for (const ::toml::node& value : *list) gather(value, file, out);
  }
}

}  // namespace

std::vector<TextAt> texts_of(const std::filesystem::path& file) {
  const Result<std::string> text = read_toml_text(file);
  if (!text) return {};
  const AsciiToml plain(*text, file.string());
  const ::toml::parse_result parsed = ::toml::parse(plain.text(), std::string_view(file.native()));
  if (!parsed || plain.fault()) return {};
  std::vector<Placed> found;
  gather(parsed.table(), plain, found);
  std::ranges::sort(found);
  std::vector<TextAt> out;
  for (auto& [place, words] : found)
    out.push_back(
        {file.string() + ":" + std::to_string(place.line) + ":" + std::to_string(place.column),
         std::move(words)});
  return out;
}

}  // namespace onggi::toml
