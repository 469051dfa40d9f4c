#include "kiosk/ground/toml/toml_document_impl.h"

#include <algorithm>
#include <cstdlib>

namespace onggi::toml {

bool begins_with(const Path& path, const Path& first) {
  return path.size() >= first.size() && std::equal(first.begin(), first.end(), path.begin());
}

std::string_view end_of_line(std::string_view text) {
  const std::size_t end = text.find('\n');
  return end != std::string_view::npos && end > 0 && text[end - 1] == '\r' ? "\r\n" : "\n";
}

::toml::node* node_at(::toml::node& root, const Path& path) {
  ::toml::node* node = &root;
  for (const std::string& name : path) {
    if (::toml::table* table = node->as_table()) {
      node = table->get(name);
    } else if (::toml::array* list = node->as_array()) {
      const std::size_t n = std::strtoul(name.c_str(), nullptr, 10);
      node = n >= 1 && n <= list->size() ? list->get(n - 1) : nullptr;
    } else {
      return nullptr;
    }
    if (node == nullptr) return nullptr;
  }
  return node;
}

std::optional<::toml::table> parsed(const std::string& text) {
  static const std::string kName = "text";
  const AsciiToml ascii(text, kName);
  ::toml::parse_result result = ::toml::parse(ascii.text(), std::string_view(kName));
  if (!result || ascii.fault()) return std::nullopt;
  return std::move(result).table();
}

}  // namespace onggi::toml
