#include "kiosk/wheel/device/device_kind.h"

#include <algorithm>

namespace onggi::device {

namespace {

constexpr std::array<KindInfo, 5> kKinds{{
    {DeviceKind::space_mouse, "space_mouse", "3Dconnexion SpaceMouse", "moves a hand", true},
    {DeviceKind::surface_dial, "surface_dial", "Microsoft Surface Dial", "turns the wheel"},
    {DeviceKind::dual_sense, "dual_sense", "Sony DualSense",
     "moves a hand, and vibrates at a touch", true},
    {DeviceKind::polhem, "polhem", "Polhem or WoodenHaptics", "is a hand, with force", true, true,
     false},
    {DeviceKind::onggi_hid, "onggi_hid", "onggi-hid", "is a hand, with force", true, true},
}};

constexpr std::array<std::uint16_t, 10> kConnexion{0xc62e, 0xc62f, 0xc631, 0xc632, 0xc633,
                                                   0xc635, 0xc636, 0xc638, 0xc63a, 0xc652};
constexpr std::array<std::uint16_t, 11> kLogitech{0xc603, 0xc605, 0xc606, 0xc621, 0xc623, 0xc625,
                                                  0xc626, 0xc627, 0xc628, 0xc629, 0xc62b};

template <std::size_t N>
bool has(const std::array<std::uint16_t, N>& ids, std::uint16_t id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

bool is(const HidListing& l, std::uint16_t page, std::uint16_t usage) {
  return l.usage_page == page && l.usage == usage;
}

}  // namespace

std::span<const KindInfo> device_kinds() { return kKinds; }

const KindInfo& info_of(DeviceKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

std::optional<DeviceKind> kind_of(const HidListing& l) {
  const bool puck = (l.vendor == 0x256f && has(kConnexion, l.product)) ||
                    (l.vendor == 0x046d && has(kLogitech, l.product));
  // A receiver or a cabled puck also lists keyboards and mice.
  if (puck) return is(l, 1, 8) ? std::optional(DeviceKind::space_mouse) : std::nullopt;
  // The dial also lists a keyboard collection and a multi-axis collection.
  if (l.vendor == 0x045e && l.product == 0x091b)
    return is(l, 1, 0x0e) ? std::optional(DeviceKind::surface_dial) : std::nullopt;
  if (l.vendor == 0x054c && l.product == 0x0ce6)
    return is(l, 1, 5) ? std::optional(DeviceKind::dual_sense) : std::nullopt;
  if (is(l, 0xff00, 1)) return DeviceKind::onggi_hid;
  // Any Teensy may have these numbers, so the driver waits for an answer that only an arm gives. A
  // Teensy lists a serial emulation beside its raw HID.
  if ((l.vendor == 0x16c0 && l.product == 0x0486 && !is(l, 0xffc9, 4)) ||
      (l.vendor == 0x1234 && l.product == 0x0006))
    return DeviceKind::polhem;
  return std::nullopt;
}

}  // namespace onggi::device
