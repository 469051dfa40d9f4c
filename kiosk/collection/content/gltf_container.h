#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/settings/reader_limits.h"
#include "kiosk/ground/files/read_file.h"

namespace onggi::content {

/// A run of a file's bytes.
struct ByteRange {
  std::size_t at = 0, length = 0;
  std::span<unsigned char> in(files::Bytes& bytes) const {
    return std::span(bytes).subspan(at, length);
  }
};

/// A glTF file split into its parts. Large data stays in the file's bytes: the BIN chunk of a GLB,
/// if any, and data URIs. `json` holds "data:#0", "data:#1", ... in their place, by index in
/// `data`.
struct GltfContainer {
  std::string json;
  std::optional<ByteRange> bin;
  std::vector<ByteRange> data;
};

/// glTF 2.0, section 4.4: header, a JSON chunk, an optional BIN chunk, others skipped; or JSON
/// alone. Checks the JSON, without data URIs, against the limits' size, depth and number of values
/// before any parser sees it, and copies no more than allowed.
Result<GltfContainer> split_gltf(const std::string& name, const files::Bytes& bytes,
                                 const settings::ReaderLimits& limits);

/// The data URI that `uri` stands for; none if `uri` is a file name.
std::optional<std::size_t> data_behind(const std::string& uri, const GltfContainer& container);

/// The Problem of a damaged or wrong file.
tl::unexpected<Problem> broken_gltf(const std::string& name, std::string what);

}  // namespace onggi::content
