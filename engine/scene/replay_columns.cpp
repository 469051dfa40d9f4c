#include "engine/scene/replay_columns.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace onggi::replay_bytes {
namespace {

constexpr std::size_t kWidth = 8;        // bytes of a double
constexpr std::size_t kSamples = 4'096;  // moves that a column's rate is chosen from

double number(std::uint64_t bits) { return std::bit_cast<double>(bits); }

// Guesses each number of a column from the two before it. Reader and writer must guess the same
// bits, so only operations are used that IEEE 754 rounds exactly.
class Guess {
 public:
  explicit Guess(double rate) : rate_(rate) {}
  std::uint64_t next() const {
    const double guess = number(last_) + rate_ * (number(last_) - number(before_));
    // The bits of a NaN that was computed differ between processors.
    return std::isfinite(guess) ? std::bit_cast<std::uint64_t>(guess) : last_;
  }
  void take(std::uint64_t bits) {
    before_ = last_;
    last_ = bits;
  }

 private:
  double rate_;
  std::uint64_t last_ = 0, before_ = 0;
};

// Small misses of either sign become small numbers: 0, -1, 1, -2 become 0, 1, 2, 3.
std::uint64_t folded(std::uint64_t miss) { return (miss << 1) ^ (0 - (miss >> 63)); }
std::uint64_t unfolded(std::uint64_t miss) { return (miss >> 1) ^ (0 - (miss & 1)); }

// Calls `each` with three neighbours, at most kSamples times, spread over the column.
template <class Each>
void sample(std::span<const std::uint64_t> bits, Each&& each) {
  const std::size_t stride = 1 + bits.size() / kSamples;
  for (std::size_t n = 2; n < bits.size(); n += stride) each(bits[n - 2], bits[n - 1], bits[n]);
}

// The bits that are left of the sampled numbers.
std::size_t left_by(double rate, std::span<const std::uint64_t> bits) {
  std::size_t left = 0;
  sample(bits, [&](std::uint64_t first, std::uint64_t second, std::uint64_t third) {
    Guess guess(rate);
    guess.take(first);
    guess.take(second);
    left += static_cast<std::size_t>(std::bit_width(folded(third - guess.next())));
  });
  return left;
}

// Either an even motion goes on, or each move is the same part of the move before: the median part.
double best_rate(std::span<const std::uint64_t> bits) {
  std::vector<double> rates;
  sample(bits, [&](std::uint64_t first, std::uint64_t second, std::uint64_t third) {
    const double rate = (number(third) - number(second)) / (number(second) - number(first));
    if (rate > 0.0 && rate < 1.0) rates.push_back(rate);
  });
  if (rates.empty()) return 1.0;
  const auto middle = rates.begin() + static_cast<std::ptrdiff_t>(rates.size() / 2);
  std::nth_element(rates.begin(), middle, rates.end());
  return left_by(*middle, bits) < left_by(1.0, bits) ? *middle : 1.0;
}

std::size_t ticks_with(const Columns& columns, std::uint8_t field) {
  return static_cast<std::size_t>(
      std::count_if(columns.fields.begin(), columns.fields.end(),
                    [field](std::uint8_t tag) { return (tag & field) != 0; }));
}

// The field that each number belongs to, in the order of replay.cpp.
std::uint8_t field_of(std::size_t number) {
  constexpr std::array<std::uint8_t, kNumbers> kFields{
      kHand0, kHand0, kHand0, kHand1, kHand1, kHand1, kWheel,  kTime,   kHold0,  kHold0,
      kHold0, kHold0, kHold1, kHold1, kHold1, kHold1, kSwings, kSwings, kSwings, kSwings};
  return kFields[number];
}

}  // namespace

void write_numbers(Writer& io, std::span<const std::uint64_t> bits) {
  if (bits.empty()) return;
  double rate = best_rate(bits);
  io(rate);
  Guess guess(rate);
  const std::span<std::byte> planes = io.room(kWidth * bits.size());
  for (std::size_t n = 0; n < bits.size(); ++n) {
    const std::uint64_t miss = folded(bits[n] - guess.next());
    guess.take(bits[n]);
    for (std::size_t k = 0; k < kWidth; ++k)
      planes[k * bits.size() + n] = static_cast<std::byte>(miss >> (8 * k));
  }
}

bool read_numbers(Reader& io, std::span<std::uint64_t> bits) {
  if (bits.empty()) return true;
  double rate = 0.0;
  std::span<const std::byte> planes;
  if (!io(rate) || !io.bytes(planes, kWidth * bits.size())) return false;
  Guess guess(rate);
  for (std::size_t n = 0; n < bits.size(); ++n) {
    std::uint64_t miss = 0;
    for (std::size_t k = 0; k < kWidth; ++k)
      miss |= std::to_integer<std::uint64_t>(planes[k * bits.size() + n]) << (8 * k);
    bits[n] = guess.next() + unfolded(miss);
    guess.take(bits[n]);
  }
  return true;
}

void write_columns(Writer& io, const Columns& columns) {
  auto ticks = static_cast<std::uint32_t>(columns.fields.size());
  io(ticks);
  for (std::uint8_t tag : columns.fields) io(tag);
  for (std::uint16_t switches : columns.switches) io(switches);
  for (const auto& column : columns.tools)
    for (std::uint8_t tool : column) io(tool);
  for (const auto& column : columns.numbers) write_numbers(io, column);
}

bool read_columns(Reader& io, std::uint32_t version, Columns& columns) {
  const unsigned known = version < kFirstSwings ? kFieldsBefore : kAllFields;
  std::uint32_t ticks = 0;
  if (!io(ticks) || ticks > io.left()) return false;
  columns.fields.resize(ticks);
  for (std::uint8_t& tag : columns.fields)
    if (!io(tag) || (tag & ~known) != 0) return false;

  // How long each column is follows from the ticks' fields.
  const std::size_t switched = ticks_with(columns, kSwitches);
  if (2 * switched > io.left()) return false;
  columns.switches.resize(switched);
  for (std::uint16_t& switches : columns.switches)
    if (!io(switches)) return false;
  constexpr std::array<std::uint8_t, kMaxHands> kHolds{kHold0, kHold1};
  for (std::size_t hand = 0; hand < columns.tools.size(); ++hand) {
    const std::size_t held = ticks_with(columns, kHolds[hand]);
    if (held > io.left()) return false;
    columns.tools[hand].resize(held);
    for (std::uint8_t& tool : columns.tools[hand])
      if (!io(tool)) return false;
  }
  for (std::size_t n = 0; n < columns.numbers.size(); ++n) {
    const std::size_t count = ticks_with(columns, field_of(n));
    if (kWidth * count > io.left()) return false;
    columns.numbers[n].resize(count);
    if (!read_numbers(io, columns.numbers[n])) return false;
  }
  return true;
}

}  // namespace onggi::replay_bytes
