#include "kiosk/lab/measure/accuracy_built.h"

#include <algorithm>
#include <cstdio>

namespace onggi::measure {
namespace {

using Setting = lab::AccuracySetting;

bool in_one_step(const Setting& s) { return s.substeps == 1; }

std::string built_line(const lab::AccuracyRow& row) {
  const Setting& s = row.setting;
  char text[200];
  std::snprintf(text, sizeof text,
                "  %-6s %5d x %-5d %4g kHz %9.1f %9.1f %6.1f %% %11.5f %11.4f %8.4f %%\n",
                row.script.c_str(), s.rows, s.sectors, 1e-3 * s.rate_hz, row.p50, row.p999,
                1e-4 * row.p999 * s.rate_hz, 1e3 * row.errors.shape_rms, 1e3 * row.errors.shape_max,
                1e2 * row.errors.volume);
  return text;
}

}  // namespace

std::vector<KnownBuilt> built_truths(const AccuracyPlan& plan) {
  const lab::TruthPlan finest = plan.truth();
  std::vector<KnownBuilt> all;
  for (lab::BuiltScript& script : lab::built_scripts()) {
    KnownBuilt known{std::move(script), {}, 0.0};
    known.truth = lab::truth_of(known.script, finest.rows, finest.sectors);
    const lab::BuiltTruth half = lab::truth_of(known.script, finest.rows / 2, finest.sectors / 2);
    for (std::size_t side = 0; side < 2; ++side)
      known.apart =
          std::max(known.apart, lab::difference(half.face[side], known.truth.face[side]).rms);
    all.push_back(std::move(known));
  }
  return all;
}

std::vector<Setting> built_settings(const AccuracyPlan& plan, const lab::BuiltScript& script) {
  std::vector<Setting> all = plan.settings();
  std::erase_if(all, [&](const Setting& one) { return !lab::can_work(script, one); });
  return all;
}

double work_of(const lab::BuiltScript& script, const Setting& setting, int passes) {
  const double elements = 1e-6 * setting.rows * setting.sectors;
  const double ticks = script.work.seconds * setting.rate_hz * setting.substeps;
  return 1e-6 * passes * (ticks * 1.5 + 4e4 * elements);
}

std::vector<lab::AccuracyRow> without_built(std::vector<lab::AccuracyRow> rows) {
  std::erase_if(rows, [](const lab::AccuracyRow& row) { return lab::is_built(row.script); });
  return rows;
}

std::string words_of_built(const std::vector<lab::AccuracyRow>& rows) {
  std::string grids, ticks;
  for (const lab::AccuracyRow& row : rows) {
    if (!lab::is_built(row.script) || !in_one_step(row.setting)) continue;
    if (row.setting.rate_hz == 1000.0) grids += built_line(row);
    if (row.setting.rows == AccuracyPlan::kUsual[0]) ticks += built_line(row);
  }
  if (grids.empty()) return {};
  char head[200];
  std::snprintf(head, sizeof head, "  %-6s %-13s %8s %9s %9s %8s %11s %11s %10s\n", "",
                "rows x sect.", "", "p50 us", "p99.9 us", "of tick", "shape mm", "worst mm",
                "volume");
  return "\nA ring of coil as it is laid, and blows on a wall, in the ticks that do so. Their "
         "truth "
         "is a\nclosed form and a second program; their force is not compared.\n" +
         std::string(head) + grids + " by tick:\n" + ticks;
}

}  // namespace onggi::measure
