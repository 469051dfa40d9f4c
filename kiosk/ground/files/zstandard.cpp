#include "kiosk/ground/files/zstandard.h"

#include <zstd.h>

#include <memory>

namespace onggi::files {

namespace {
constexpr int kLevel = 12;  // two minutes of a visit (3.6 MB) take a tenth of a second
constexpr unsigned char kMagic[] = {0x28, 0xB5, 0x2F, 0xFD};  // RFC 8878, 3.1.1
}  // namespace

std::vector<std::byte> packed(std::span<const std::byte> bytes) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> way(ZSTD_createCCtx(), ZSTD_freeCCtx);
  ZSTD_CCtx_setParameter(way.get(), ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(way.get(), ZSTD_c_checksumFlag, 1);
  std::vector<std::byte> frame(ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compress2(way.get(), frame.data(), frame.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size)) return {};
  frame.resize(size);
  return frame;
}

bool is_packed(std::span<const std::byte> bytes) {
  for (std::size_t n = 0; n < sizeof kMagic; ++n)
    if (n >= bytes.size() || bytes[n] != std::byte{kMagic[n]}) return false;
  return true;
}

std::optional<std::vector<std::byte>> unpacked(std::span<const std::byte> frame, std::size_t most) {
  const unsigned long long size = ZSTD_getFrameContentSize(frame.data(), frame.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN || size > most) return {};
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  if (ZSTD_decompress(bytes.data(), bytes.size(), frame.data(), frame.size()) != bytes.size())
    return {};
  return bytes;
}

}  // namespace onggi::files
