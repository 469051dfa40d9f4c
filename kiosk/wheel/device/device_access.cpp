#include "kiosk/wheel/device/device_access.h"

#include <errno.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>

namespace onggi::device {

std::string udev_rule(const HidListing& listing) {
  char text[160];
  // The kernel names a HID device BUS:VENDOR:PRODUCT.NUMBER, both by cable and by Bluetooth.
  std::snprintf(text, sizeof text,
                "SUBSYSTEM==\"hidraw\", KERNELS==\"*:%04X:%04X.*\", GROUP=\"onggi\", MODE=\"0660\"",
                listing.vendor, listing.product);
  return text;
}

std::optional<Problem> access_problem(const HidListing& listing) {
  if (access(listing.path.c_str(), R_OK | W_OK) == 0) return std::nullopt;
  const int why = errno;
  if (why == EACCES || why == EPERM)
    return Problem{listing.path, "This user may not read and write it.",
                   "Run: sudo groupadd --system --force onggi. Put config/udev/70-onggi-hid.rules "
                   "into /etc/udev/rules.d, or this line: " +
                       udev_rule(listing) +
                       " Then: sudo udevadm control --reload && sudo udevadm trigger "
                       "--subsystem-match=hidraw, and add the kiosk's user to the group: sudo "
                       "usermod -aG onggi $USER. Then log in again.",
                   1};
  // A device without a file under /dev/: only opening it can tell.
  if (why == ENOENT && listing.path.rfind("/dev/", 0) != 0) return std::nullopt;
  return Problem{listing.path, std::string("It cannot be used: ") + std::strerror(why) + ".",
                 "Unplug it, plug it in again, and run onggi devices.", 1};
}

}  // namespace onggi::device
