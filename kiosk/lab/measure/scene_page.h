#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/exhibit/tuning/scene_bill.h"
#include "kiosk/lab/measure/naive_table.h"

namespace onggi::measure {

/// One preset on the curators' page.
struct SceneEntry {
  std::string name, words;           ///< Its file's name, and the file's own description.
  std::vector<std::string> effects;  ///< The simulated effects besides contact.
  tuning::SceneBill bill;
  NaiveTable visits;  ///< Naive and careful hands.
};

/// Costs and visits of every preset of config/scenes, except those on the printed model. `plan`
/// defines the visits; its scene is set here. Takes minutes. Problem as in bill_of and
/// measure_naive.
Result<std::vector<SceneEntry>> measure_scenes(const NaivePlan& plan, std::FILE* progress);
/// The origin of a page.
struct PageMade {
  std::string command;
  std::string date;    ///< "2026-11-22"
  std::string commit;  ///< The commit of this build; empty if not given.
};
/// A page in Markdown. It says so if naive hands do not reach a median of 60 points, the
/// requirement for the default scene.
std::string page_of(const std::vector<SceneEntry>& scenes, const PageMade& made);

}  // namespace onggi::measure
