#pragma once

#include <cstdint>
#include <string>

#include "engine/scene/replay_bytes.h"
#include "engine/scene/scene_def.h"

namespace onggi::replay_bytes {

/// Writes a scene as tables: every part, each effect that is present, and the paper's model, by
/// name, with every number by its key. So a new effect, or a new number, needs no new version.
/// Then the tools to hand.
void write_scene(Writer& io, const SceneDef& def);

/// Reads a scene of `version`, kOldestVersion or later. What it does not name is as in a SceneDef
/// without effects: a new number's default must leave old scenes as they were. False where the
/// bytes make no sense; `unknown` is then the name or the key that this engine does not have, empty
/// where that was not it.
bool read_scene(Reader& io, std::uint32_t version, SceneDef& def, std::string& unknown);

}  // namespace onggi::replay_bytes
