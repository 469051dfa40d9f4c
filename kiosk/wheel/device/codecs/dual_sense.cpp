#include "kiosk/wheel/device/codecs/dual_sense.h"

#include "kiosk/ground/files/crc32.h"

namespace onggi::device::dual_sense {

namespace {

constexpr std::size_t kCable = 64, kCableOut = 63, kRadio = 78;
// First byte of a Bluetooth HID transaction. The checksum includes it, the report does not.
constexpr std::uint8_t kInSeed = 0xA1, kOutSeed = 0xA2;

std::uint32_t check_of(std::uint8_t seed, Report bytes) {
  const std::array<std::uint8_t, 1> first{seed};
  return files::crc32(bytes, files::crc32(first));
}

void read_payload(Report p, State& state) {
  state.left = {p[0], p[1]};
  state.right = {p[2], p[3]};
  state.trigger = {p[4], p[5]};
  state.sequence = p[6];
  state.buttons = u32_at(p, 7);
  for (std::size_t n = 0; n < 3; ++n) {
    state.turn[n] = i16_at(p, 15 + 2 * n);
    state.pull[n] = i16_at(p, 21 + 2 * n);
  }
  state.time = u32_at(p, 27);
}

}  // namespace

ReportResult read(Report report, Bus bus, State& state) noexcept {
  if (report.empty()) return ReportResult::broken;
  if (bus == Bus::usb) {
    if (report[0] != 0x01) return ReportResult::nothing;
    if (report.size() != kCable) return ReportResult::broken;
    read_payload(report.subspan(1), state);
    return ReportResult::news;
  }
  if (report[0] != 0x31) return ReportResult::nothing;
  if (report.size() != kRadio) return ReportResult::broken;
  if (u32_at(report, kRadio - 4) != check_of(kInSeed, report.first(kRadio - 4)))
    return ReportResult::broken;
  read_payload(report.subspan(2), state);
  return ReportResult::news;
}

Output rumble(Bus bus, std::uint8_t slow, std::uint8_t quick, std::uint8_t sequence) noexcept {
  Output out;
  std::size_t at = 1;
  if (bus == Bus::usb) {
    out.size = kCableOut;
    out.bytes[0] = 0x02;
  } else {
    out.size = kRadio;
    out.bytes[0] = 0x31;
    out.bytes[1] = static_cast<std::uint8_t>((sequence & 15) << 4);
    out.bytes[2] = 0x10;
    at = 3;
  }
  // Use the two classic motors instead of sound through the grips.
  out.bytes[at] = 0x03;
  out.bytes[at + 2] = quick;
  out.bytes[at + 3] = slow;
  if (bus == Bus::bluetooth)
    put_u32(out.bytes, kRadio - 4, check_of(kOutSeed, Report(out.bytes).first(kRadio - 4)));
  return out;
}

}  // namespace onggi::device::dual_sense
