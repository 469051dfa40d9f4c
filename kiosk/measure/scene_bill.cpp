#include "kiosk/measure/scene_bill.h"

#include <algorithm>
#include <cstdio>
#include <functional>

#include "engine/lab/accuracy.h"
#include "engine/lab/scene_fields.h"
#include "engine/lab/scene_work.h"
#include "kiosk/tuning/machine.h"

namespace onggi::measure {
namespace {

struct Worked {
  lab::SceneOutcome outcome;
  double us = 0.0;  // median
};

Result<Worked> worked(const SceneDef& def, int passes) {
  SceneDef wall = lab::on_a_wall(def);
  wall.guard = {22.0, 1e5, 0.05};  // forces as they are
  lab::SceneWork work = lab::finger_work("bill", wall, true, 0.001, true);
  work.def.clay.rows = def.clay.rows;
  work.def.clay.sectors = def.clay.sectors;
  Worked out;
  std::vector<double> least;
  for (int pass = 0; pass < passes; ++pass) {
    auto outcome = lab::outcome_of(work, 1e-3, def.clay.rows, tuning::thread_us);
    if (!outcome) return tl::unexpected(outcome.error());
    if (pass == 0) least = outcome->tick_us;
    for (std::size_t n = 0; n < std::min(least.size(), outcome->tick_us.size()); ++n)
      least[n] = std::min(least[n], outcome->tick_us[n]);
  }
  // What changes is asked of one hand: a wall that the other holds stays where it is.
  lab::SceneWork alone = lab::finger_work("bill", wall, false, 0.0015, true);
  alone.def.clay = work.def.clay;
  auto left = lab::outcome_of(alone, 1e-3, def.clay.rows);
  if (!left) return tl::unexpected(left.error());
  out.outcome = std::move(*left);
  out.us = lab::percentile(std::move(least), 0.5);
  return out;
}

}  // namespace

Result<SceneBill> bill_of(const std::string& name, const SceneDef& def, int passes) {
  if (def.paper)
    return problem(name, "This scene runs on the printed model, which has no effect to pay for.",
                   "Name a scene with effects.");
  SceneBill bill;
  bill.scene = name;
  bill.machine = tuning::machine_name();
  bill.rows = def.clay.rows;
  bill.sectors = def.clay.sectors;
  const auto whole = worked(def, passes);
  if (!whole) return tl::unexpected(whole.error());
  const auto contact = worked(lab::bare(def), passes);
  if (!contact) return tl::unexpected(contact.error());
  bill.whole_us = whole->us;
  bill.contact_us = contact->us;
  const std::vector<std::string> effects = lab::effect_names();
  for (std::size_t n = 0; n < effects.size(); ++n) {
    if (!lab::has_effect(def, n) || effects[n] == KilnDef::kName) continue;
    SceneDef rest = def;
    lab::remove_effect(rest, n);
    const auto without = worked(rest, passes);
    if (!without) return tl::unexpected(without.error());
    const lab::Apart off = lab::apart(whole->outcome, without->outcome);
    bill.lines.push_back(
        {effects[n], whole->us - without->us, 1e3 * off.shape, 1e3 * off.shape_max, off.force});
  }
  std::ranges::sort(bill.lines, std::ranges::greater{}, &BillLine::us);
  return bill;
}

files::Json json_of(const SceneBill& bill) {
  files::Json lines = files::Json::list();
  for (const BillLine& line : bill.lines)
    lines.push_back(files::Json::object({{"effect", line.effect},
                                         {"us", line.us},
                                         {"shape_mm_rms", line.shape_mm},
                                         {"shape_mm_max", line.shape_max_mm},
                                         {"force_n_rms", line.force_n}}));
  return files::Json::object({{"scene", bill.scene},
                              {"machine", bill.machine},
                              {"command", bill.command},
                              {"rows", bill.rows},
                              {"sectors", bill.sectors},
                              {"contact_us", bill.contact_us},
                              {"whole_us", bill.whole_us},
                              {"effects", lines}});
}

std::string text_of(const SceneBill& bill) {
  char line[240];
  std::snprintf(line, sizeof line,
                "%s on %d x %d: a tick takes %.1f us, contact alone %.1f. %s.\n%-14s %9s %11s %11s "
                "%10s\n",
                bill.scene.c_str(), bill.rows, bill.sectors, bill.whole_us, bill.contact_us,
                bill.machine.c_str(), "without", "us less", "shape mm", "worst mm", "force N");
  std::string text = line;
  for (const BillLine& one : bill.lines) {
    std::snprintf(line, sizeof line, "%-14s %9.1f %11.4f %11.3f %10.4f\n", one.effect.c_str(),
                  one.us, one.shape_mm, one.shape_max_mm, one.force_n);
    text += line;
  }
  return text;
}

drawing::BillSheet sheet_of(const SceneBill& bill) {
  drawing::BillSheet sheet;
  char words[200];
  sheet.title = "What " + bill.scene + " pays for";
  std::snprintf(words, sizeof words,
                "A tick takes %.1f µs on %d × %d rows and sectors, both hands on the wall; contact "
                "alone would take %.1f.",
                bill.whole_us, bill.rows, bill.sectors, bill.contact_us);
  sheet.subtitle = words;
  sheet.foot = bill.machine + "; " + bill.command +
               "; the scene as it is against the scene without that effect; no chance in it";
  sheet.columns = {"time, µs", "shape, mm (rms)", "force, N (rms)"};
  for (const BillLine& line : bill.lines)
    sheet.rows.push_back({line.effect, {line.us, line.shape_mm, line.force_n}});
  return sheet;
}

}  // namespace onggi::measure
