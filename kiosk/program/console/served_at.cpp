#include "kiosk/program/console/served_at.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace onggi::console {

namespace {

constexpr std::string_view kScheme = "https://";
constexpr std::size_t kLongest = 255;

/// "192.168.1.20", "kiosk.local", "[fd00::1]", as a browser writes it.
bool is_host(std::string_view text) {
  const bool v6 = text.starts_with('[') && text.ends_with(']') && text.size() > 2;
  if (v6) text = text.substr(1, text.size() - 2);
  return !text.empty() && text.size() <= kLongest && std::ranges::all_of(text, [v6](char c) {
    const bool digit = (c >= '0' && c <= '9') || c == '.';
    return v6 ? digit || c == ':' || (c >= 'a' && c <= 'f')
              : digit || c == '-' || (c >= 'a' && c <= 'z');
  });
}

}  // namespace

ServedAt served_here(const std::string& address, std::uint16_t port) {
  const bool v6 = address.find(':') != std::string::npos;
  ServedAt at;
  at.hosts = {v6 ? '[' + address + ']' : address};
  if (address == "127.0.0.1" || address == "::1") at.hosts.emplace_back("localhost");
  // A browser leaves the usual port out.
  if (port != 80)
    for (std::string& host : at.hosts) host += ':' + std::to_string(port);
  at.pages = {"http://" + at.hosts.front()};
  at.cookie = "onggi_staff_" + std::to_string(port);
  return at;
}

Result<ServedAt> served_by_proxy(const std::vector<std::string>& addresses) {
  ServedAt at{.https = true};
  std::uint16_t port = 0;
  for (const std::string& address : addresses) {
    port = 443;
    std::string_view host = address;
    const bool scheme = host.starts_with(kScheme);
    if (scheme) host.remove_prefix(kScheme.size());
    bool good = scheme;
    if (const std::size_t colon = host.rfind(':');
        colon != std::string_view::npos && !host.ends_with(']')) {
      const std::string_view digits = host.substr(colon + 1);
      const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), port);
      good = good && read.ec == std::errc() && read.ptr == digits.data() + digits.size();
      host = host.substr(0, colon);
    }
    if (!good || port == 0 || !is_host(host))
      return problem("--address " + address, "This is not an address of a page behind a proxy.",
                     "Write one such as https://192.168.1.20 or https://kiosk.local:8443.");
    at.hosts.push_back(std::string(host) + (port == 443 ? "" : ':' + std::to_string(port)));
    at.pages.push_back(std::string(kScheme) + at.hosts.back());
  }
  if (at.pages.empty())
    return problem("--listen unix:", "Nobody could ask for the page: --address is missing.",
                   "Write the address of the proxy, such as --address https://192.168.1.20.");
  // Browsers keep such a cookie only of HTTPS, for this host alone.
  at.cookie = "__Host-onggi_staff_" + std::to_string(port);
  return at;
}

}  // namespace onggi::console
