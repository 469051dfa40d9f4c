#include "engine/clay/row_area.h"
#include "engine/math/lanes.h"

namespace onggi::ONGGI_LANES {
namespace {

// A plain loop, which compilers vectorise for doubles; lanes.h has floats only.
double sum_squares(int width, const float* outer, const float* inner) {
  double sums[kLanes] = {};
  int i = 0;
  for (; i + kLanes <= width; i += kLanes)
    for (int k = 0; k < kLanes; ++k) {
      const double o = static_cast<double>(outer[i + k]);
      const double n = static_cast<double>(inner[i + k]);
      sums[k] += (o - n) * (o + n);
    }
  double rest = 0.0;
  for (; i < width; ++i) {
    const double o = static_cast<double>(outer[i]);
    const double n = static_cast<double>(inner[i]);
    rest += (o - n) * (o + n);
  }
  return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7])) +
         rest;
}

}  // namespace

extern const clay::AreaKernel kAreaKernel{sum_squares};

}  // namespace onggi::ONGGI_LANES
