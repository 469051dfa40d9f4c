#include "kiosk/collection/settings/wifi_code.h"

namespace onggi::settings {

namespace {

/// Escapes letters that have a meaning in the code.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string("\\;,:\"").find(c) != std::string::npos) out += '\\';
    out += c;
  }
  return out;
}

}  // namespace

std::string wifi_code(const std::string& network, const std::string& password) {
  if (network.empty()) return {};
  if (password.empty()) return "WIFI:T:nopass;S:" + plain(network) + ";;";
  return "WIFI:T:WPA;S:" + plain(network) + ";P:" + plain(password) + ";;";
}

}  // namespace onggi::settings
