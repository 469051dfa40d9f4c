#include "kiosk/collection/settings/color_in.h"

#include "kiosk/collection/textures/srgb.h"

namespace onggi::settings {

namespace {

bool parse_color(const std::string& text, std::array<float, 3>& out) {
  if (text.size() != 7 || text[0] != '#') return false;
  for (std::size_t k = 0; k < 3; ++k) {
    unsigned value = 0;
    for (const char c : text.substr(1 + 2 * k, 2)) {
      const bool digit = c >= '0' && c <= '9';
      const char lower = static_cast<char>(c | 0x20);
      if (!digit && (lower < 'a' || lower > 'f')) return false;
      value = value * 16 + static_cast<unsigned>(digit ? c - '0' : lower - 'a' + 10);
    }
    out[k] = static_cast<float>(textures::light_of_srgb(value / 255.0));
  }
  return true;
}

}  // namespace

bool read_color(toml::TomlReader::Table& table, const std::string& key, std::array<float, 3>& out) {
  std::string text;
  if (!table.text(key, text)) return false;
  if (parse_color(text, out)) return true;
  table.complain(key, "\"" + text + "\" is not a valid colour.",
                 "Write # and six digits or letters a to f, as in \"#9DB5A0\".");
  return false;
}

}  // namespace onggi::settings
