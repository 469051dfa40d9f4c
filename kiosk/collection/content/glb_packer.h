#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/settings/reader_limits.h"

namespace onggi::content {

/// The glTF of JSON in `file` as one GLB: what it names beside it and in data URIs comes into its
/// BIN chunk, all else (materials, extensions, names) is as it was. A picture that cannot be read
/// keeps its name. Problem: a buffer that cannot be read, or `file` is no glTF within `limits`.
/// Allocates three times the file and what it names.
Result<std::vector<std::byte>> pack_glb(const std::filesystem::path& file,
                                        const settings::ReaderLimits& limits);

}  // namespace onggi::content
