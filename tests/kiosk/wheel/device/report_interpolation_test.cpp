#include "kiosk/wheel/device/report_interpolation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace onggi::device::report_interpolation_test {
namespace {

struct Joined {
  double lag_ms = 0.0;     // behind the hand,
  double staircase = 0.0;  // of what the reports alone are behind it
  double rough = 0.0;      // RMS of what the speed changes by in a tick, m/s,
  double stairs = 0.0;     // and of the reports themselves
};

/// A hand that goes 20 mm to and fro 1.5 times a second, told every `apart` ms.
Joined join(int apart, double smoothing) {
  ReportInterpolation joining;
  const auto hand = [](double ms) { return 0.02 * std::sin(2.0 * std::numbers::pi * 1.5e-3 * ms); };
  std::vector<double> out, told;
  std::uint64_t reports = 0;
  double place = 0.0;
  std::int64_t at = 0;
  for (int ms = 0; ms < 3000; ++ms) {
    if (ms % apart == 0) {
      place = hand(ms);
      at = ms * 1'000'000LL;
      ++reports;
    }
    told.push_back(place);
    out.push_back(joining.at({place, 0, 0}, reports, at, ms * 1'000'000LL, 1e-3, smoothing).x);
  }
  const auto lag = [&](const std::vector<double>& way) {
    double best = 0.0, least = 1e9;
    for (double late = -5.0; late < 40.0; late += 0.1) {
      double sum = 0.0;
      for (std::size_t n = 500; n < way.size(); ++n) {
        const double d = way[n] - hand(static_cast<double>(n) - late);
        sum += d * d;
      }
      if (sum < least) {
        least = sum;
        best = late;
      }
    }
    return best;
  };
  const auto rough = [](const std::vector<double>& way) {
    double sum = 0.0;
    for (std::size_t n = 502; n < way.size(); ++n) {
      const double change = (way[n] - 2.0 * way[n - 1] + way[n - 2]) * 1e3;
      sum += change * change;
    }
    return std::sqrt(sum / static_cast<double>(way.size() - 502));
  };
  return {lag(out), lag(told), rough(out), rough(told)};
}

TEST(ReportInterpolation, SlowReportsBecomeASmoothWayNoMoreThanTenMillisecondsLater) {
  for (const int apart : {8, 16}) {
    const Joined joined = join(apart, 0.008);
    EXPECT_LT(joined.lag_ms - joined.staircase, 10.0) << apart;
    EXPECT_LT(joined.lag_ms, 2.0) << apart << ": going on makes good what waiting costs";
    EXPECT_LT(joined.rough, 0.05 * joined.stairs) << apart;
    RecordProperty("lag_us_" + std::to_string(apart), static_cast<int>(1e3 * joined.lag_ms));
  }
}

TEST(ReportInterpolation, AnEvenWayIsJoinedWithoutAnyLag) {
  ReportInterpolation joining;
  Vec3 at;
  for (int ms = 0; ms < 400; ++ms) {
    const int told = ms - ms % 16;
    at = joining.at({1e-4 * told, 0, 0}, static_cast<std::uint64_t>(told / 16 + 1),
                    told * 1'000'000LL, ms * 1'000'000LL, 1e-3, 0.008);
  }
  EXPECT_NEAR(at.x, 1e-4 * 399, 1e-6);
}

TEST(ReportInterpolation, AHandThatStopsIsOvershotByOneReportsWayAndComesBack) {
  ReportInterpolation joining;
  double farthest = 0.0, last = 0.0;
  for (int ms = 0; ms < 400; ++ms) {
    const int told = std::min(ms - ms % 16, 192);
    last = joining
               .at({1e-4 * told, 0, 0}, static_cast<std::uint64_t>((ms - ms % 16) / 16 + 1),
                   (ms - ms % 16) * 1'000'000LL, ms * 1'000'000LL, 1e-3, 0.008)
               .x;
    farthest = std::max(farthest, last);
  }
  EXPECT_LT(farthest, 1e-4 * (192 + 16));
  EXPECT_NEAR(last, 1e-4 * 192, 1e-9);
}

TEST(ReportInterpolation, ReportsThatAreFarApartAreNotGuessedBetween) {
  ReportInterpolation joining;
  joining.at({0, 0, 0}, 1, 0, 0, 1e-3, 0.008);
  for (int ms = 100; ms < 130; ++ms) {
    const Vec3 at = joining.at({0.01, 0, 0}, 2, 100'000'000LL, ms * 1'000'000LL, 1e-3, 0.008);
    EXPECT_LE(at.x, 0.01);
  }
}

}  // namespace
}  // namespace onggi::device::report_interpolation_test
