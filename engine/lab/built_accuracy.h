#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/lab/accuracy.h"
#include "engine/lab/scene_work.h"

namespace onggi::lab {

/// A piece of a builder's work, the same at any tick and on any grid, which a second program can
/// repeat: PlainRing or PlainBeaten.
struct BuiltScript {
  std::string name;              ///< "coil", "blows"
  std::string words;             ///< The action, for a person.
  SceneWork work;                ///< Its hands, and its scene; the caller sets the grid.
  double low = 0.0, high = 0.0;  ///< Heights between which the faces are compared, m.
};
/// coil: a hand lays a ring on a standing wall (coil_work). blows: eight blows squeeze a turning
/// wall; four of them also move it inwards, and three outwards (blow_work).
std::vector<BuiltScript> built_scripts();
/// True if `name` is that of a built script.
bool is_built(const std::string& name);

/// True for the engine, on a grid that the script's scene may have: coils double the rows.
bool can_work(const BuiltScript& script, const AccuracySetting& setting);

/// What the work leaves, by the second program: outside and inside, at even heights.
struct BuiltTruth {
  std::array<FaceGrid, 2> face;
  double volume = 0.0;  ///< Of the ring, or moved by the blows, m^3.
};
/// On `rows` x `sectors`; a ring needs no rows. Seconds at the most. Allocates.
BuiltTruth truth_of(const BuiltScript& script, int rows, int sectors);

/// Works `script` by the engine, as measure_accuracy() does. Timed are the ticks in which a coil
/// rests on the rim, in which a closed ring becomes rows, or in which a blow lands. Force is not
/// compared, and NaN. `setting`: one that can_work(). Allocates; not for the 1 kHz thread.
AccuracyRow measure_built(const BuiltScript& script, const BuiltTruth& truth,
                          const AccuracySetting& setting, WorkClock clock, int passes = 1);

}  // namespace onggi::lab
