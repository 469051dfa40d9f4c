#include <cstdio>
#include <iostream>
#include <memory>

#include "engine/base/plain_text.h"
#include "engine/scene/hands.h"
#include "kiosk/picture/drawing/put_report.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/wheel/device/device_access.h"
#include "kiosk/wheel/device/device_kind.h"
#include "kiosk/wheel/device/hidapi_bus.h"

namespace onggi::commands {

namespace {

std::string hex(std::uint16_t number) {
  char text[8];
  std::snprintf(text, sizeof text, "%04x", number);
  return text;
}

/// What the kiosk would do with it now: hands are assigned in order.
std::string use_of(const device::KindInfo& info, int& hands) {
  if (!info.hand) return std::string(info.use);
  if (++hands > kMaxHands) return "is not used: both hands have a device already";
  return std::string(info.use) + (hands == 1 ? " (the first)" : " (the second)");
}

struct Found {
  const device::HidListing listing;
  const device::KindInfo& info;
  std::string use;
  std::optional<Problem> problem;
};

files::Json json_of(const Found& found) {
  return files::Json::object({{"path", found.listing.path},
                              {"vendor", hex(found.listing.vendor)},
                              {"product", hex(found.listing.product)},
                              {"name", found.listing.name},
                              {"bus", found.listing.bluetooth ? "bluetooth" : "usb"},
                              {"kind", std::string(found.info.id)},
                              {"use", found.use},
                              {"force", found.info.force},
                              {"verified_on_hardware", found.info.verified},
                              {"usable", !found.problem},
                              {"missing", found.problem ? found.problem->what : std::string()},
                              {"remedy", found.problem ? found.problem->remedy : std::string()}});
}

void print(const Found& found) {
  std::cout << found.info.name << " (" << hex(found.listing.vendor) << ':'
            << hex(found.listing.product) << ", " << found.listing.path
            << (found.listing.bluetooth ? ", by Bluetooth" : "") << "): " << found.use << ".\n";
  if (!found.info.verified) std::cout << "  Its driver has not been tested on real hardware.\n";
  if (found.problem)
    std::cout << "  " << terminal::plain(found.problem->what) << "\n  "
              << terminal::plain(found.problem->remedy) << '\n';
}

Result<int> devices(const files::Output& json) {
  std::vector<Found> all;
  int hands = 0, others = 0;
  // Open nothing, because a running kiosk uses these devices.
  for (const device::HidListing& listing : device::hidapi_bus()->list()) {
    const auto kind = device::kind_of(listing);
    if (!kind) {
      ++others;
      continue;
    }
    const device::KindInfo& info = device::info_of(*kind);
    auto problem = device::access_problem(listing);
    all.push_back({listing, info, problem ? "cannot be used yet" : use_of(info, hands), problem});
  }
  files::Json list = files::Json::list();
  for (const Found& found : all) list.push_back(json_of(found));
  const auto put = drawing::put_report(
      files::Json::object({{"devices", list}, {"without_driver", others}}), json);
  if (!put) return tl::unexpected(put.error());
  bool missing = false;
  for (const Found& found : all) missing = missing || found.problem;
  if (!*put) return missing ? 1 : 0;
  for (const Found& found : all) print(found);
  if (all.empty())
    std::cout << "No device that Onggi has a driver for is plugged in; mouse and touch always "
                 "work.\n";
  if (others > 0)
    std::cout << others << " other HID interface" << (others == 1 ? "" : "s")
              << " (mice, keyboards and the like) left as they are.\n";
  return missing ? 1 : 0;
}

}  // namespace

cli::Command devices_command() {
  const auto json = std::make_shared<files::Output>(files::Output::Kind::json);
  return {.name = "devices",
          .help = "List the hand devices that are plugged in, and why one cannot be used",
          .examples =
              "Example: onggi devices --json -\n"
              "No device is opened or moved. Exit: 1 if a permission is missing.",
          .options = {{"--json", json.get(), "Write the list as JSON (- for standard output)"}},
          .run = [json] { return devices(*json); }};
}

}  // namespace onggi::commands
