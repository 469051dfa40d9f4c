#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::console {

/// The addresses under which browsers reach the staff's page.
struct ServedAt {
  std::vector<std::string>
      pages{};  ///< "http://127.0.0.1:8090", "https://192.168.1.20"; not empty.
  std::vector<std::string> hosts{};  ///< The Host fields that belong to them, and no others.
  bool https = false;                ///< A proxy serves them by HTTPS; else this program by HTTP.
  /// The session's cookie: it stays within this machine's name, and with `https` within HTTPS
  /// (Door).
  std::string cookie{};
};

/// For a program that listens at `address` and `port` itself: this machine alone reaches it.
ServedAt served_here(const std::string& address, std::uint16_t port);

/// For a program behind a proxy: `addresses` as "https://HOST[:PORT]". Problem, exit 2: none, or
/// one that is no such address.
Result<ServedAt> served_by_proxy(const std::vector<std::string>& addresses);

}  // namespace onggi::console
