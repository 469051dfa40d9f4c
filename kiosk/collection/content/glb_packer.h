#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/settings/reader_limits.h"

namespace onggi::content {

/// Packs the glTF in `file` into one GLB: files beside it and data URIs go into the BIN chunk, and
/// everything else (materials, extensions, names) stays unchanged. A picture that cannot be read
/// keeps its name. Problem: a buffer cannot be read, or `file` is not a glTF within `limits`.
/// Allocates three times the size of the file and the files that it names.
Result<std::vector<std::byte>> pack_glb(const std::filesystem::path& file,
                                        const settings::ReaderLimits& limits);

}  // namespace onggi::content
