#pragma once

#include <vector>

namespace onggi::measure {

/// The middle of `values`; of an even number the mean of the two in the middle, 0 of none.
double middle(std::vector<double> values);

}  // namespace onggi::measure
