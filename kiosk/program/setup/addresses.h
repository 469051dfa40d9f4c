#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/program/setup/step.h"

namespace onggi::setup {

/// An address of a machine, and the network card that has it: {"eth0", "192.168.1.20"}.
struct MachineAddress {
  std::string card, address;
};

/// The addresses by which other computers may reach this machine: none of its own loop, and no IPv6
/// ones, which change.
std::vector<MachineAddress> machine_addresses();

/// Where staff reach the page.
struct StaffAddress {
  std::string address;  ///< "192.168.1.20", "fd00::1"
  std::uint16_t port = 443;
  /// This machine alone, as before there was HTTPS.
  bool is_loop() const { return address == "127.0.0.1"; }
  /// "192.168.1.20:8443", as nginx listens; always with the port.
  std::string listen() const;
  /// "https://HOST", or "https://HOST:8443" behind another port than HTTPS' own.
  std::string page(const std::string& host) const;
  /// "https://192.168.1.20"
  std::string page() const;
};

/// True if `one` belongs to the kiosk's access point (access_point.md), which visitors' phones use.
bool is_access_point(const MachineAddress& one, const System& system);

/// The word for "choose it".
inline constexpr const char* kChoose = "auto";
/// What somebody wrote ("192.168.1.20", "192.168.1.20:8443", "[fd00::1]:8443"), or with kChoose the
/// only one of `all` that is not the access point's. Problem, exit 2: it is no address of one card
/// alone, or it is the access point's; with kChoose there is none, or several.
Result<StaffAddress> staff_address(const std::string& written,
                                   const std::vector<MachineAddress>& all, const System& system);

}  // namespace onggi::setup
