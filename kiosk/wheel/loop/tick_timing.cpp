#include "kiosk/wheel/loop/tick_timing.h"

namespace onggi::loop {

void LiveHistogram::add(double us) noexcept {
  auto& count = counts_[static_cast<std::size_t>(Histogram::bin_of(us))];
  // There is one writer, so a locked addition is not needed.
  count.store(count.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  if (us > most_.load(std::memory_order_relaxed)) most_.store(us, std::memory_order_relaxed);
}

Histogram LiveHistogram::look() const noexcept {
  std::array<std::uint32_t, Histogram::kBins> counts{};
  for (std::size_t n = 0; n < counts.size(); ++n)
    counts[n] = counts_[n].load(std::memory_order_relaxed);
  return Histogram(counts, most_.load(std::memory_order_relaxed));
}

}  // namespace onggi::loop
