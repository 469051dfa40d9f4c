#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene.h"

namespace onggi::lab {

/// 0..1 over 0..1 with three continuous derivatives, flat beyond. A corner in a hand's path would
/// spoil the order of convergence.
double eased(double share);

/// A smooth piece of work in a scene, the same whatever the tick and the grid.
struct SceneWork {
  std::string name;  ///< "studio, two hands"
  SceneDef def;
  double seconds = 1.0;                ///< A multiple of kWorkWindow.
  std::function<Hands(double)> hands;  ///< At a time, s.
  /// The outline counts from a tenth to nine tenths of the way between these heights, m; 0: the
  /// lump's.
  double outline_from = 0.0, outline_to = 0.0;
};
/// The windows that forces are averaged over, s: a multiple of every tick that is tried.
inline constexpr double kWorkWindow = 0.02;

/// A finger outside that goes in from clear by `deep` (m), up the wall, and out again in a second
/// at 115 rpm; `both`: with another inside. `water`: the clay is wetted for the first half.
SceneWork finger_work(std::string name, const SceneDef& def, bool both, double deep,
                      bool water = false);
/// The same with one hand and the scene's first round tool that smooths (palm or sponge). Empty if
/// the scene has none.
std::optional<SceneWork> evening_work(std::string name, const SceneDef& def, double deep,
                                      bool water = false);
/// A hand goes round on a standing wheel and lays a ring of coil whose middle wanders by 2 mm.
/// `def`: with BuildingDef, its lump as wide as in on_a_wall().
SceneWork coil_work(std::string name, SceneDef def);
/// Eight blows on an anvil, of swings from a half to one, up the wall on a turning wheel. `def`:
/// with BeatingDef.
SceneWork blow_work(std::string name, const SceneDef& def);
/// The lump with a wall of 1 cm on 200 x 180 that both hands can press, without undo, the wheel at
/// full speed at once.
SceneDef on_a_wall(SceneDef def);
/// A finger outside, 1.5 mm deep, and both hands, 1 mm, in the scene `def` of that name, on
/// 200 x 180. The printed model has no wall: one finger on its own lump.
std::vector<SceneWork> scene_works(const std::string& name, SceneDef def);

/// The result of a work.
struct SceneOutcome {
  std::vector<double> outline;  ///< Mean outer and inner radius at even heights, m.
  std::vector<Vec3> force;      ///< Mean of each window, hand by hand, N.
  Vec3 impulse;                 ///< Of the first hand, N s.
  std::vector<double> tick_us;  ///< By the clock, of ticks in which a hand pressed.
};
/// Works with ticks of `tick` seconds on `rows` rows, with as many sectors (at least 16) as keep
/// the elements' shape. `clock`: microseconds that the thread has worked; null: no times.
/// Allocates. Problem if the scene is invalid.
Result<SceneOutcome> outcome_of(const SceneWork& work, double tick, int rows,
                                double (*clock)() = nullptr);

/// Difference of two outcomes.
struct Apart {
  double shape = 0.0;      ///< Root mean square of the outlines' difference, m.
  double force = 0.0;      ///< Likewise of the windows' force, N.
  double impulse = 0.0;    ///< Length of the difference, as a share of the second.
  double shape_max = 0.0;  ///< The most of the outlines' difference, m.
};
Apart apart(const SceneOutcome& a, const SceneOutcome& b);
/// Difference of the outlines' volumes, as a share of the volume displaced in `truth`; 0 if nothing
/// was.
double volume_apart(const SceneOutcome& a, const SceneOutcome& truth, const ClayDef& fresh);

}  // namespace onggi::lab
