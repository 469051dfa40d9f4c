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

/// A glTF file taken apart. What is large stays where it is, in the file's bytes: the BIN chunk
/// where it is a GLB that has one, and data URIs, in whose place `json` has the string
/// "data:#0", "data:#1", ... by their place in `data`.
struct GltfContainer {
  std::string json;
  std::optional<ByteRange> bin;
  std::vector<ByteRange> data;
};

/// glTF 2.0, section 4.4: header, a JSON chunk, an optional BIN chunk, others skipped; or JSON
/// alone. The JSON, data URIs not counted, is within the limits' size, depth and number of values:
/// no parser has met it yet, and no more of it than allowed was copied.
Result<GltfContainer> split_gltf(const std::string& name, const files::Bytes& bytes,
                                 const settings::ReaderLimits& limits);

/// Which data URI of the container stands behind `uri`; none where it is a file's name.
std::optional<std::size_t> data_behind(const std::string& uri, const GltfContainer& container);

/// The Problem of a file that is not what it should be.
tl::unexpected<Problem> broken_gltf(const std::string& name, std::string what);

}  // namespace onggi::content
