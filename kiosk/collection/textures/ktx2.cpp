#include "kiosk/collection/textures/ktx2.h"

#include <zstd.h>

#include <algorithm>
#include <optional>
#include <string>

#include "kiosk/collection/textures/basis_lz.h"
#include "kiosk/collection/textures/codecs.h"
#include "kiosk/collection/textures/uastc.h"

namespace onggi::textures {
namespace {

// KTX 2.0, sections 2 and 3.
constexpr std::size_t kHeaderBytes = 80, kLevelBytes = 24, kMostLevels = 32;
constexpr std::uint32_t kNoScheme = 0, kBasisLz = 1, kZstandard = 2;
constexpr std::uint8_t kEtc1s = 163, kUastc = 166;  // Khronos data format: colour models

using Bytes = std::span<const std::uint8_t>;

std::uint64_t number(Bytes bytes, std::size_t at, std::size_t size) {
  std::uint64_t out = 0;
  for (std::size_t i = 0; i < size && at + i < bytes.size(); ++i)
    out |= static_cast<std::uint64_t>(bytes[at + i]) << (8 * i);
  return out;
}

std::optional<Bytes> run(Bytes bytes, std::uint64_t at, std::uint64_t size) {
  if (at > bytes.size() || size > bytes.size() - at) return std::nullopt;
  return bytes.subspan(static_cast<std::size_t>(at), static_cast<std::size_t>(size));
}

tl::unexpected<std::string> no(const std::string& why) { return tl::unexpected(why); }

Decoded unpacked_uastc(Bytes level, std::uint32_t scheme, int width, int height) {
  if (scheme == kNoScheme) return decode_uastc(level, width, height);
  const std::size_t size = std::size_t{16} * static_cast<std::size_t>((width + 3) / 4) *
                           static_cast<std::size_t>((height + 3) / 4);
  std::vector<std::uint8_t> blocks(size);
  if (ZSTD_decompress(blocks.data(), size, level.data(), level.size()) != size)
    return no("it is damaged: its Zstandard data");
  return decode_uastc(blocks, width, height);
}

}  // namespace

Decoded decode_ktx2(Bytes bytes, unsigned most_side, unsigned wanted_side) {
  if (bytes.size() < kHeaderBytes) return no("it is damaged: it ends too early");
  const auto word = [&bytes](std::size_t at) {
    return static_cast<std::uint32_t>(number(bytes, at, 4));
  };
  const std::uint32_t width = word(20), height = word(24), scheme = word(44);
  const std::size_t levels = std::max(1u, word(40));
  if (word(28) != 0 || word(32) > 1 || word(36) != 1)
    return no("it is a KTX2 with several pictures, or a 3D texture");
  if (levels > kMostLevels || bytes.size() < kHeaderBytes + levels * kLevelBytes)
    return no("it is damaged: its list of levels");
  std::size_t level = 0;
  while (level + 1 < levels && std::max(width >> (level + 1), height >> (level + 1)) >= wanted_side)
    ++level;
  const std::uint32_t across = std::max(width > 0 ? 1u : 0u, width >> level),
                      down = std::max(height > 0 ? 1u : 0u, height >> level);
  if (auto fault = fault_of_size(across, down, most_side)) return no(*fault);

  const auto format = run(bytes, word(48), word(52));
  if (!format || format->size() < 28) return no("it is damaged: its description");
  const std::uint8_t model = (*format)[12];
  const bool etc1s = model == kEtc1s && scheme == kBasisLz;
  const bool uastc = model == kUastc && (scheme == kNoScheme || scheme == kZstandard);
  if (word(12) != 0 || (!etc1s && !uastc))
    return no("it is a KTX2 that uses neither BasisLZ nor UASTC, as glTF requires");
  const std::size_t entry = kHeaderBytes + level * kLevelBytes;
  const auto data = run(bytes, number(bytes, entry, 8), number(bytes, entry + 8, 8));
  if (!data) return no("it is damaged: a level extends past its end");
  const int w = static_cast<int>(across), h = static_cast<int>(down);
  if (uastc) return unpacked_uastc(*data, scheme, w, h);
  const auto global = run(bytes, number(bytes, 64, 8), number(bytes, 72, 8));
  if (!global) return no("it is damaged: its codebooks extend past its end");
  return decode_basis_lz(*global, levels, level, *data, w, h);
}

}  // namespace onggi::textures
