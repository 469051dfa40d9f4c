#include "kiosk/picture/drawing/plot_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace onggi::drawing {
namespace {

/// The smallest of 1, 2, 5, 10 times a power of ten that is at least `least`.
double round_step(double least) {
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * decade >= least * (1.0 - 1e-9)) return step * decade;
  return 10.0 * decade;
}

/// `value` with as many decimals as the step between ticks.
std::string figure(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  char out[48];
  if (std::abs(value) >= 1e7 || decimals > 6)
    std::snprintf(out, sizeof out, "%g", value);
  else
    std::snprintf(out, sizeof out, "%.*f", decimals, value);
  return out;
}

/// "1000", "0.01", and "10⁻⁵" if there were too many zeros to count.
std::string decade_figure(int exponent) {
  if (exponent >= -3 && exponent <= 4)
    return figure(std::pow(10.0, exponent), std::pow(10.0, std::min(exponent, 0)));
  static const char* const kRaised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) out += kRaised[c - '0'];
  return out;
}

}  // namespace

PlotScale::PlotScale(const PlotAxis& axis, double low, double high, int marks) : log_(axis.log) {
  marks = std::max(marks, 2);
  if (!(low <= high) || !std::isfinite(low) || !std::isfinite(high)) low = log_ ? 1 : 0, high = 1;
  low_ = axis.low.value_or(low);
  high_ = axis.high.value_or(high);
  if (!axis.names.empty()) {
    low_ = axis.low.value_or(-0.5);
    high_ = axis.high.value_or(static_cast<double>(axis.names.size()) - 0.5);
    for (std::size_t i = 0; i < axis.names.size(); ++i)
      ticks_.push_back({static_cast<double>(i), axis.names[i]});
    return;
  }
  log_ ? mark_decades(axis, marks) : mark_evenly(axis, marks);
}

void PlotScale::mark_evenly(const PlotAxis& axis, int marks) {
  if (high_ - low_ <= 1e-12 * std::max(std::abs(low_), std::abs(high_))) {
    // For a single value, add space around it.
    const double room = low_ == 0.0 ? 1.0 : 0.5 * std::abs(low_);
    if (!axis.low) low_ -= low_ > 0.0 && low_ <= room ? low_ : room;
    if (!axis.high) high_ += room;
  }
  const double step = round_step((high_ - low_) / marks);
  if (!axis.low) low_ = step * std::floor(low_ / step + 1e-9);
  if (!axis.high) high_ = step * std::ceil(high_ / step - 1e-9);
  const auto last = static_cast<long>(std::floor(high_ / step + 1e-6));
  for (auto n = static_cast<long>(std::ceil(low_ / step - 1e-6)); n <= last; ++n) {
    const double at = static_cast<double>(n) * step;
    ticks_.push_back({at, figure(at, step)});
  }
}

void PlotScale::mark_decades(const PlotAxis& axis, int marks) {
  // Outwards to 1, 2 or 5 times a power of ten; for a single value, add space around it.
  if (!axis.low) low_ = 1.0 / round_step(high_ > low_ ? 1.0 / low_ : 2.0 / low_);
  if (!axis.high) high_ = round_step(high_ > low_ ? high_ : 2.0 * high_);
  const int first = static_cast<int>(std::floor(std::log10(low_) + 1e-9));
  const int last = static_cast<int>(std::ceil(std::log10(high_) - 1e-9));
  const int every = 1 + (last - first) / marks;
  const bool close = std::log10(high_ / low_) <= std::min(2.5, marks / 3.0);
  for (int n = first; n <= last; ++n)
    for (int digit = 1; digit <= (every == 1 ? 9 : 1); ++digit) {
      const double at = digit * std::pow(10.0, n);
      if (at < low_ * (1 - 1e-9) || at > high_ * (1 + 1e-9)) continue;
      std::string label;
      if (digit == 1 && (n - first) % every == 0) label = decade_figure(n);
      if (close && (digit == 2 || digit == 5)) label = figure(at, std::pow(10.0, std::min(n, 0)));
      ticks_.push_back({at, label});
    }
}

double PlotScale::share(double value) const {
  if (!log_) return (value - low_) / (high_ - low_);
  return value > 0.0 ? std::log(value / low_) / std::log(high_ / low_) : std::nan("");
}

}  // namespace onggi::drawing
