#pragma once

#include <vector>

namespace onggi::measure {

/// The median of `values`; for an even number the mean of the two in the middle, 0 if empty.
double middle(std::vector<double> values);

}  // namespace onggi::measure
