#pragma once

#include <array>
#include <cstdint>

#include "engine/math/vec.h"
#include "kiosk/wheel/device/codecs/wire_bytes.h"

namespace onggi::device::onggi_hid {

/// The protocol is defined in kiosk/docs/onggi-hid.md, version 1; kiosk/wheel/device/reference is
/// the device's side.

/// Bits of Input::flags.
enum Flag : std::uint8_t {
  kArmed = 1u << 0,      ///< It may push.
  kHasSensor = 1u << 1,  ///< It has a hand sensor,
  kHeld = 1u << 2,       ///< and a hand is there.
  kPowered = 1u << 3,    ///< Its motors have their supply.
};

/// The device's answer to its last output.
enum class Status : std::uint16_t {
  good = 0,
  bad_check = 1,  ///< A report's CRC-32 or length was wrong.
  old = 2,        ///< A report was not newer than the last.
  ran_out = 3,    ///< No valid report came within its ttl: the force is off; arm again.
  not_armed = 4,  ///< A force came without arming.
  not_held = 5,   ///< Arming was requested, but nobody holds it.
  suspended = 6,
};

struct Input {
  std::uint8_t flags = 0;  ///< Flag.
  std::uint16_t sequence = 0;
  std::uint32_t time = 0;  ///< Microseconds, wraps.
  Vec3 position;           ///< Metres, the device's own frame.
  std::uint16_t buttons = 0;
  std::uint16_t echo = 0;  ///< The sequence of the last output that it accepted.
  std::uint16_t status = 0;
};

enum class Mode : std::uint8_t {
  off = 0,    ///< Motors free at once; not armed. Accepted with any sequence, which starts again.
  arm = 1,    ///< Send with zero force while the handle is held.
  force = 2,  ///< Push, if armed.
};

struct Output {
  Mode mode = Mode::off;
  std::uint16_t sequence = 0;
  Vec3 force;            ///< N, the device's frame; -32.767..32.767 an axis, 1 mN.
  double damping = 0.0;  ///< N s/m, 0..65.535: the device makes it, against its handle's speed.
  double ttl = 0.020;    ///< s, 0.001..65.535: the force ends this long after the last output.
  double cap = 0.0;      ///< N, 0..65.535: upper limit, whatever `force` is.
};

/// What the device can do.
struct Feature {
  std::uint8_t version = 1;
  double max_force = 0.0;      ///< N
  Vec3 least, most;            ///< Workspace, metres.
  double resolution = 0.0;     ///< Metres.
  std::uint16_t firmware = 0;  ///< Major and minor, a byte each.
};

inline constexpr std::uint8_t kInputId = 1, kOutputId = 2, kFeatureId = 3;
inline constexpr std::size_t kInputSize = 32, kOutputSize = 20, kFeatureSize = 28;

/// True if `now` is later than `before`, counted modulo 2^16; half way round counts as not later.
constexpr bool newer(std::uint16_t now, std::uint16_t before) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(now - before)) > 0;
}

/// Reads input 01 of 32 bytes; a wrong length or CRC-32 gives broken and leaves `input` alone. The
/// caller checks that it is newer than the last. Pure.
ReportResult read(Report report, Input& input) noexcept;
ReportResult read_feature(Report report, Feature& feature) noexcept;

/// The bytes of an output. Limits values to their range; NaN becomes 0. Pure.
std::array<std::uint8_t, kOutputSize> write(const Output& output) noexcept;

}  // namespace onggi::device::onggi_hid
