#pragma once

#include "engine/script/plan.h"

namespace onggi {

namespace script {

class Carver;

/// Moves that leave marks other than rings, with the wheel still or slow, and moves that finish a
/// pot. Allocate; not for the tick.
using Carving = void(Carver& hand, const ToolSize& tool);
Carving press_flats, draw_grooves, wind_line, turn_off_foot, draw_wire;

/// The script of these moves.
std::unique_ptr<Script> play(const ScriptContext& context, const ToolInHand& tool, Carving& moves);

}  // namespace script

/// Figures of the carvings, for hints, tests and pictures; metres and the lump's own scale.
namespace carving {
inline constexpr int kFacets = 8;
inline constexpr double kFacetDeep = 0.002;  ///< Depth in its middle.
inline constexpr int kFlutes = 12;
inline constexpr double kFluteDeep = 0.002;
inline constexpr double kLineDeep = 0.001;
inline constexpr double kLineRise = 0.012;  ///< Rise per turn.
inline constexpr double kFootDeep = 0.003;
inline constexpr double kSlit = 0.0015;  ///< Height above the wheel head.
}  // namespace carving

}  // namespace onggi
