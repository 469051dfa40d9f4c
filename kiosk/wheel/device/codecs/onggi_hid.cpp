#include "kiosk/wheel/device/codecs/onggi_hid.h"

#include <algorithm>
#include <cmath>

#include "kiosk/ground/files/crc32.h"

namespace onggi::device::onggi_hid {

namespace {

constexpr double kPositionUnit = 1e-7;   // metres
constexpr double kWorkspaceUnit = 1e-4;  // metres
constexpr double kMilli = 1e-3;

bool good_check(Report report) {
  const std::size_t at = report.size() - 4;
  return u32_at(report, at) == files::crc32(report.first(at));
}

/// `value` in units of 1/1000, within the limits; NaN gives 0.
int in_thousandths(double value, int least, int most) {
  if (!std::isfinite(value)) return 0;
  return static_cast<int>(std::clamp(std::nearbyint(value / kMilli), double(least), double(most)));
}

Vec3 corner_at(Report report, std::size_t at) {
  return {i16_at(report, at) * kWorkspaceUnit, i16_at(report, at + 2) * kWorkspaceUnit,
          i16_at(report, at + 4) * kWorkspaceUnit};
}

}  // namespace

ReportResult read(Report report, Input& input) noexcept {
  if (report.empty()) return ReportResult::broken;
  if (report[0] != kInputId) return ReportResult::nothing;
  if (report.size() != kInputSize || !good_check(report)) return ReportResult::broken;
  input.flags = report[1];
  input.sequence = u16_at(report, 2);
  input.time = u32_at(report, 4);
  input.position = {i32_at(report, 8) * kPositionUnit, i32_at(report, 12) * kPositionUnit,
                    i32_at(report, 16) * kPositionUnit};
  input.buttons = u16_at(report, 20);
  input.echo = u16_at(report, 22);
  input.status = u16_at(report, 24);
  return ReportResult::news;
}

ReportResult read_feature(Report report, Feature& feature) noexcept {
  if (report.empty()) return ReportResult::broken;
  if (report[0] != kFeatureId) return ReportResult::nothing;
  if (report.size() != kFeatureSize || !good_check(report)) return ReportResult::broken;
  feature.version = report[1];
  feature.max_force = u16_at(report, 2) * kMilli;
  feature.least = corner_at(report, 4);
  feature.most = corner_at(report, 10);
  feature.resolution = u16_at(report, 16) * kPositionUnit;
  feature.firmware = u16_at(report, 18);
  return ReportResult::news;
}

std::array<std::uint8_t, kOutputSize> write(const Output& output) noexcept {
  std::array<std::uint8_t, kOutputSize> bytes{};
  bytes[0] = kOutputId;
  bytes[1] = static_cast<std::uint8_t>(output.mode);
  put_u16(bytes, 2, output.sequence);
  const double force[] = {output.force.x, output.force.y, output.force.z};
  for (std::size_t n = 0; n < 3; ++n)
    put_i16(bytes, 4 + 2 * n, static_cast<std::int16_t>(in_thousandths(force[n], -32767, 32767)));
  put_u16(bytes, 10, static_cast<std::uint16_t>(in_thousandths(output.damping, 0, 65535)));
  put_u16(bytes, 12, static_cast<std::uint16_t>(in_thousandths(output.ttl, 1, 65535)));
  put_u16(bytes, 14, static_cast<std::uint16_t>(in_thousandths(output.cap, 0, 65535)));
  put_u32(bytes, 16, files::crc32(Report(bytes).first(kOutputSize - 4)));
  return bytes;
}

}  // namespace onggi::device::onggi_hid
