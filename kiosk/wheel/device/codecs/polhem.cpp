#include "kiosk/wheel/device/codecs/polhem.h"

#include <algorithm>
#include <cmath>

namespace onggi::device::polhem {

ReportResult read(Report report, Input& input) noexcept {
  if (report.size() != kInputSize) return ReportResult::broken;
  for (std::size_t n = 0; n < input.encoder.size(); ++n) input.encoder[n] = i16_at(report, 2 * n);
  input.info = i16_at(report, 12);
  return ReportResult::news;
}

std::array<std::uint8_t, kOutputSize> currents(const std::array<double, 3>& milliamperes,
                                               double most) noexcept {
  std::array<std::uint8_t, kOutputSize> bytes{};  // the first byte: no id
  const double limit = std::isfinite(most) ? std::clamp(std::floor(most), 0.0, 32767.0) : 0.0;
  double largest = 0.0;
  for (const double value : milliamperes) {
    // If one motor's value is NaN, stop all three: two alone would push in another direction.
    if (!std::isfinite(value)) return bytes;
    largest = std::max(largest, std::fabs(value));
  }
  // Reduce all by one factor, for the same reason.
  const double share = largest > limit ? limit / largest : 1.0;
  for (std::size_t n = 0; n < 3; ++n) {
    const double value = std::clamp(share * milliamperes[n], -limit, limit);
    put_i16(bytes, 1 + 2 * n, static_cast<std::int16_t>(std::nearbyint(value)));
  }
  return bytes;
}

std::array<std::uint8_t, kOutputSize> calibrate(
    const std::array<std::int16_t, 3>& counts) noexcept {
  std::array<std::uint8_t, kOutputSize> bytes{};
  put_i16(bytes, 7, 1);
  for (std::size_t n = 0; n < 3; ++n) put_i16(bytes, 9 + 2 * n, counts[n]);
  return bytes;
}

}  // namespace onggi::device::polhem
