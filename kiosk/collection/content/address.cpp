#include "kiosk/collection/content/address.h"

#include <algorithm>

namespace onggi::content {

namespace {

const std::string kHttps = "https://";
constexpr std::size_t kMostTyped = 40;

std::string host_of(const std::string& address) {
  const std::size_t end = address.find_first_of("/?#", kHttps.size());
  return address.substr(kHttps.size(), end == std::string::npos ? end : end - kHttps.size());
}

/// True for at least two labels of letters, digits and hyphens: a public host name, not a local
/// machine or a bare number.
bool is_host(const std::string& host) {
  std::size_t begin = 0, labels = 0;
  bool letter = false;
  while (begin <= host.size()) {
    const std::size_t end = std::min(host.find('.', begin), host.size());
    if (end == begin || end - begin > 63) return false;
    letter = false;
    for (std::size_t i = begin; i < end; ++i) {
      const char c = host[i];
      const bool alpha = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
      if (!alpha && !(c >= '0' && c <= '9') && c != '-') return false;
      letter = letter || alpha;
    }
    ++labels;
    begin = end + 1;
  }
  return labels >= 2 && letter;
}

}  // namespace

std::string fault_of_address(const std::string& address) {
  if (address.rfind(kHttps, 0) != 0) return "the address does not begin with https://.";
  if (address.size() > kLongestAddress)
    return "the address has " + std::to_string(address.size()) +
           " letters, but a small QR code holds only " + std::to_string(kLongestAddress) + ".";
  for (const char c : address) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte <= 0x20 || byte >= 0x7F || std::string("\"<>\\^`{|}").find(c) != std::string::npos)
      return "the address contains a letter that addresses cannot have.";
  }
  if (!is_host(host_of(address))) return "the address does not name a web host.";
  return "";
}

std::string short_address(const std::string& address) {
  std::string out = address.rfind(kHttps, 0) == 0 ? address.substr(kHttps.size()) : address;
  if (out.rfind("www.", 0) == 0) out.erase(0, 4);
  while (!out.empty() && out.back() == '/') out.pop_back();
  return out.size() <= kMostTyped ? out : out.substr(0, out.find_first_of("/?#"));
}

}  // namespace onggi::content
