#pragma once

#include <string>

namespace onggi::watch {

/// Messages to systemd (sd_notify). Without systemd they do nothing, so a kiosk in a window needs
/// none. Any thread; sends a datagram, which waits only if systemd accepts none.
class Service {
 public:
  /// Seconds within which systemd expects alive(); 0 if it does not.
  static double watchdog_s();
  /// The kiosk is ready for visitors.
  static void ready();
  static void alive();
  /// One line for `systemctl status`.
  static void says(const std::string& line);
  static void ends();
};

}  // namespace onggi::watch
