#include "engine/lab/order.h"

#include <cmath>
#include <limits>

#include "engine/math/portable.h"

namespace onggi::lab {

Order observed_order(double coarse, double middle, double fine, double ratio, double theory) {
  Order out;
  const double first = coarse - middle, second = middle - fine;
  const bool from_one_side = first * second > 0.0;
  out.p = from_one_side ? portable::log(first / second) / portable::log(ratio)
                        : std::numeric_limits<double>::quiet_NaN();
  out.asymptotic = from_one_side && std::fabs(out.p - theory) <= kOrderAllowed;
  // Without an order nothing can be said of the finer steps to come.
  const double p = from_one_side && out.p > 0.5 ? out.p : theory;
  out.uncertainty = 1.25 * std::fabs(second) / (portable::exp(p * portable::log(ratio)) - 1.0);
  out.gci = fine != 0.0 ? out.uncertainty / std::fabs(fine) : 0.0;
  return out;
}

}  // namespace onggi::lab
