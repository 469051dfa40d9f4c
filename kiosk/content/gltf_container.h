#pragma once

#include <optional>
#include <string>

#include "engine/base/result.h"
#include "kiosk/files/read_file.h"
#include "kiosk/settings/reader_limits.h"

namespace onggi::content {

/// A glTF file taken apart: its JSON, and the BIN chunk where it is a GLB that has one.
struct GltfContainer {
  std::string json;
  std::optional<files::Bytes> bin;
};

/// glTF 2.0, section 4.4: header, a JSON chunk, an optional BIN chunk, others skipped; or JSON
/// alone. The JSON is within the limits' size, depth and number of values: no parser has met it
/// yet.
Result<GltfContainer> split_gltf(const std::string& name, const files::Bytes& bytes,
                                 const settings::ReaderLimits& limits);

/// The Problem of a file that is not what it should be.
tl::unexpected<Problem> broken_gltf(const std::string& name, std::string what);

}  // namespace onggi::content
