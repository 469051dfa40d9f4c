#pragma once

#include <nlohmann/json_fwd.hpp>

#include "kiosk/collection/content/gltf_credit.h"

namespace onggi::content {

/// Reads the credit from a glTF's JSON and ignores everything else. Texts are cut at 1000 bytes,
/// and control characters become spaces.
GltfCredit read_credit(const nlohmann::json& document);

}  // namespace onggi::content
