#include "kiosk/lab/measure/accuracy_plan.h"

#include <algorithm>

namespace onggi::measure {
namespace {

using Setting = lab::AccuracySetting;
using Model = Setting::Model;
using lab::Quadrature;
using lab::TimeRule;

constexpr int kPlainRows = 1600;  // beyond it only the printed and the shipped model are tried

class SettingList {
 public:
  void add(Setting setting) {
    if (std::ranges::find(all_, setting) == all_.end()) all_.push_back(setting);
  }
  void add(Model model, std::array<int, 2> grid, double rate = 1000.0, int substeps = 1) {
    Setting setting;
    setting.model = model;
    if (model == Model::printed) {
      setting.rule = TimeRule::printed;
      setting.quadrature = Quadrature::none;
      setting.doubles = true;
    }
    setting.rows = grid[0];
    setting.sectors = grid[1];
    setting.rate_hz = rate;
    setting.substeps = substeps;
    add(setting);
  }
  // One aspect of the law at a time, in plain code: rule, quadrature, precision.
  void add_plain(std::array<int, 2> grid, bool all_of_them) {
    for (const TimeRule rule : {TimeRule::printed, TimeRule::exact, TimeRule::shipped})
      for (const Quadrature quadrature : {Quadrature::none, Quadrature::area, Quadrature::edges})
        for (const bool doubles : {false, true}) {
          const bool usual_rule = rule == TimeRule::shipped;
          const bool usual_sum = quadrature == Quadrature::edges;
          if (!all_of_them && int{!usual_rule} + int{!usual_sum} + int{doubles} > 1) continue;
          add({Model::plain, rule, quadrature, doubles, grid[0], grid[1], 1000.0, 1});
        }
  }
  std::vector<Setting> take() { return std::move(all_); }

 private:
  std::vector<Setting> all_;
};

}  // namespace

std::vector<std::array<int, 2>> AccuracyPlan::grids() const {
  std::vector<std::array<int, 2>> all{{50, 45},   {100, 90},    {200, 180},   {400, 360},
                                      {800, 720}, {1600, 1440}, {3200, 2160}, {6400, 2880}};
  if (quick) all.erase(all.end() - 2);
  return all;
}

std::vector<std::array<int, 2>> AccuracyPlan::preset_grids() const {
  std::vector<std::array<int, 2>> all = grids();
  std::erase_if(all, [&](const auto& grid) { return grid[0] > kPlainRows; });
  return all;
}

lab::TruthPlan AccuracyPlan::truth() const {
  return quick ? lab::TruthPlan{1900, 1500, 8000.0} : lab::TruthPlan{2900, 2100, 16000.0};
}

std::vector<Setting> AccuracyPlan::settings() const {
  SettingList list;
  for (const auto& grid : grids()) {
    const bool fine = grid[0] > kPlainRows;
    const bool all_rates = !quick || grid == kUsual;
    for (const double rate : kRates) {
      if (rate != 1000.0 && !all_rates) continue;
      list.add(Model::shipped, grid, rate);
      if (!quick || !fine) list.add(Model::printed, grid, rate);
    }
    for (const int substeps : {2, 4})
      if (all_rates || (substeps == 4 && !fine)) list.add(Model::shipped, grid, 1000.0, substeps);
    if (!fine && (!quick || grid[0] <= 800)) list.add_plain(grid, !quick && grid[0] <= 800);
    if (grid != kUsual) continue;
    for (const double rate : kRates)
      for (const TimeRule rule : {TimeRule::printed, TimeRule::exact, TimeRule::shipped})
        list.add({Model::plain, rule, Quadrature::edges, false, grid[0], grid[1], rate, 1});
    for (const int substeps : {2, 4})
      list.add({Model::plain, TimeRule::shipped, Quadrature::edges, false, grid[0], grid[1], 1000.0,
                substeps});
  }
  return list.take();
}

int AccuracyPlan::passes(const Setting& setting) const {
  if (setting.rows > kPlainRows) return 1;  // their ticks are long, half of the total time
  if (setting.rate_hz != 1000.0) return quick ? 1 : 2;
  if (setting.model == Model::shipped && setting.substeps == 1) return 5;
  return !quick && setting.rows <= 800 ? 3 : setting.rows <= 800 ? 2 : 1;
}

double work_of(const lab::AccuracyScript& script, const Setting& setting, int passes) {
  const double elements = 1e-6 * setting.rows * setting.sectors;
  const double ticks = script.seconds * setting.rate_hz * setting.substeps;
  const double wide = script.name == "near_axis" ? 4.0 : script.name == "centre" ? 3.0 : 1.0;
  const double per_tick =
      setting.model == Model::shipped ? 1.5 + 5.0 * wide * elements : 2.0 + 35.0 * wide * elements;
  const double made = setting.model == Model::plain ? 2e3 : 8e3;  // clay, and its comparison
  return 1e-6 * passes * (ticks * per_tick + made * elements);
}

}  // namespace onggi::measure
