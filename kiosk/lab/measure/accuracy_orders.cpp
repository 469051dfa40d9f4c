#include "kiosk/lab/measure/accuracy_orders.h"

#include <algorithm>
#include <cmath>

namespace onggi::measure {
namespace {

using Setting = lab::AccuracySetting;
using Row = lab::AccuracyRow;

const Row* find(const std::vector<Row>& rows, const std::string& script, const Setting& setting) {
  const auto at = std::ranges::find_if(
      rows, [&](const Row& row) { return row.script == script && row.setting == setting; });
  return at == rows.end() ? nullptr : &*at;
}

// The setting with steps twice as long.
Setting coarser(Setting setting, const std::string& knob) {
  if (knob == "grid") {
    setting.rows = setting.rows % 2 == 0 ? setting.rows / 2 : 0;
    setting.sectors = setting.sectors % 2 == 0 ? setting.sectors / 2 : 0;
  } else if (knob == "tick") {
    setting.rate_hz *= 0.5;
  } else {
    setting.substeps = setting.substeps % 2 == 0 ? setting.substeps / 2 : 0;
  }
  return setting;
}

double theory_of(const Setting& setting, const std::string& knob, const std::string& quantity) {
  // With straight lines between elements, the shape's error is of the order of the step at a
  // corner, and of its square elsewhere.
  if (knob == "grid") return quantity == "shape" ? 1.5 : 2.0;
  if (setting.model == Setting::Model::shipped || setting.rule == lab::TimeRule::shipped)
    return 2.0;
  // A tool that is met at the step's end is half a step early. The force shows that at once; the
  // shape shows it only where the tool turns round, where half a step is nothing.
  return setting.rule == lab::TimeRule::exact && quantity != "force" ? 2.0 : 1.0;
}

double value_of(const Row& row, const std::string& quantity) {
  return quantity == "shape"   ? 1e3 * row.errors.shape_rms
         : quantity == "force" ? row.impulse
                               : 1e9 * row.displaced;
}

}  // namespace

std::vector<AccuracyOrder> orders_of(const std::vector<Row>& rows) {
  std::vector<AccuracyOrder> orders;
  for (const Row& fine : rows)
    for (const char* knob : {"grid", "tick", "substeps"}) {
      const Row* middle = find(rows, fine.script, coarser(fine.setting, knob));
      const Row* coarse =
          middle == nullptr ? nullptr : find(rows, fine.script, coarser(middle->setting, knob));
      if (coarse == nullptr) continue;
      // A preset's displaced volume is known only as an error.
      const bool by_preset = fine.displaced == 0.0;
      for (const char* quantity : {"shape", "force", "volume"}) {
        if (by_preset && quantity == std::string("volume")) continue;
        if (quantity == std::string("shape") && knob != std::string("grid")) continue;
        const double theory = theory_of(fine.setting, knob, quantity);
        const double is = value_of(fine, quantity), before = value_of(*middle, quantity);
        if (std::isnan(is)) continue;  // it was not compared
        orders.push_back(
            {fine.script, fine.setting, knob, quantity, theory, std::fabs(before - is),
             lab::observed_order(value_of(*coarse, quantity), before, is, 2.0, theory)});
      }
    }
  return orders;
}

std::vector<AccuracyOrder> tick_orders(const lab::AccuracyScript& script, Setting setting,
                                       std::span<const double> rates) {
  const WallSide side = script.balls.front().side;
  std::vector<AccuracyOrder> orders;
  std::vector<double> apart;
  lab::FaceGrid before;
  for (const double rate : rates) {
    setting.rate_hz = rate;
    lab::FaceGrid face = lab::face_left(script, setting, side);
    if (before.rows > 0) apart.push_back(1e3 * lab::difference(before, face).rms);
    before = std::move(face);
    if (apart.size() < 2) continue;
    const double first = apart[apart.size() - 2], second = apart.back();
    const double theory = theory_of(setting, "tick", "shape");
    orders.push_back({script.name, setting, "tick", "shape", theory, second,
                      lab::observed_order(first + second, second, 0.0, 2.0, theory)});
  }
  return orders;
}

bool converged(const AccuracyOrder& order) {
  const double least = order.quantity == "shape" ? 2e-4 : order.quantity == "force" ? 1e-4 : 0.1;
  return order.last_step < least;
}

const AccuracyOrder* finest_order(const std::vector<AccuracyOrder>& orders, Setting::Model model,
                                  lab::TimeRule rule, const std::string& script,
                                  const std::string& knob, const std::string& quantity) {
  const AccuracyOrder* found = nullptr;
  const auto fineness = [](const AccuracyOrder& one) {
    return (converged(one) ? 0.0 : 1e9) +
           one.finest.rows * one.finest.rate_hz * one.finest.substeps;
  };
  for (const AccuracyOrder& one : orders) {
    if (one.finest.model != model || one.finest.rule != rule || one.script != script ||
        one.knob != knob || one.quantity != quantity)
      continue;
    if (found == nullptr || fineness(one) > fineness(*found)) found = &one;
  }
  return found;
}

}  // namespace onggi::measure
