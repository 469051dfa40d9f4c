#include "kiosk/lab/measure/scene_bill.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <utility>

#include "engine/lab/accuracy.h"
#include "engine/lab/scene_fields.h"
#include "engine/lab/scene_work.h"
#include "kiosk/exhibit/tuning/machine.h"

namespace onggi::measure {
namespace {

struct Worked {
  std::vector<lab::SceneOutcome> outcomes;
  double us = 0.0;  // median
};

// Some effects are requested by a number that is 0 by default. Removes the request; false if there
// is none.
struct BillPart {
  const char* effect;
  const char* key;
  bool (*leave_out)(SceneDef&);
};

template <class Def>
bool zeroed(std::optional<Def>& effect, double Def::*field) {
  return effect && std::exchange((*effect).*field, 0.0) > 0.0;
}

constexpr BillPart kBillParts[] = {
    {MoistureDef::kName, "sponge_height",
     [](SceneDef& def) { return zeroed(def.moisture, &MoistureDef::sponge_height); }},
    {WallsDef::kName, "tear_thickness",
     [](SceneDef& def) { return zeroed(def.walls, &WallsDef::tear_thickness); }},
    {WallsDef::kName, "tear_strain",
     [](SceneDef& def) { return zeroed(def.walls, &WallsDef::tear_strain); }},
    {WallsDef::kName, "bending_strength",
     [](SceneDef& def) { return zeroed(def.walls, &WallsDef::bending_strength); }},
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
    if (pass == 0) {
      least = outcome->tick_us;
      out.outcomes.push_back(*outcome);
    }
    for (std::size_t n = 0; n < std::min(least.size(), outcome->tick_us.size()); ++n)
      least[n] = std::min(least[n], outcome->tick_us[n]);
  }
  // A wall that the other hand holds does not move, and one without another hand does not thin, so
  // an effect shows in one or the other.
  std::vector<lab::SceneWork> others{lab::finger_work("bill", wall, false, 0.0015, true)};
  if (auto evening = lab::evening_work("bill", wall, 0.0015, true))
    others.push_back(std::move(*evening));
  for (lab::SceneWork& other : others) {
    other.def.clay = work.def.clay;
    auto left = lab::outcome_of(other, 1e-3, def.clay.rows);
    if (!left) return tl::unexpected(left.error());
    out.outcomes.push_back(std::move(*left));
  }
  out.us = lab::percentile(std::move(least), 0.5);
  return out;
}

Result<BillLine> line_of(const char* name, const char* part_of, const Worked& whole,
                         const SceneDef& rest, int passes) {
  const auto without = worked(rest, passes);
  if (!without) return tl::unexpected(without.error());
  BillLine line{name, part_of, whole.us - without->us};
  for (std::size_t n = 0; n < whole.outcomes.size(); ++n) {
    const lab::Apart off = lab::apart(whole.outcomes[n], without->outcomes[n]);
    line.shape_mm = std::max(line.shape_mm, 1e3 * off.shape);
    line.shape_max_mm = std::max(line.shape_max_mm, 1e3 * off.shape_max);
    line.force_n = std::max(line.force_n, off.force);
  }
  return line;
}

}  // namespace

Result<SceneBill> bill_of(const std::string& name, const SceneDef& def, int passes) {
  if (def.paper)
    return problem(name, "This scene runs on the printed model, which has no effects.",
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
    auto line = line_of(effects[n].c_str(), "", *whole, rest, passes);
    if (!line) return tl::unexpected(line.error());
    bill.lines.push_back(std::move(*line));
  }
  std::ranges::sort(bill.lines, std::ranges::greater{}, &BillLine::us);
  for (const BillPart& part : kBillParts) {
    SceneDef rest = def;
    if (!part.leave_out(rest)) continue;
    auto line = line_of(part.key, part.effect, *whole, rest, passes);
    if (!line) return tl::unexpected(line.error());
    const auto effect = std::ranges::find(bill.lines, part.effect, &BillLine::effect);
    bill.lines.insert(effect + 1, std::move(*line));
  }
  return bill;
}

std::string doubt_of(const SceneBill& bill) {
  constexpr double kMostNoise = 0.1;  // of the whole: no more on a quiet machine
  for (const BillLine& line : bill.lines) {
    if (line.us >= -kMostNoise * bill.whole_us) continue;
    char words[200];
    std::snprintf(
        words, sizeof words,
        "Do not believe these times: without %s a tick took %.1f us longer. Something else "
        "kept this machine busy. Measure again when nothing else runs.\n",
        line.effect.c_str(), -line.us);
    return words;
  }
  return {};
}

files::Json json_of(const SceneBill& bill) {
  files::Json lines = files::Json::list();
  for (const BillLine& line : bill.lines)
    lines.push_back(files::Json::object({{"effect", line.effect},
                                         {"part_of", line.part_of},
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
                              {"times_hold", doubt_of(bill).empty()},
                              {"effects", lines}});
}

namespace {
std::string bill_name(const BillLine& line) {
  return line.part_of.empty() ? line.effect : "  of it " + line.effect;
}
}  // namespace

std::string text_of(const SceneBill& bill) {
  char line[240];
  std::snprintf(line, sizeof line,
                "%s on %d x %d: a tick takes %.1f us, contact alone %.1f. %s.\n%-14s %9s %11s %11s "
                "%10s\n",
                bill.scene.c_str(), bill.rows, bill.sectors, bill.whole_us, bill.contact_us,
                bill.machine.c_str(), "without", "us less", "shape mm", "worst mm", "force N");
  std::string text = line;
  for (const BillLine& one : bill.lines) {
    std::snprintf(line, sizeof line, "%-22s %9.1f %11.4f %11.3f %10.4f\n", bill_name(one).c_str(),
                  one.us, one.shape_mm, one.shape_max_mm, one.force_n);
    text += line;
  }
  return text + doubt_of(bill);
}

plots::BillSheet sheet_of(const SceneBill& bill) {
  plots::BillSheet sheet;
  char words[200];
  sheet.title = "What " + bill.scene + " pays for";
  std::snprintf(words, sizeof words,
                "A tick takes %.1f µs on %d × %d rows and sectors, both hands on the wall; contact "
                "alone would take %.1f.",
                bill.whole_us, bill.rows, bill.sectors, bill.contact_us);
  sheet.subtitle = words;
  sheet.foot = bill.machine + "; " + bill.command +
               "; the scene as it is against the scene without that effect; no chance in it";
  if (const std::string doubt = doubt_of(bill); !doubt.empty()) sheet.subtitle += " " + doubt;
  sheet.columns = {"time, µs", "shape, mm (rms)", "force, N (rms)"};
  for (const BillLine& line : bill.lines)
    sheet.rows.push_back({(line.part_of.empty() ? "" : "   ") + line.effect,
                          {line.us, line.shape_mm, line.force_n}});
  return sheet;
}

}  // namespace onggi::measure
