#include "kiosk/ground/toml/toml_json.h"

#include <sstream>

#include "kiosk/ground/toml/toml_reader_impl.h"

namespace onggi::toml {

std::optional<std::string> json_of(const std::string& text) {
  static const std::string kName = "text";
  const AsciiToml ascii(text, kName);
  ::toml::parse_result result = ::toml::parse(ascii.text(), std::string_view(kName));
  if (!result || ascii.fault()) return std::nullopt;
  std::ostringstream out;
  out << ::toml::json_formatter(result.table());
  return out.str();
}

}  // namespace onggi::toml
