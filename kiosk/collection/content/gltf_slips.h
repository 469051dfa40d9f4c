#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::content {

/// What a glTF parser reads past without a word, and what would then be another vessel. A Problem,
/// by name: a transform with too few or too many numbers, a sparse part of less than one element.
/// Noted in `warnings`, once a file each: a scene that is not there, meshes that are morphed.
/// `name` is the file's, for the Problem. Allocates.
Result<void> check_slips(const std::string& name, const nlohmann::json& document,
                         std::vector<std::string>& warnings);

}  // namespace onggi::content
