#pragma once

#include <cstdint>
#include <filesystem>

namespace onggi::files {

/// Bytes that a user who is not root may still write on the disk of `path`; 0 where it cannot be
/// asked. Any thread.
std::uint64_t free_bytes(const std::filesystem::path& path);

}  // namespace onggi::files
