#pragma once

#include <cstdint>
#include <memory>

#include "engine/contact/tool.h"
#include "engine/script/script.h"

namespace onggi::script {

/// A script's tool in the scene.
struct ToolInHand {
  std::uint8_t index = 0;  ///< HandInput::tool.
  ToolSize size;           ///< All sizes filled in.
};

/// Plans a script. make_script() has checked its needs. Allocates; not for the tick.
using Plan = std::unique_ptr<Script>(const ScriptContext& context, const ToolInHand& tool);

}  // namespace onggi::script
