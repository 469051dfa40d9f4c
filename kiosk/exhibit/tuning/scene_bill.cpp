#include "kiosk/exhibit/tuning/scene_bill.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

#include "engine/lab/accuracy.h"
#include "engine/lab/scene_fields.h"
#include "engine/lab/scene_work.h"
#include "engine/scene/scene.h"
#include "kiosk/exhibit/tuning/machine.h"

namespace onggi::tuning {
namespace {

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

/// The scene, or the scene with something more or less.
struct Variant {
  const char *effect = "", *part_of = "";
  SceneDef def;
  std::vector<lab::SceneOutcome> outcomes{};
  std::vector<double> least{};  // us, of each tick with both hands
  double median() const { return lab::percentile(least, 0.5); }
};

SceneDef wall_of(const SceneDef& def) {
  SceneDef wall = lab::on_a_wall(def);
  wall.guard = {22.0, 1e5, 0.05};  // forces as they are
  return wall;
}

lab::SceneWork on_own_grid(lab::SceneWork work, const SceneDef& def) {
  work.def.clay.rows = def.clay.rows;
  work.def.clay.sectors = def.clay.sectors;
  return work;
}

/// Works with both hands once, and keeps each tick's shortest time.
Result<void> time_once(Variant& variant) {
  const lab::SceneWork both =
      on_own_grid(lab::finger_work("bill", wall_of(variant.def), true, 0.001, true), variant.def);
  auto outcome = lab::outcome_of(both, 1e-3, variant.def.clay.rows, thread_us);
  if (!outcome) return tl::unexpected(outcome.error());
  if (variant.least.empty()) {
    variant.least = outcome->tick_us;
    variant.outcomes.push_back(std::move(*outcome));
    return {};
  }
  for (std::size_t n = 0; n < std::min(variant.least.size(), outcome->tick_us.size()); ++n)
    variant.least[n] = std::min(variant.least[n], outcome->tick_us[n]);
  return {};
}

// A wall that the other hand holds does not move, and one without another hand does not thin, so an
// effect shows in one or the other.
Result<void> work_with_one_hand(Variant& variant) {
  const SceneDef wall = wall_of(variant.def);
  std::vector<lab::SceneWork> works{lab::finger_work("bill", wall, false, 0.0015, true)};
  if (auto evening = lab::evening_work("bill", wall, 0.0015, true))
    works.push_back(std::move(*evening));
  for (lab::SceneWork& work : works) {
    auto left =
        lab::outcome_of(on_own_grid(std::move(work), variant.def), 1e-3, variant.def.clay.rows);
    if (!left) return tl::unexpected(left.error());
    variant.outcomes.push_back(std::move(*left));
  }
  return {};
}

/// All take turns, so that what keeps the machine busy for a while is in none's price alone.
Result<void> measure(std::vector<Variant>& variants, int passes) {
  for (int pass = 0; pass < passes; ++pass)
    for (Variant& variant : variants)
      if (auto timed = time_once(variant); !timed) return timed;
  for (Variant& variant : variants)
    if (auto worked = work_with_one_hand(variant); !worked) return worked;
  return {};
}

BillLine difference(const Variant& line_of, const Variant& with, const Variant& without) {
  BillLine line{line_of.effect, line_of.part_of, with.median() - without.median()};
  // An effect may bring a tool, and so a piece of work more.
  for (std::size_t n = 0; n < std::min(with.outcomes.size(), without.outcomes.size()); ++n) {
    const lab::Apart off = lab::apart(with.outcomes[n], without.outcomes[n]);
    line.shape_mm = std::max(line.shape_mm, 1e3 * off.shape);
    line.shape_max_mm = std::max(line.shape_max_mm, 1e3 * off.shape_max);
    line.force_n = std::max(line.force_n, off.force);
  }
  return line;
}

bool is_priced(std::size_t effect) { return lab::effect_names()[effect] != KilnDef::kName; }

/// The scene without each of its effects, then without each of their options.
std::vector<Variant> with_less(const SceneDef& def) {
  static const std::vector<std::string> kNames = lab::effect_names();
  std::vector<Variant> out;
  for (std::size_t n = 0; n < kNames.size(); ++n) {
    if (!lab::has_effect(def, n) || !is_priced(n)) continue;
    out.push_back({kNames[n].c_str(), "", def});
    lab::remove_effect(out.back().def, n);
  }
  for (const BillPart& part : kBillParts) {
    SceneDef rest = def;
    if (part.leave_out(rest)) out.push_back({part.key, part.effect, rest});
  }
  return out;
}

/// The scene with each effect that it lacks; one that cannot be in it is left out.
std::vector<Variant> with_more(const SceneDef& def) {
  static const std::vector<std::string> kNames = lab::effect_names();
  std::vector<Variant> out;
  for (std::size_t n = 0; n < kNames.size(); ++n) {
    if (lab::has_effect(def, n) || !is_priced(n)) continue;
    Variant more{kNames[n].c_str(), "", def};
    lab::add_effect(more.def, n);
    if (Scene::create(wall_of(more.def))) out.push_back(std::move(more));
  }
  return out;
}

}  // namespace

Result<SceneBill> bill_of(const std::string& name, const SceneDef& def, int passes,
                          bool with_offers) {
  if (def.paper)
    return problem(name, "This scene runs on the printed model, which has no effects.",
                   "Name a scene with effects.");
  std::vector<Variant> all{{"", "", def}, {"", "", lab::bare(def)}};
  std::ranges::move(with_less(def), std::back_inserter(all));
  const std::size_t offers_from = all.size();
  if (with_offers) std::ranges::move(with_more(def), std::back_inserter(all));
  if (auto done = measure(all, passes); !done) return tl::unexpected(done.error());

  SceneBill bill;
  bill.scene = name;
  bill.machine = machine_name();
  bill.rows = def.clay.rows;
  bill.sectors = def.clay.sectors;
  const Variant& whole = all[0];
  bill.whole_us = whole.median();
  bill.contact_us = all[1].median();
  std::vector<BillLine> options;
  for (std::size_t n = 2; n < all.size(); ++n) {
    const bool offered = n >= offers_from;
    const BillLine line = difference(all[n], offered ? all[n] : whole, offered ? whole : all[n]);
    (offered ? bill.offers : line.part_of.empty() ? bill.lines : options).push_back(line);
  }
  std::ranges::sort(bill.lines, std::ranges::greater{}, &BillLine::us);
  std::ranges::sort(bill.offers, std::ranges::greater{}, &BillLine::us);
  for (const BillLine& option : options) {
    const auto effect = std::ranges::find(bill.lines, option.part_of, &BillLine::effect);
    bill.lines.insert(effect + 1, option);
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

namespace {

files::Json json_of(const std::vector<BillLine>& lines) {
  files::Json list = files::Json::list();
  for (const BillLine& line : lines)
    list.push_back(files::Json::object({{"effect", line.effect},
                                        {"part_of", line.part_of},
                                        {"us", line.us},
                                        {"shape_mm_rms", line.shape_mm},
                                        {"shape_mm_max", line.shape_max_mm},
                                        {"force_n_rms", line.force_n}}));
  return list;
}

std::string bill_name(const BillLine& line) {
  return line.part_of.empty() ? line.effect : "  of it " + line.effect;
}

std::string text_of(const std::vector<BillLine>& lines) {
  char line[240];
  std::string text;
  for (const BillLine& one : lines) {
    std::snprintf(line, sizeof line, "%-22s %9.1f %11.4f %11.3f %10.4f\n", bill_name(one).c_str(),
                  one.us, one.shape_mm, one.shape_max_mm, one.force_n);
    text += line;
  }
  return text;
}

}  // namespace

files::Json json_of(const SceneBill& bill) {
  files::Json out = files::Json::object({{"scene", bill.scene},
                                         {"machine", bill.machine},
                                         {"command", bill.command},
                                         {"rows", bill.rows},
                                         {"sectors", bill.sectors},
                                         {"contact_us", bill.contact_us},
                                         {"whole_us", bill.whole_us},
                                         {"times_hold", doubt_of(bill).empty()},
                                         {"effects", json_of(bill.lines)}});
  if (!bill.offers.empty()) out["offers"] = json_of(bill.offers);
  return out;
}

std::string text_of(const SceneBill& bill) {
  char line[240];
  std::snprintf(line, sizeof line,
                "%s on %d x %d: a tick takes %.1f us, contact alone %.1f. %s.\n%-14s %9s %11s %11s "
                "%10s\n",
                bill.scene.c_str(), bill.rows, bill.sectors, bill.whole_us, bill.contact_us,
                bill.machine.c_str(), "without", "us less", "shape mm", "worst mm", "force N");
  std::string text = line + text_of(bill.lines);
  if (!bill.offers.empty()) {
    std::snprintf(line, sizeof line, "%-14s %9s\n", "with", "us more");
    text += line + text_of(bill.offers);
  }
  return text + doubt_of(bill);
}

}  // namespace onggi::tuning
