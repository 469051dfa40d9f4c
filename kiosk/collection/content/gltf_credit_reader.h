#pragma once

#include <nlohmann/json_fwd.hpp>

#include "kiosk/collection/content/gltf_credit.h"

namespace onggi::content {

/// Reads whom to thank from a glTF's JSON, whatever else is in it. Texts are cut at 1000 bytes, and
/// control characters become spaces.
GltfCredit read_credit(const nlohmann::json& document);

}  // namespace onggi::content
