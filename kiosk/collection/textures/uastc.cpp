#include "kiosk/collection/textures/uastc.h"

#include <algorithm>
#include <string>

#include "kiosk/collection/textures/bit_reader.h"

namespace onggi::textures {
namespace {

/// How a mode packs its endpoints: a whole number of bits, and perhaps a digit in base 3 or 5.
struct Range {
  int bits;
  std::uint32_t base;  ///< 3 trits, 5 quints, 1 neither.
};
constexpr Range k12{2, 3}, k16{4, 1}, k32{5, 1}, k40{3, 5}, k48{4, 3}, k160{5, 5}, k192{6, 3},
    k256{8, 1};

/// The nineteen modes: a block's first code, and its content.
struct Mode {
  std::uint32_t code;
  int code_bits, hint_bits, weight_bits;
  Range range;
  int channels;  ///< 2 light and alpha, 3, or 4 with alpha.
  int subsets, planes;
};
constexpr int kSolid = 8;
constexpr std::array<Mode, 19> kModes{{
    {0x01, 4, 15, 4, k192, 3, 1, 1}, {0x35, 6, 15, 2, k256, 3, 1, 1},
    {0x1D, 5, 15, 3, k16, 3, 2, 1},  {0x03, 5, 15, 2, k12, 3, 3, 1},
    {0x13, 5, 15, 2, k40, 3, 2, 1},  {0x0B, 5, 15, 3, k256, 3, 1, 1},
    {0x1B, 5, 15, 2, k160, 3, 1, 2}, {0x07, 5, 15, 2, k40, 3, 2, 1},
    {0x17, 5, 0, 0, k256, 4, 1, 1},  {0x0F, 5, 23, 2, k16, 4, 2, 1},
    {0x02, 3, 17, 4, k48, 4, 1, 1},  {0x00, 2, 17, 2, k48, 4, 1, 2},
    {0x06, 3, 17, 3, k192, 4, 1, 1}, {0x1F, 5, 23, 1, k256, 4, 1, 2},
    {0x0D, 5, 23, 2, k256, 4, 1, 1}, {0x05, 7, 23, 4, k256, 2, 1, 1},
    {0x15, 6, 23, 2, k256, 2, 2, 1}, {0x25, 6, 23, 2, k256, 2, 1, 2},
    {0x09, 4, 15, 5, k32, 3, 1, 1},
}};

/// The ASTC partition seeds that a block can name: for two subsets, for mode 7's two, for three.
constexpr std::array<std::uint16_t, 30> kTwo{28,  20,  16,  29,  91,  9,   107, 72,  149, 204,
                                             50,  114, 496, 17,  78,  39,  252, 828, 43,  156,
                                             116, 210, 476, 273, 684, 359, 246, 195, 694, 524};
constexpr std::array<std::uint16_t, 19> kTwoOfSeven{
    36, 48, 61, 137, 161, 183, 226, 281, 302, 307, 479, 495, 593, 594, 605, 799, 812, 988, 993};
constexpr std::array<std::uint16_t, 11> kThree{260, 74, 32, 156, 183, 15, 745, 0, 335, 902, 254};

/// Khronos data format, "ASTC partition pattern generation", for blocks of fewer than 31 texels.
int subset_of(std::uint32_t seed, std::uint32_t x, std::uint32_t y, int subsets) {
  x <<= 1;
  y <<= 1;
  seed += static_cast<std::uint32_t>(subsets - 1) * 1024;
  std::uint32_t r = seed;
  r ^= r >> 15;
  r -= r << 17;
  r += r << 7;
  r += r << 4;
  r ^= r >> 5;
  r += r << 16;
  r ^= r >> 7;
  r ^= r >> 3;
  r ^= r << 6;
  r ^= r >> 17;
  std::array<std::uint32_t, 8> s{};
  for (std::size_t i = 0; i < 8; ++i) {
    const std::uint32_t nibble = r >> (4 * i) & 15;
    s[i] = nibble * nibble;
  }
  const std::uint32_t odd = seed & 2 ? 4 : 5, by_count = subsets == 3 ? 6 : 5;
  const std::uint32_t first = seed & 1 ? odd : by_count, second = seed & 1 ? by_count : odd;
  for (std::size_t i = 0; i < 8; ++i) s[i] >>= i % 2 == 0 ? first : second;
  const std::uint32_t a = (s[0] * x + s[1] * y + (r >> 14)) & 63,
                      b = (s[2] * x + s[3] * y + (r >> 10)) & 63,
                      c = subsets < 3 ? 0 : (s[4] * x + s[5] * y + (r >> 6)) & 63;
  if (a >= b && a >= c) return 0;
  return b >= c ? 1 : 2;
}

/// Khronos data format, "ASTC endpoint unquantisation": a number of `range` as one of 0 to 255.
std::uint8_t unquantised(std::uint32_t value, Range range) {
  if (range.base == 1) {
    std::uint32_t out = 0;
    for (int filled = 0; filled < 8; filled += range.bits) {
      const int shift = 8 - range.bits - filled;
      out |= shift >= 0 ? value << shift : value >> -shift;
    }
    return static_cast<std::uint8_t>(out);
  }
  const std::uint32_t digit = value >> range.bits, low = value & ((1u << range.bits) - 1);
  const std::uint32_t a = low & 1 ? 511 : 0, up = low >> 1;  // up: the bits above the lowest
  std::uint32_t b = 0, c = 0;
  if (range.base == 3 && range.bits == 2) b = up << 8 | up << 4 | up << 2 | up << 1, c = 93;
  if (range.base == 3 && range.bits == 4) b = up << 6 | up, c = 22;
  if (range.base == 3 && range.bits == 6) b = up << 4 | up >> 4, c = 5;
  if (range.base == 5 && range.bits == 3) b = up << 7 | up << 1 | up >> 1, c = 26;
  if (range.base == 5 && range.bits == 5) b = up << 5 | up >> 3, c = 6;
  const std::uint32_t t = (digit * c + b) ^ a;
  return static_cast<std::uint8_t>((a & 0x80) | t >> 2);
}

/// ASTC's weights of `bits` as shares of 64.
int share(std::uint32_t weight, int bits) {
  std::uint32_t out = 0;
  for (int filled = 0; filled < 6; filled += bits) {
    const int shift = 6 - bits - filled;
    out |= shift >= 0 ? weight << shift : weight >> -shift;
  }
  return static_cast<int>(out > 32 ? out + 1 : out);
}

/// Reads `count` numbers: first their digits, five trits in 8 bits or three quints in 7, fewer in
/// fewer; then their bits.
void read_endpoints(BitReader& in, Range range, int count, std::array<std::uint8_t, 18>& out) {
  constexpr std::array<int, 6> kTritBits{0, 2, 4, 5, 7, 8};
  constexpr std::array<int, 4> kQuintBits{0, 3, 5, 7};
  std::array<std::uint32_t, 18> digits{};
  const int together = range.base == 3 ? 5 : 3;
  for (int i = 0; range.base > 1 && i < count; i += together) {
    const auto some = static_cast<std::size_t>(std::min(together, count - i));
    std::uint32_t packed = in.bits(range.base == 3 ? kTritBits[some] : kQuintBits[some]);
    for (std::size_t k = 0; k < some; ++k) {
      digits[static_cast<std::size_t>(i) + k] = packed % range.base;
      packed /= range.base;
    }
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    out[i] = unquantised(digits[i] << range.bits | in.bits(range.bits), range);
}

}  // namespace

std::optional<std::array<std::uint8_t, 48>> uastc_block(std::span<const std::uint8_t, 16> block) {
  std::array<std::uint8_t, 48> out{};
  BitReader in(block);
  const std::uint32_t head = block[0];
  std::size_t number = 0;
  while (number < kModes.size() &&
         (head & ((1u << kModes[number].code_bits) - 1)) != kModes[number].code)
    ++number;
  if (number == kModes.size()) return std::nullopt;
  const Mode& mode = kModes[number];
  in.skip(static_cast<std::size_t>(mode.code_bits));
  if (number == kSolid) {
    for (std::size_t k = 0; k < 3; ++k) out[k] = static_cast<std::uint8_t>(in.bits(8));
    for (std::size_t i = 3; i < out.size(); ++i) out[i] = out[i - 3];
    return out;
  }
  // Only for conversion to other graphics formats.
  in.skip(static_cast<std::size_t>(mode.hint_bits));

  std::array<std::size_t, 16> subset{};
  if (mode.subsets > 1) {
    const std::size_t pattern = in.bits(mode.subsets == 3 ? 4 : 5);
    const std::size_t patterns = mode.subsets == 3 ? kThree.size()
                                 : number == 7     ? kTwoOfSeven.size()
                                                   : kTwo.size();
    if (pattern >= patterns) return std::nullopt;
    const std::uint32_t seed = mode.subsets == 3 ? kThree[pattern]
                               : number == 7     ? kTwoOfSeven[pattern]
                                                 : kTwo[pattern];
    for (std::uint32_t i = 0; i < 16; ++i)
      subset[i] = static_cast<std::size_t>(subset_of(seed, i % 4, i / 4, mode.subsets));
  }
  // The channel of the second weights.
  std::size_t second = 4;
  if (mode.planes == 2) second = mode.channels == 2 ? 3 : in.bits(2);

  std::array<std::uint8_t, 18> ends{};
  read_endpoints(in, mode.range, 2 * mode.channels * mode.subsets, ends);
  // A subset's first weight is below one half, so its highest bit is not written.
  std::array<bool, 3> met{};
  const auto channels = static_cast<std::size_t>(mode.channels);
  for (std::size_t i = 0; i < 16; ++i) {
    const int bits = mode.weight_bits - (met[subset[i]] ? 0 : 1);
    met[subset[i]] = true;
    std::array<int, 2> weights{};
    for (std::size_t p = 0; p < static_cast<std::size_t>(mode.planes); ++p)
      weights[p] = share(in.bits(bits), mode.weight_bits);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = 2 * (channels * subset[i] + (channels == 2 ? 0 : k));
      // Eight bits as sixteen, which the format defines for display values.
      const int low = ends[at] << 8 | 0x80, high = ends[at + 1] << 8 | 0x80;
      const int w = weights[k == second ? 1 : 0];
      out[3 * i + k] = static_cast<std::uint8_t>(((low * (64 - w) + high * w + 32) / 64) >> 8);
    }
  }
  return out;
}

Decoded decode_uastc(std::span<const std::uint8_t> blocks, int width, int height) {
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  const std::size_t across = (w + 3) / 4, down = (h + 3) / 4;
  if (blocks.size() < 16 * across * down)
    return tl::unexpected(std::string("it is damaged: it ends too early"));
  TexturePixels out;
  out.width = width;
  out.height = height;
  out.rgb.resize(3 * w * h);
  for (std::size_t y = 0; y < down; ++y)
    for (std::size_t x = 0; x < across; ++x) {
      const auto pixels = uastc_block(blocks.subspan(16 * (y * across + x)).first<16>());
      if (!pixels) return tl::unexpected(std::string("it is damaged: a block of an unknown kind"));
      for (std::size_t row = 0; row < std::min<std::size_t>(4, h - 4 * y); ++row)
        std::copy_n(pixels->begin() + static_cast<std::ptrdiff_t>(12 * row),
                    3 * std::min<std::size_t>(4, w - 4 * x),
                    out.rgb.begin() + static_cast<std::ptrdiff_t>(3 * ((4 * y + row) * w + 4 * x)));
    }
  return out;
}

}  // namespace onggi::textures
