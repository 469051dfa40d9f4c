#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "engine/clay/clay.h"
#include "engine/contact/tool.h"
#include "engine/effects/effect_list.h"

namespace onggi {

/// All defaults of a scene. SI units.

struct ToolDef {
  double radius = 0.008;  ///< Sphere, metres, 0.001..0.05. A fingertip is about 0.008.

  static constexpr const char* kName = "tool";
  static std::span<const DefField<ToolDef>> fields();
};

/// A tool of the scene, in addition to the ball (engine/docs/tools.md).
struct SceneTool {
  std::string name;  ///< Name of a ToolShape: "flat_rib".
  ToolSize size;     ///< Metres; 0: the tool's usual size. Each tool has its own ranges.
};
/// Every shape but the ball, by name. Allocates.
std::vector<SceneTool> usual_tools();

struct ContactDef {
  double relaxation_time = 0.00949;  ///< tau, s, 0.001..1: how fast pressed clay yields (paper
                                     ///< c_eta = 10 at 1 kHz). Higher feels stiffer.
  /// k_A, N per metre of press and m^2 of touched wall, 1e5..5e7. Higher feels drier.
  double stiffness = 5e6;

  static constexpr const char* kName = "contact";
  static std::span<const DefField<ContactDef>> fields();
};

struct WheelDef {
  double max_speed = 31.4;     ///< rad/s (300 rpm), 0..62.9. Requested speeds are clamped to it.
  double acceleration = 20.0;  ///< rad/s^2, 0.1..1000.

  static constexpr const char* kName = "wheel";
  static std::span<const DefField<WheelDef>> fields();
};

/// The last limit on every force. Always on.
struct GuardDef {
  double max_force = 3.3;    ///< N, 0..22.2. The Omni's peak is 3.3.
  double max_slew = 600.0;   ///< N/s, 10..1e5.
  double engage_time = 0.5;  ///< s, 0.05..5: ramp from zero after a hand arrives or after a fault.

  static constexpr const char* kName = "guard";
  static std::span<const DefField<GuardDef>> fields();
};

/// The printed model of Lee, Han & Choi 2008 with its own coefficients, which hold per tick and per
/// element (engine/docs/paper.md). It has its own friction and no effects. It uses tool.radius,
/// wheel and guard, but not contact.
struct PaperDef {
  double c_eta = 10.0;  ///< Eq. 6: ticks in which clay yields, 0.5..1000. Below 1 it overshoots.
  double c_v = 0.864;   ///< Eq. 9: N per metre of one element's press, 0..1000. The default is 5e6
                        ///< N/m^3 on an element of 0.18 mm by 1 degree at 55 mm.
  double c_r = 200.0;   ///< Eq. 10: N per metre of the deepest press, 0..1e5.

  static constexpr const char* kName = "paper";
  static std::span<const DefField<PaperDef>> fields();
};

/// Everything in a scene: the parts that every scene has, and effects.
struct SceneDef : Effects {
  ClayDef clay;
  ToolDef tool;                                  ///< HandInput::tool 0.
  std::vector<SceneTool> tools = usual_tools();  ///< HandInput::tool 1 and up; at most 63.
  ContactDef contact;
  WheelDef wheel;
  GuardDef guard;
  std::optional<PaperDef> paper;  ///< If set, no effect may be set.
};

/// The parts that every scene has, without the tools.
inline constexpr std::tuple kSceneParts{&SceneDef::clay, &SceneDef::tool, &SceneDef::contact,
                                        &SceneDef::wheel, &SceneDef::guard};
/// Calls `visit` with each of them. SceneDef may be const.
template <class AnySceneDef, class Visit>
void each_part(AnySceneDef& def, Visit&& visit) {
  std::apply([&](auto... part) { (visit(def.*part), ...); }, kSceneParts);
}

/// The first error in `def`: field ("clay.rows") or effect ("slump"), meaning and remedy. Allocates
/// only the text.
Result<void> validate(const SceneDef& def);

}  // namespace onggi
