#include "kiosk/program/watch/service.h"

#include <systemd/sd-daemon.h>

#include <cstdint>

namespace onggi::watch {

double Service::watchdog_s() {
  std::uint64_t us = 0;
  return sd_watchdog_enabled(0, &us) > 0 ? static_cast<double>(us) * 1e-6 : 0.0;
}

void Service::ready() { sd_notify(0, "READY=1"); }
void Service::alive() { sd_notify(0, "WATCHDOG=1"); }
void Service::says(const std::string& line) { sd_notify(0, ("STATUS=" + line).c_str()); }
void Service::ends() { sd_notify(0, "STOPPING=1"); }

}  // namespace onggi::watch
