#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace onggi::souvenir {

/// A decorated pot with its relief, as fine as a printer can show it: what its STL is made of. Rows
/// of places go round the pot, from the foot's edge up the outside, over the lip and down the
/// inside to the floor's end. The foot and the floor's middle are flat.
///
/// Round the pot lie `blocks` blocks of kFine places each. Between two rows a block has all its
/// places, or its corner alone where it is even. Two strips that meet in a row have the same places
/// there, so the surface is closed whichever blocks are fine.
struct ReliefModel {
  static constexpr int kFine = 8;          ///< Places of a block.
  static constexpr int kMostBlocks = 400;  ///< And at least 2.
  static constexpr int kMostCorners = 400;
  static constexpr int kMostRows = 20000;

  struct Row {
    float out = 1, up = 0;  ///< Where the body faces, in the plane through the axis; unit length.
    /// The body without relief at even angles from the pot's own angle 0 on: distance from the axis
    /// and height, m, under 2 m. As many in each row.
    std::vector<std::array<float, 2>> body;
    /// Height of the relief over the body at each place, um. kFine * blocks.
    std::vector<std::int16_t> heights;
    /// By block: the strip from this row to the next is fine. The last row's are not looked at.
    std::vector<bool> fine;
  };
  std::string title;
  int blocks = 0;
  std::vector<Row> rows;  ///< 2 at least.
};

/// `model` as the bytes of a file: an index, then groups of kGroup rows, each a Zstandard frame of
/// its own, so that any part can be read without the rest. Heights between the corners of even
/// blocks are left out. `pot`: mark_of_model() of its GLB, which the file then belongs to. The same
/// arguments give the same bytes. Allocates; for a worker thread.
std::vector<std::byte> relief_file(const ReliefModel& model, std::uint32_t pot);

/// What tells a pot's GLB from another's: the CRC-32 of its first kMarked bytes, then of its size
/// in 8 bytes. `begin`: those bytes, or all of them; `size`: of the whole, bytes.
std::uint32_t mark_of_model(std::span<const std::byte> begin, std::uint64_t size);
inline constexpr std::size_t kMarked = 65536;

/// What such a file begins with, and how many rows a group has. After the magic stand seven numbers
/// of 4 bytes: version, rows, blocks, corners, the index' bytes, the pot's mark, and the CRC-32 of
/// all that stands before it and behind it.
inline constexpr const char* kReliefMagic = "ONGGIREL";
inline constexpr std::uint32_t kReliefVersion = 2;
inline constexpr int kReliefGroup = 16;

}  // namespace onggi::souvenir
