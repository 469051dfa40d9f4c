#include "tests/pages/naive_text.h"

#include <cstdio>

namespace onggi::pages {

namespace {

files::Json looks_json(const measure::HeadlessOutcome& visit) {
  files::Json looks = files::Json::list();
  for (const measure::PotLook& look : visit.looks)
    looks.push_back(files::Json::object({{"seconds", look.seconds},
                                         {"points", look.points},
                                         {"stars", look.stars},
                                         {"roughness", look.smooth.roughness},
                                         {"ledge", look.smooth.ledge},
                                         {"out_of_round", look.out_of_round},
                                         {"way_in", look.way_in},
                                         {"wall", look.wall}}));
  files::Json out = files::Json::object({{"vessel", visit.vessel},
                                         {"seed", static_cast<double>(visit.seed)},
                                         {"mishaps", visit.mishaps},
                                         {"looks", looks}});
  if (visit.handsome_at) out["handsome_at"] = *visit.handsome_at;
  return out;
}

}  // namespace

files::Json json_of(const measure::NaiveTable& table) {
  files::Json naive = files::Json::list(), careful = files::Json::list();
  for (const measure::HeadlessOutcome& visit : table.naive) naive.push_back(looks_json(visit));
  for (const measure::HeadlessOutcome& visit : table.careful) careful.push_back(looks_json(visit));
  return files::Json::object(
      {{"scene", table.scene},
       {"machine", table.machine},
       {"pointer",
        table.plan.pointer == rehearsal::NaiveHands::Pointer::finger ? "finger" : "mouse"},
       {"naive", naive},
       {"careful", careful}});
}

std::string text_of(const measure::NaiveTable& table) {
  char line[200];
  std::snprintf(line, sizeof line, "naive hands, %s, %s, seeds %llu to %llu\n", table.scene.c_str(),
                table.plan.pointer == rehearsal::NaiveHands::Pointer::finger ? "finger" : "mouse",
                static_cast<unsigned long long>(table.plan.first),
                static_cast<unsigned long long>(table.plan.first) + table.plan.seeds - 1);
  std::string text = line;
  std::snprintf(line, sizeof line, "%5s %-22s %6s %6s %5s %6s %9s %9s %9s %7s %8s  %s\n", "s",
                "vessel", "points", "least", "stars", "of 5", "rough mm", "ledge mm", "round mm",
                "way in", "wall mm", "handsome after");
  text += line;
  for (const measure::NaiveLine& one : table.lines) {
    std::snprintf(line, sizeof line,
                  "%5.0f %-22s %6.1f %6.1f %5.1f %6d %9.2f %9.2f %9.2f %6.0f%% %8.1f  ",
                  one.seconds, one.vessel.c_str(), one.points, one.least_points, one.stars,
                  one.five_stars, 1e3 * one.roughness, 1e3 * one.ledge, 1e3 * one.out_of_round,
                  100 * one.way_in, 1e3 * one.wall);
    text += line;
    if (one.handsome_at)
      std::snprintf(line, sizeof line, "%.0f s (%d of %d)\n", *one.handsome_at, one.handsome,
                    one.visits);
    else
      std::snprintf(line, sizeof line, "never\n");
    text += line;
  }
  for (const measure::HeadlessOutcome& one : table.careful) {
    const measure::PotLook& look = one.looks.front();
    std::snprintf(line, sizeof line,
                  "%5.0f %-22s %6.1f %6s %5d %6s %9.2f %9.2f %9.2f %6.0f%% %8.1f  careful\n",
                  look.seconds, one.vessel.c_str(), look.points, "", look.stars, "",
                  1e3 * look.smooth.roughness, 1e3 * look.smooth.ledge, 1e3 * look.out_of_round,
                  100 * look.way_in, 1e3 * look.wall);
    text += line;
  }
  return text;
}

}  // namespace onggi::pages
