#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/lab/accuracy.h"
#include "engine/lab/order.h"

namespace onggi::measure {

/// How three results on ever finer steps draw together.
struct AccuracyOrder {
  std::string script;
  lab::AccuracySetting finest;
  std::string knob;      ///< "grid", "tick", "substeps"
  std::string quantity;  ///< "shape", "force", "volume"
  double theory = 2.0;
  double last_step = 0.0;  ///< By which the finest two differ, mm, N s or mm^3.
  lab::Order order;        ///< Uncertainty likewise.
};

/// Orders of all that was measured in a script on grids, ticks or substeps that are each half as
/// long as those before, everything else alike. Force is the first hand's impulse (N s), volume
/// what was displaced (mm^3), shape on grids its error (mm, root mean square). Theory: 2 for sums
/// over middles, 1.5 for a shape with corners, and in the tick 2 where a tool is met in the middle
/// of the step; where it is met at its end, 1 for the force and 2 for what it leaves.
std::vector<AccuracyOrder> orders_of(const std::vector<lab::AccuracyRow>& rows);

/// The order of the shape in the tick: the script is worked by `setting` at every rate of `rates`
/// (Hz, each twice the one before), and the faces that two rates leave are compared with each
/// other. One for each three rates. Allocates.
std::vector<AccuracyOrder> tick_orders(const lab::AccuracyScript& script,
                                       lab::AccuracySetting setting, std::span<const double> rates);

/// Whether the finest two results of it differ by less than anybody could tell: 0.2 um,
/// 0.1 mN s or 0.1 mm^3. There an order means nothing.
bool converged(const AccuracyOrder& order);

/// The one of `orders` for these on the finest steps that is not converged(), or the finest of all;
/// null where there is none.
const AccuracyOrder* finest_order(const std::vector<AccuracyOrder>& orders,
                                  lab::AccuracySetting::Model model, lab::TimeRule rule,
                                  const std::string& script, const std::string& knob,
                                  const std::string& quantity);

}  // namespace onggi::measure
