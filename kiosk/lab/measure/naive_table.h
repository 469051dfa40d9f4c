#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/lab/measure/headless_visit.h"

namespace onggi::measure {

/// The plan of beginners' visits to a shelf.
struct NaivePlan {
  std::string exhibit_file;
  std::string scene;                 ///< Replaces the exhibit's scenes; empty: those.
  std::vector<std::string> vessels;  ///< Empty: all of the shelf.
  int seeds = 20;                    ///< Visits a vessel, >= 1.
  std::uint64_t first = 1;           ///< Seed of the first.
  std::vector<double> moments = {30, 60, 90, 120};  ///< s, rising, 5 to 600: when pots are scored.
  rehearsal::NaiveHands::Pointer pointer = rehearsal::NaiveHands::Pointer::mouse;
  bool careful = false;  ///< Also the script's hand, once a vessel.
  int threads = 1;
};

/// The median and the worst of some visits at one moment.
struct NaiveLine {
  std::string vessel;  ///< "all" for all of them.
  double seconds = 0;
  int visits = 0;
  double points = 0, least_points = 0, stars = 0;     ///< Medians, except for the least.
  double roughness = 0, ledge = 0, out_of_round = 0;  ///< Medians, m.
  double way_in = 1, wall = 0;                        ///< Medians; PotLook's.
  int five_stars = 0;                                 ///< Visits with five stars.
  std::optional<double> handsome_at;  ///< Median over the visits that reached it, s,
  int handsome = 0;                   ///< and their number.
};

struct NaiveTable {
  std::string scene, machine;
  NaivePlan plan;
  std::vector<HeadlessOutcome> naive, careful;  ///< By vessel, then seed.
  std::vector<NaiveLine> lines;                 ///< By moment, then vessel, "all" last.
};

/// Runs the visits and reports each to `progress`. Takes minutes to an hour. Problem as in
/// HeadlessVisits.
Result<NaiveTable> measure_naive(const NaivePlan& plan, std::FILE* progress);
/// The lines for `outcomes`, each with one look for each moment.
std::vector<NaiveLine> lines_of(const std::vector<HeadlessOutcome>& outcomes,
                                const std::vector<double>& moments);

}  // namespace onggi::measure
