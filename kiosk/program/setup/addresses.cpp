#include "kiosk/program/setup/addresses.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <memory>

namespace onggi::setup {

namespace {

/// As the system writes it; "" if it is no address.
std::string plain(const std::string& text) {
  std::array<char, INET6_ADDRSTRLEN> out{};
  std::array<unsigned char, sizeof(in6_addr)> bytes{};
  for (const int family : {AF_INET, AF_INET6})
    if (::inet_pton(family, text.c_str(), bytes.data()) == 1 &&
        ::inet_ntop(family, bytes.data(), out.data(), out.size()) != nullptr)
      return out.data();
  return {};
}

/// The values of `key` in a file of lines "key=value".
std::vector<std::string> values_of(const System& system, const char* file, const std::string& key) {
  std::vector<std::string> values;
  std::ifstream lines(system.at(file));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(key + '=')) values.push_back(line.substr(key.size() + 1));
  return values;
}

Problem several(const std::vector<MachineAddress>& all) {
  std::string found;
  for (const MachineAddress& one : all)
    found += (found.empty() ? "" : ", ") + one.address + " (" + one.card + ")";
  return {"--console", "This machine has several addresses: " + found + ".",
          "Name the one that staff reach: sudo onggi setup --console " + all.front().address, 2};
}

constexpr const char* kHow =
    "Write one of this machine, such as 192.168.1.20 or 192.168.1.20:8443.";

}  // namespace

std::vector<MachineAddress> machine_addresses() {
  std::vector<MachineAddress> found;
  ifaddrs* list = nullptr;
  if (::getifaddrs(&list) != 0) return found;
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> held(list, ::freeifaddrs);
  for (const ifaddrs* one = list; one != nullptr; one = one->ifa_next) {
    if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET) continue;
    const auto* address = reinterpret_cast<const sockaddr_in*>(one->ifa_addr);
    std::array<char, INET_ADDRSTRLEN> text{};
    if (::inet_ntop(AF_INET, &address->sin_addr, text.data(), text.size()) == nullptr) continue;
    if (!std::string_view(text.data()).starts_with("127."))
      found.push_back({one->ifa_name, text.data()});
  }
  return found;
}

std::string StaffAddress::listen() const {
  const bool v6 = address.find(':') != std::string::npos;
  return (v6 ? '[' + address + ']' : address) + ':' + std::to_string(port);
}

std::string StaffAddress::page(const std::string& host) const {
  return "https://" + host + (port == 443 ? "" : ':' + std::to_string(port));
}

std::string StaffAddress::page() const {
  return page(address.find(':') != std::string::npos ? '[' + address + ']' : address);
}

bool is_access_point(const MachineAddress& one, const System& system) {
  for (const std::string& given :
       values_of(system, "/etc/systemd/network/50-onggi-phones.network", "Address"))
    if (given.substr(0, given.find('/')) == one.address) return true;
  const auto cards = values_of(system, "/etc/hostapd/hostapd.conf", "interface");
  return std::ranges::find(cards, one.card) != cards.end();
}

Result<StaffAddress> staff_address(const std::string& written,
                                   const std::vector<MachineAddress>& all, const System& system) {
  if (written == kChoose) {
    std::vector<MachineAddress> good = all;
    std::erase_if(good,
                  [&system](const MachineAddress& one) { return is_access_point(one, system); });
    if (good.size() == 1) return StaffAddress{good.front().address};
    if (good.size() > 1) return tl::unexpected(several(good));
    return problem("--console", "This machine has no address in a network of the staff's.",
                   "Connect it, and try again. For ssh alone: sudo onggi setup --console "
                   "127.0.0.1");
  }
  StaffAddress at{written};
  const std::size_t colon = written.rfind(':');
  const bool bare_v6 = written.find(':') != colon && !written.starts_with('[');
  if (colon != std::string::npos && !bare_v6 && !written.ends_with(']')) {
    const char* const end = written.data() + written.size();
    const auto read = std::from_chars(written.data() + colon + 1, end, at.port);
    if (read.ec != std::errc() || read.ptr != end || at.port == 0)
      return problem("--console " + written, "This is not an address with a port.", kHow);
    at.address = written.substr(0, colon);
  }
  if (at.address.starts_with('[') && at.address.ends_with(']'))
    at.address = at.address.substr(1, at.address.size() - 2);
  const std::string address = plain(at.address);
  if (address.empty()) return problem("--console " + written, "This is not an address.", kHow);
  at.address = address;
  if (address == "0.0.0.0" || address == "::")
    return problem("--console " + written,
                   "This is every address of the machine, the one for visitors' phones too.", kHow);
  if (at.is_loop() && address != written)
    return problem("--console " + written, "On this machine alone the page has port 8090.",
                   "Write --console 127.0.0.1.");
  const auto card = std::ranges::find(all, address, &MachineAddress::address);
  if (is_access_point(card == all.end() ? MachineAddress{"", address} : *card, system))
    return problem("--console " + written,
                   "This is the address of the access point, which visitors' phones use.", kHow);
  return at;
}

}  // namespace onggi::setup
