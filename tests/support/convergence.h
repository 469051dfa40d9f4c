#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/scene/scene.h"

namespace onggi::refinement {

/// A smooth piece of work, the same whatever the tick and the grid.
struct Stroke {
  double seconds = 0.0;                ///< A multiple of kWindow.
  std::function<Hands(double)> hands;  ///< At a time, s.
};

/// A stroke in a scene: what is refined.
struct Work {
  std::string name;  ///< "wobble"
  SceneDef def;
  Stroke stroke;
};

/// The windows that forces are averaged over: a multiple of every tick that is tried.
inline constexpr double kWindow = 0.02;

/// What came of it.
struct Outcome {
  std::vector<double> outline;  ///< Mean outer and inner radius at even heights, m.
  std::vector<Vec3> force;      ///< Mean of each window, of both hands, N.
  Vec3 impulse;                 ///< N s, of the first hand.
};
/// Works it with ticks of `tick` seconds on `rows` rows, with as many sectors as make elements of
/// the first one's shape.
Outcome outcome_of(const Work& work, double tick, int rows);

/// How far apart two outcomes are.
struct Apart {
  double shape = 0.0;    ///< Root mean square of the outlines' difference, m.
  double force = 0.0;    ///< Likewise of the windows' force, N.
  double impulse = 0.0;  ///< Length of the difference, as a share of the second.
};
Apart apart(const Outcome& a, const Outcome& b);

/// What refining came to: steps halved three times, so that the order at which outcomes draw
/// together, p = ln((f3 - f2) / (f2 - f1)) / ln 2, is a mean of two.
struct Refined {
  Apart order;               ///< p of each
  Apart finest;              ///< how far the last two are apart: below kFloor, p means nothing
  double impulse_off = 0.0;  ///< Of ticks: the most that an impulse at 0.5, 1, 2, 2.5 and 5 ms is
                             ///< off that of the finest tick. Of grids: of the coarsest. A share.
};
/// A ten-thousandth of a stroke, 1.5 mm deep with 0.1 N: what differs by less is the same to a hand
/// and to an eye, and floats and turns make an order of it that means little.
inline constexpr Apart kFloor{2e-7, 1e-5, 1e-4};

/// Ticks of 1, 0.5, 0.25 and 0.125 ms, and those of impulse_off, on the work's own grid.
Refined refine_ticks(const Work& work);
/// 100, 200, 400 and 800 rows, with ticks of 1 ms.
Refined refine_grids(const Work& work);

/// The bare engine and each effect alone, on 200 x 180: a finger outside (with `walls` one on
/// either side as well, named "walls, two hands"), a sponge for `smoothing`, water for `moisture`,
/// and clay that sags for `slump`.
std::vector<Work> effect_works();
/// A finger outside, and both hands, in the scene `def` of that name, on 200 x 180.
std::vector<Work> scene_works(const std::string& name, SceneDef def);

}  // namespace onggi::refinement
