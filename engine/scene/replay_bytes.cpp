#include "engine/scene/replay_bytes.h"

#include "engine/math/crc64.h"

namespace onggi::replay_bytes {

void seal(std::vector<std::byte>& bytes) {
  std::uint64_t sum = checksum::crc64(bytes);
  Writer{bytes}(sum);
}

std::span<const std::byte> unsealed(std::span<const std::byte> bytes) {
  if (bytes.size() < kSealBytes) return {};
  const auto body = bytes.first(bytes.size() - kSealBytes);
  std::uint64_t sum = 0;
  Reader io(bytes.last(kSealBytes));
  return io(sum) && sum == checksum::crc64(body) ? body : std::span<const std::byte>{};
}

}  // namespace onggi::replay_bytes
