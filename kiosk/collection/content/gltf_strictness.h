#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::content {

/// Finds faults that a glTF parser silently ignores and that would change the vessel. Problem, by
/// name: a transform with a wrong count of numbers, a sparse part without elements. Noted in
/// `warnings`, once a file each: a missing scene, morphed meshes. `name` is the file's name in the
/// Problem. Allocates.
Result<void> check_strictly(const std::string& name, const nlohmann::json& document,
                            std::vector<std::string>& warnings);

}  // namespace onggi::content
