#pragma once

#include <string>
#include <vector>

#include "engine/lab/scene_work.h"

namespace onggi::refinement {

using lab::Apart;
using Work = lab::SceneWork;
using Outcome = lab::SceneOutcome;
using lab::apart;
using lab::scene_works;

/// lab::outcome_of a scene that is one.
Outcome worked(const Work& work, double tick, int rows);

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

}  // namespace onggi::refinement
