#pragma once

#include <cstdint>
#include <memory>

#include "engine/contact/tool.h"
#include "engine/script/script.h"

namespace onggi::script {

/// The tool that a script is done with, as the scene has it to hand.
struct ToolInHand {
  std::uint8_t index = 0;  ///< HandInput::tool.
  ToolSize size;           ///< Nothing left at 0.
};

/// Writes a script down. What it needs is there: make_script() has looked. Allocates; not for the
/// tick.
using Plan = std::unique_ptr<Script>(const ScriptContext& context, const ToolInHand& tool);

}  // namespace onggi::script
