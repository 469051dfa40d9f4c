#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/scene/hands.h"
#include "engine/scene/replay_bytes.h"

namespace onggi::replay_bytes {

inline constexpr std::size_t kNumbers = 8 + 6 * kMaxHands;  ///< Doubles of a TickRecord.

/// The hash of the scene's state after `tick` ticks.
struct Note {
  std::uint64_t tick = 0;
  std::uint64_t hash = 0;
};

/// What changed in each tick, a column for each value of a TickRecord. A column holds only the
/// ticks in which its field changed.
struct Columns {
  std::vector<std::uint8_t> fields;     ///< Of each tick: which fields changed (Tag).
  std::vector<std::uint16_t> switches;  ///< See switches_of().
  std::array<std::vector<std::uint8_t>, kMaxHands> tools;
  std::array<std::vector<std::uint64_t>, kNumbers> numbers;  ///< The doubles' bits.
};

/// Writes `columns` so that a general packer finds little left in them (write_numbers()).
void write_columns(Writer& io, const Columns& columns);

/// False if the bytes end or if a tick has a field that `version` does not know. Allocates no more
/// than the bytes can fill.
bool read_columns(Reader& io, std::uint32_t version, Columns& columns);

/// Writes doubles, given and restored by their bits (also NaN and -0). Each is guessed from the two
/// before it: the last one, moved on by `rate` times the last move. The rate of a column stands
/// before it: 1 for a hand that moves evenly, less for one that comes to rest at its target. What
/// the guess missed by, in steps from one double to the next, is written by bytes: all lowest
/// bytes, then all second ones, up to the highest, nearly all of them zero.
void write_numbers(Writer& io, std::span<const std::uint64_t> bits);

/// Reads as many doubles as `bits` has room for. False if the bytes end.
bool read_numbers(Reader& io, std::span<std::uint64_t> bits);

}  // namespace onggi::replay_bytes
