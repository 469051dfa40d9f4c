#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/lab/built_accuracy.h"
#include "kiosk/lab/measure/accuracy_plan.h"

namespace onggi::measure {

/// A builder's work, its truth on the plan's finest grid, and how far one half as fine lies from
/// it, m.
struct KnownBuilt {
  lab::BuiltScript script;
  lab::BuiltTruth truth;
  double apart = 0.0;
};
/// All of lab::built_scripts(). Seconds; allocates.
std::vector<KnownBuilt> built_truths(const AccuracyPlan& plan);

/// Those of the plan's settings that can work `script`: the engine's, without the finest grid for
/// coils.
std::vector<lab::AccuracySetting> built_settings(const AccuracyPlan& plan,
                                                 const lab::BuiltScript& script);
/// As work_of(): seconds of some machine.
double work_of(const lab::BuiltScript& script, const lab::AccuracySetting& setting, int passes);

/// The rows that a recommendation goes by. A blow is one long tick among hundreds, and a ring of
/// coil asks nothing of contact: neither decides about a grid.
std::vector<lab::AccuracyRow> without_built(std::vector<lab::AccuracyRow> rows);

/// What `rows` say of coils and blows, for people: by grid at 1 kHz, and by tick on the usual grid.
/// Empty if they have none.
std::string words_of_built(const std::vector<lab::AccuracyRow>& rows);

}  // namespace onggi::measure
