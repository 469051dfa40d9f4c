#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/lab/measure/naive_table.h"
#include "kiosk/lab/measure/scene_bill.h"

namespace onggi::measure {

/// One preset on the curators' page.
struct SceneEntry {
  std::string name, words;           ///< Its file's, and what the file says of itself.
  std::vector<std::string> effects;  ///< What is simulated beside contact.
  SceneBill bill;
  NaiveTable visits;  ///< Naive and careful hands.
};

/// The sentences of a scene file's leading comment but for those that point elsewhere ("What each
/// ...", "An effect is ...", or that name another page). One line.
std::string words_of_scene(const std::string& toml);
/// Bills and visits of every preset of config/scenes but those on the printed model. `plan` says
/// which visits; its scene is set. Minutes. Problem as bill_of's and measure_naive's.
Result<std::vector<SceneEntry>> measure_scenes(const NaivePlan& plan, std::FILE* progress);
/// How a page came about.
struct PageMade {
  std::string command;
  std::string date;    ///< "2026-11-22"
  std::string commit;  ///< That the program was built from; empty where nobody said.
};
/// A page in Markdown. Where naive hands do not come to 60 points in the median, which is what the
/// default scene is held to, it says so in words.
std::string page_of(const std::vector<SceneEntry>& scenes, const PageMade& made);

}  // namespace onggi::measure
