// Any bytes as the reports of one device (ONGGI_CODEC). They are cut into reports by a length byte
// before each; where a report has a CRC-32, it is also read with that put right, so that the fuzzer
// gets past it. Nothing may crash, and what comes out is in range.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "kiosk/ground/files/crc32.h"
#include "kiosk/wheel/device/arm_kinematics.h"
#include "kiosk/wheel/device/codecs/dual_sense.h"
#include "kiosk/wheel/device/codecs/onggi_hid.h"
#include "kiosk/wheel/device/codecs/polhem.h"
#include "kiosk/wheel/device/codecs/space_mouse.h"
#include "kiosk/wheel/device/codecs/surface_dial.h"
#include "kiosk/wheel/device/reference/onggi_hid_device.h"

namespace onggi::device {
namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

/// The report with its last four bytes made its check.
std::vector<std::uint8_t> put_right(Report report, Report before = {}) {
  std::vector<std::uint8_t> right(report.begin(), report.end());
  if (right.size() < 5) return right;
  const std::size_t at = right.size() - 4;
  put_u32(right, at, files::crc32(Report(right).first(at), files::crc32(before)));
  return right;
}

class FuzzSpaceMouse {
 public:
  void report(Report bytes) {
    space_mouse::read(bytes, state_);
    for (const auto& axes : {state_.push, state_.twist})
      for (const std::int16_t value : axes) require(std::abs(value) <= space_mouse::kFull);
    require(state_.battery <= 100 || state_.battery == 0xff);
  }

 private:
  space_mouse::State state_;
};

class FuzzSurfaceDial {
 public:
  void report(Report bytes) {
    const std::int64_t before = state_.turned;
    surface_dial::read(bytes, state_);
    require(std::llabs(state_.turned - before) <= 32768);
  }

 private:
  surface_dial::State state_;
};

class FuzzDualSense {
 public:
  void report(Report bytes) {
    const std::uint8_t seed[] = {0xA1};
    dual_sense::read(bytes, dual_sense::Bus::usb, state_);
    dual_sense::read(bytes, dual_sense::Bus::bluetooth, state_);
    dual_sense::read(put_right(bytes, seed), dual_sense::Bus::bluetooth, state_);
  }

 private:
  dual_sense::State state_;
};

class FuzzPolhem {
 public:
  void report(Report bytes) {
    polhem::Input input;
    std::vector<std::uint8_t> whole(bytes.begin(), bytes.end());
    polhem::read(whole, input);
    whole.resize(polhem::kInputSize);
    require(polhem::read(whole, input) == ReportResult::news);
    const ArmDef arm;
    const ArmAngles at = arm_angles(arm, {input.encoder[0], input.encoder[1], input.encoder[2]});
    require(is_finite(arm_position(arm, at)));
    const Vec3 force{double(input.encoder[3]), double(input.encoder[4]), double(input.encoder[5])};
    const auto out = polhem::currents(arm_currents(arm, at, force), arm.most_milliamperes);
    for (std::size_t n = 0; n < 3; ++n)
      require(std::abs(i16_at(out, 1 + 2 * n)) <= arm.most_milliamperes);
  }
};

class FuzzOnggiHid {
 public:
  void report(Report bytes) {
    onggi_hid::Input input;
    onggi_hid::Feature feature;
    onggi_hid::read(bytes, input);
    onggi_hid::read_feature(bytes, feature);
    const auto right = put_right(bytes);
    if (onggi_hid::read(right, input) == ReportResult::news) require(is_finite(input.position));
    if (onggi_hid::read_feature(right, feature) == ReportResult::news)
      require(feature.max_force <= 65.6);
  }
};

class FuzzReference {
 public:
  FuzzReference() {
    const onggi_hid_build build{5000, 20, {-1000, -1000, -1000}, {1000, 1000, 1000}, 50, 1, 1};
    onggi_hid_start(&device_, &build);
  }
  void report(Report bytes) {
    onggi_hid_take(&device_, bytes.data(), bytes.size());
    const auto right = put_right(bytes);
    onggi_hid_take(&device_, right.data(), right.size());
    std::int32_t place[3] = {0, 0, 0};
    for (std::size_t n = 0; n < 3 && 4 * n + 4 <= bytes.size(); ++n)
      place[n] = i32_at(bytes, 4 * n);
    const auto first = bytes.empty() ? 0u : bytes[0];
    onggi_hid_tick(&device_, 1 + first * 391u, place, (first & 1) != 0, (first & 2) == 0, 0);
    std::int32_t f[3];
    onggi_hid_force(&device_, f);
    const double strength = length({double(f[0]), double(f[1]), double(f[2])});
    require(strength <= 5000.0);
    if ((first & 2) != 0) require(strength == 0.0);
    std::uint8_t said[ONGGI_HID_INPUT_SIZE];
    onggi_hid_input(&device_, said);
    onggi_hid::Input input;
    require(onggi_hid::read(said, input) == ReportResult::news);
  }

 private:
  onggi_hid_device device_{};
};

// By the codec's own name, as the build gives it.
using space_mouse_codec = FuzzSpaceMouse;
using surface_dial_codec = FuzzSurfaceDial;
using dual_sense_codec = FuzzDualSense;
using polhem_codec = FuzzPolhem;
using onggi_hid_codec = FuzzOnggiHid;
using reference_codec = FuzzReference;

#define ONGGI_JOINED(a, b) a##b
#define ONGGI_JOIN(a, b) ONGGI_JOINED(a, b)
using Fuzzed = ONGGI_JOIN(ONGGI_CODEC, _codec);

}  // namespace
}  // namespace onggi::device

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace onggi::device;
  Report rest(data, size);
  Fuzzed fuzzed;
  while (!rest.empty()) {
    const std::size_t length = std::min<std::size_t>(rest[0], rest.size() - 1);
    fuzzed.report(rest.subspan(1, length));
    rest = rest.subspan(1 + length);
  }
  return 0;
}
