#include "kiosk/lab/measure/accuracy_picture.h"

#include <algorithm>
#include <cstdio>

#include "kiosk/lab/measure/accuracy_report.h"
#include "kiosk/picture/view/palette.h"

namespace onggi::measure {
namespace {

using Setting = lab::AccuracySetting;
using Model = Setting::Model;
using Chart = plots::AccuracyChart;

std::string grid_name(const Setting& s) {
  return std::to_string(s.rows) + " × " + std::to_string(s.sectors);
}

bool broke(const AccuracyReport& report, const Setting& setting) {
  return std::ranges::any_of(report.unstable, [&](const UnstableSetting& one) {
    return one.model == setting.model && one.rows == setting.rows;
  });
}

bool at_a_kilohertz(const Setting& s) { return s.rate_hz == 1000.0 && s.substeps == 1; }

Chart::Mark mark_of(const lab::SettingSummary& one) {
  return {one.p999, 1e3 * one.errors.shape_rms};
}

// The cost of the most expensive preset on our grids, at the error of the scripts.
Chart::Line dearest_scene(const AccuracyReport& report) {
  Chart::Line line{"ours, in the dearest scene", view::kDeepCeladon, false, true, false, {}};
  for (const lab::SettingSummary& all : report.scenes) {
    if (all.setting.model != Model::shipped || !at_a_kilohertz(all.setting)) continue;
    const auto bench = std::ranges::find_if(report.settings, [&](const auto& one) {
      return one.setting == all.setting && one.scripts < all.scripts;
    });
    if (bench != report.settings.end())
      line.marks.push_back({all.p999, 1e3 * bench->errors.shape_rms});
  }
  return line;
}

// A builder's work on our grids. Blows come so near that they would leave no room for the rest.
Chart::Line work_line(const AccuracyReport& report, const char* script, const char* name,
                      view::Color color) {
  Chart::Line line{name, color, false, true, false, {}};
  for (const lab::AccuracyRow& row : report.rows)
    if (row.script == script && at_a_kilohertz(row.setting) &&
        1e3 * row.errors.shape_rms >= 0.1 * report.truth_mm)
      line.marks.push_back({row.p999, 1e3 * row.errors.shape_rms});
  return line;
}

std::vector<Chart::Force> forces_of(const AccuracyReport& report) {
  Chart::Force ours{view::kDeepCeladon, false, {}, {}};
  Chart::Force printed{view::kIron, true, {}, {}};
  for (const lab::AccuracyRow& row : report.rows) {
    if (row.script != "press" || !at_a_kilohertz(row.setting) || row.setting.model == Model::plain)
      continue;
    Chart::Force& of = row.setting.model == Model::shipped ? ours : printed;
    of.elements.push_back(1e-6 * row.setting.rows * row.setting.sectors);
    of.force.push_back(row.mean_force / row.true_force);
  }
  return {ours, printed};
}

double rms_in_vase(const AccuracyReport& report, const Setting& setting) {
  for (const lab::AccuracyRow& row : report.rows)
    if (row.script == "throw" && row.setting.model == setting.model &&
        at_a_kilohertz(row.setting) && row.setting.rows == setting.rows)
      return 1e3 * row.errors.shape_rms;
  return 0.0;
}

}  // namespace

plots::AccuracyChart chart_of(const AccuracyReport& report) {
  Chart chart;
  chart.title = "What accuracy costs in time";
  chart.subtitle =
      "The worst of seven pieces of a potter's work, for time and for shape alike. The truth is a "
      "second program, in doubles.";
  if (report.recommended) chart.says = words_of(*report.recommended) + ' ';
  // No line begins with a percent sign.
  for (std::size_t at = 0; (at = chart.says.find(" %", at)) != std::string::npos;)
    chart.says.replace(at, 1, "\u00a0");
  chart.says += report.machine + ", " + report.made + "; " + report.command + ", seed " +
                std::to_string(report.plan.seed) + "; each time is that of one thread.";
  Chart::Line ours{"ours", view::kDeepCeladon, false, false, false, {}};
  Chart::Line printed{"as printed in 2008", view::kIron, true, false, true, {}};
  for (const lab::SettingSummary& one : report.settings) {
    const Setting& s = one.setting;
    if (!at_a_kilohertz(s) || s.model == Model::plain) {
      chart.cloud.push_back(mark_of(one));
      continue;
    }
    Chart::Line& line = s.model == Model::shipped ? ours : printed;
    line.marks.push_back(mark_of(one));
    line.marks.back().name = grid_name(s);
    line.marks.back().broke = broke(report, s);
  }
  chart.lines = {printed, ours, dearest_scene(report)};
  for (const Chart::Line& line : {work_line(report, "coil", "a ring of coil", view::kDryClay),
                                  work_line(report, "blows", "blows on a wall", view::kCobalt)})
    if (!line.marks.empty()) chart.lines.push_back(line);
  for (const std::size_t n : report.edge) chart.edge.push_back(mark_of(report.settings[n]));
  if (report.recommended)
    chart.chosen = {report.recommended->chosen.p999,
                    1e3 * report.recommended->chosen.errors.shape_rms};
  const lab::HumanThresholds& can = report.thresholds;
  chart.thresholds = {{1e3 * can.wall, "finger and thumb tell two walls apart, 0.4 mm"},
                      {1e3 * can.pixel, "a pixel of a 24-inch screen, 0.27 mm"},
                      {1e3 * can.device, "a PHANToM Omni resolves 0.055 mm"}};
  chart.unsure = report.truth_mm;
  chart.forces = forces_of(report);
  chart.force_told = can.force;
  for (const AccuracyPot& pot : report.pots) {
    Chart::Pot out;
    out.name = (pot.setting.model == Model::printed ? "as printed, " : "") + grid_name(pot.setting);
    char below[64];
    std::snprintf(below, sizeof below, "%.3f mm off", rms_in_vase(report, pot.setting));
    out.below = below;
    out.columns = pot.columns;
    out.rows = pot.rows;
    out.height = pot.high - pot.low;
    out.radius = pot.radius;
    out.off = pot.off;
    out.chosen = report.recommended && pot.setting.model == Model::shipped &&
                 pot.setting.rows == report.recommended->chosen.setting.rows;
    for (const lab::SettingSummary& one : report.settings)
      if (one.setting == pot.setting) out.at = mark_of(one);
    chart.pots.push_back(std::move(out));
  }
  return chart;
}

}  // namespace onggi::measure
