#include "kiosk/wheel/device/driver.h"

namespace onggi::device {

std::unique_ptr<Driver> make_driver(DeviceKind kind, const HidListing& listing,
                                    const DeviceDef& def) {
  switch (kind) {
    case DeviceKind::space_mouse:
      return make_space_mouse();
    case DeviceKind::surface_dial:
      return make_surface_dial();
    case DeviceKind::dual_sense:
      return make_dual_sense(listing.bluetooth);
    case DeviceKind::polhem:
      return make_polhem(def.arm);
    case DeviceKind::onggi_hid:
      return make_onggi_hid();
  }
  return nullptr;
}

}  // namespace onggi::device
