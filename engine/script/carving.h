#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "engine/script/script.h"

namespace onggi {

/// Scripts that leave marks which are not round, with the wheel still or slow, and those that
/// finish a pot: "facet", "flute", "incise", "trim_foot", "cut_off".
std::span<const std::string_view> carving_names();

/// The tool that carving `name` is done with: "flat_rib". Empty where there is no such carving.
std::string_view carving_tool(std::string_view name);

/// The script `name` on the lump of `context`'s scene. Null where the scene has not that tool to
/// hand, or there is no such carving. Allocates.
std::unique_ptr<Script> make_carving(std::string_view name, const ScriptContext& context);

/// What the carvings leave, for hints, tests and pictures; metres and a lump's own figures.
namespace carving {
inline constexpr int kFacets = 8;
inline constexpr double kFacetDeep = 0.002;  ///< In its middle.
inline constexpr int kFlutes = 12;
inline constexpr double kFluteDeep = 0.002;
inline constexpr double kLineDeep = 0.001;
inline constexpr double kLineRise = 0.012;  ///< A turn.
inline constexpr double kFootDeep = 0.003;
inline constexpr double kSlit = 0.0015;  ///< Above the wheel head.
}  // namespace carving

}  // namespace onggi
