#pragma once

#include <cstdint>
#include <string>

#include "engine/scene/replay_bytes.h"
#include "engine/scene/scene_def.h"

namespace onggi::replay_bytes {

/// Writes a scene as tables: every part, each present effect, and the paper model, by name, with
/// every number by key. So a new effect or number needs no new version. The tools follow.
void write_scene(Writer& io, const SceneDef& def);

/// Reads a scene of `version`, kOldestVersion or later. Missing numbers get the defaults of a
/// SceneDef without effects, so a new number's default must leave old scenes unchanged. False if
/// the bytes are invalid; `unknown` is then the unknown name or key, or empty.
bool read_scene(Reader& io, std::uint32_t version, SceneDef& def, std::string& unknown);

}  // namespace onggi::replay_bytes
