#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace onggi::files {

/// `bytes` as one Zstandard frame with its size and a checksum. The same bytes give the same frame.
/// Allocates.
std::vector<std::byte> packed(std::span<const std::byte> bytes);

/// True if `bytes` begin like a frame of packed().
bool is_packed(std::span<const std::byte> bytes);

/// What packed() was given. Nothing if the frame is damaged, or if it holds more than `most` bytes.
std::optional<std::vector<std::byte>> unpacked(std::span<const std::byte> frame, std::size_t most);

}  // namespace onggi::files
