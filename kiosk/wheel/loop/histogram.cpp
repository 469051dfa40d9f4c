#include "kiosk/wheel/loop/histogram.h"

#include <algorithm>
#include <bit>

namespace onggi::loop {

Histogram::Histogram(const std::array<std::uint32_t, kBins>& counts, double most) noexcept
    : counts_(counts), most_(most) {
  for (const std::uint32_t count : counts_) total_ += count;
}

int Histogram::bin_of(double us) noexcept {
  if (!(us > 0.0)) return 0;
  const auto whole = static_cast<std::uint64_t>(std::min(us, 4e9));
  if (whole < 32) return static_cast<int>(whole);
  // The five bits below the highest one.
  const int octave = static_cast<int>(std::bit_width(whole)) - 6;
  const int bin = 32 + 32 * octave + static_cast<int>((whole >> octave) - 32);
  return std::min(bin, kBins - 1);
}

Histogram Histogram::since(const Histogram& earlier) const noexcept {
  Histogram between;
  for (std::size_t n = 0; n < counts_.size(); ++n) {
    between.counts_[n] = counts_[n] - earlier.counts_[n];
    between.total_ += between.counts_[n];
    if (between.counts_[n] > 0) between.most_ = std::min(upper_end(static_cast<int>(n)), most_);
  }
  return between;
}

double Histogram::upper_end(int bin) noexcept {
  if (bin < 32) return bin + 1.0;
  const int octave = (bin - 32) / 32, step = (bin - 32) % 32;
  return static_cast<double>(static_cast<std::uint64_t>(33 + step) << octave);
}

double Histogram::quantile(double share) const noexcept {
  if (total_ == 0) return 0.0;
  const double wanted = share * static_cast<double>(total_);
  std::uint64_t seen = 0;
  for (int bin = 0; bin < kBins; ++bin) {
    seen += counts_[static_cast<std::size_t>(bin)];
    if (static_cast<double>(seen) >= wanted) return std::min(upper_end(bin), most_);
  }
  return most_;
}

}  // namespace onggi::loop
