#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "engine/script/script.h"

namespace onggi {

/// Scripts for what a scene's effects bring: "pull_tall" between two hands, "collapse" (too wet,
/// too thin), "dry_out", "re_wet", "centre" a lump that wobbles, "rib_smooth" the lines that a
/// finger left. On a scene without the effect they do the same moves.
std::span<const std::string_view> throwing_names();

/// Has `scene` what throwing `name` is there to show: pulling keeps volume, a fall is a slump, and
/// so on? False for a name that is none.
bool throwing_shows(std::string_view name, const SceneDef& scene);

/// The tool besides fingers that throwing `name` is done with. Empty where it takes none.
std::string_view throwing_tool(std::string_view name);

/// The script `name` on the lump of `context`'s scene. Null where the scene has not the tool to
/// hand, or there is no such throwing. Allocates.
std::unique_ptr<Script> make_throwing(std::string_view name, const ScriptContext& context);

}  // namespace onggi
