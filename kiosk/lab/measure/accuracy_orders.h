#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/lab/accuracy.h"
#include "engine/lab/order.h"

namespace onggi::measure {

/// The convergence of three results on ever finer steps.
struct AccuracyOrder {
  std::string script;
  lab::AccuracySetting finest;
  std::string knob;      ///< "grid", "tick", "substeps"
  std::string quantity;  ///< "shape", "force", "volume"
  double theory = 2.0;
  double last_step = 0.0;  ///< Difference of the finest two, mm, N s or mm^3.
  lab::Order order;        ///< Its uncertainty is in the same unit.
};

/// Orders of all measurements in a script on grids, ticks or substeps, each half as long as the one
/// before, with everything else equal. Force is the first hand's impulse (N s), volume the
/// displaced volume (mm^3), shape on grids its error (mm, root mean square). Theory: 2 for sums
/// over middles, 1.5 for a shape with corners, and in the tick 2 if a tool is met in the middle of
/// the step; if it is met at its end, 1 for the force and 2 for the shape.
std::vector<AccuracyOrder> orders_of(const std::vector<lab::AccuracyRow>& rows);

/// The order of the shape in the tick: `setting` runs the script at every rate of `rates` (Hz, each
/// twice the one before), and the surfaces of two rates are compared. One order for each three
/// rates. Allocates.
std::vector<AccuracyOrder> tick_orders(const lab::AccuracyScript& script,
                                       lab::AccuracySetting setting, std::span<const double> rates);

/// True if its finest two results differ by less than anybody can notice: 0.2 um, 0.1 mN s or 0.1
/// mm^3. An order then means nothing.
bool converged(const AccuracyOrder& order);

/// The entry of `orders` for these on the finest steps that is not converged(), or the finest of
/// all; null if there is none.
const AccuracyOrder* finest_order(const std::vector<AccuracyOrder>& orders,
                                  lab::AccuracySetting::Model model, lab::TimeRule rule,
                                  const std::string& script, const std::string& knob,
                                  const std::string& quantity);

}  // namespace onggi::measure
