#include "kiosk/wheel/device/driver.h"

#include "kiosk/wheel/device/drivers/dual_sense_driver.h"
#include "kiosk/wheel/device/drivers/onggi_hid_driver.h"
#include "kiosk/wheel/device/drivers/polhem_driver.h"
#include "kiosk/wheel/device/drivers/space_mouse_driver.h"
#include "kiosk/wheel/device/drivers/surface_dial_driver.h"

namespace onggi::device {

std::unique_ptr<Driver> make_driver(DeviceKind kind, const HidListing& listing,
                                    const DeviceDef& def) {
  switch (kind) {
    case DeviceKind::space_mouse:
      return std::make_unique<SpaceMouseDriver>();
    case DeviceKind::surface_dial:
      return std::make_unique<SurfaceDialDriver>();
    case DeviceKind::dual_sense:
      return std::make_unique<DualSenseDriver>(listing.bluetooth);
    case DeviceKind::polhem:
      return std::make_unique<PolhemDriver>(def.arm);
    case DeviceKind::onggi_hid:
      return std::make_unique<OnggiHidDriver>();
  }
  return nullptr;
}

}  // namespace onggi::device
