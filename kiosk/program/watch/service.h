#pragma once

#include <string>

namespace onggi::watch {

/// What systemd is told of this process (sd_notify). All of it does nothing where no systemd
/// started it, so that a kiosk in a window needs none. Any thread; a datagram on a socket, which
/// waits only for a systemd that takes none at all.
class Service {
 public:
  /// Seconds within which systemd wants to hear alive(); 0 where it does not.
  static double watchdog_s();
  /// Visitors may come.
  static void ready();
  static void alive();
  /// One line for `systemctl status`.
  static void says(const std::string& line);
  static void ends();
};

}  // namespace onggi::watch
