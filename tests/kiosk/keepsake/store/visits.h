#pragma once

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "kiosk/keepsake/store/visit_record.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::store {

class StoreFolder : public files::test::ScratchFolder {
 public:
  std::filesystem::path file() const { return path() / "onggi.sqlite"; }
  /// Files whose name has `part` in it.
  int files_with(const std::string& part) const {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(path()))
      count += entry.path().filename().string().find(part) != std::string::npos ? 1 : 0;
    return count;
  }
};

/// A visit as scripted visitors make them: `days` days of 2026, most of them whole, some brief.
inline VisitRecord scripted_visit(std::mt19937& random, int days = 28) {
  const auto pick = [&random](int most) {
    return static_cast<int>(random() % static_cast<unsigned>(most));
  };
  const std::vector<std::string> vessels{"moon_jar", "tea_bowl", "maebyeong", "albarello", "=1+1"};
  const std::vector<std::string> screens{"choose", "throw", "result", "kiln", "keepsake"};
  const std::vector<std::string> ways{"touch", "mouse", "keys", "space_mouse"};
  VisitRecord v;
  const int day = pick(days);
  v.day = "2026-05-" + std::string(day < 9 ? "0" : "") + std::to_string(day + 1);
  v.hour = 10 + pick(8);
  v.start = 1'777'593'600 + std::int64_t{86400} * day + 3600 * v.hour + pick(3600);
  const int reached = pick(5);
  v.reached = screens[static_cast<std::size_t>(reached)];
  v.left = pick(4) == 0 ? screens[static_cast<std::size_t>(pick(reached + 1))] : v.reached;
  // The rarer the later in the list: a table with small cells.
  v.vessel = reached == 0 ? "" : vessels[static_cast<std::size_t>(std::min(pick(5), pick(5)))];
  // A pot by figures is called by its mission among the vessels too.
  const std::vector<std::string> missions{"", "", "todays_vessel", "litre_jar"};
  if (reached > 0) v.mission = missions[static_cast<std::size_t>(pick(4))];
  if (v.mission == "litre_jar") v.vessel = v.mission;
  v.scene = "first_touch";
  v.language = pick(3) == 0 ? "ko" : "en";
  v.way = ways[static_cast<std::size_t>(std::min(pick(4), pick(4)))];
  v.ended = pick(3) == 0 ? "idle" : "finished";
  v.active_s = pick(10) == 0 ? 0.25 * pick(12) : 0.25 * (12 + pick(2000));
  v.throwing_s = 0.5 * v.active_s;
  v.pots = reached == 0 ? 0 : 1 + pick(2);
  if (reached > 1) v.likeness = 0.25 * pick(401);
  v.kept = reached == 4 && pick(10) != 0;
  return v;
}

inline std::vector<VisitRecord> scripted_visits(int count, unsigned seed, int days = 28) {
  std::mt19937 random(seed);
  std::vector<VisitRecord> all;
  all.reserve(static_cast<std::size_t>(count));
  for (int n = 0; n < count; ++n) all.push_back(scripted_visit(random, days));
  return all;
}

}  // namespace onggi::store
