#include "engine/profile/capacity.h"

#include "engine/math/portable.h"

namespace onggi {

double capacity(const Profile& profile) {
  double sum = 0.0;
  for (std::size_t n = 1; n < profile.points.size(); ++n) {
    const ProfilePoint &low = profile.points[n - 1], &high = profile.points[n];
    // A floor is level: what lies below the first open height is clay.
    if (low.inner <= 0.0) continue;
    sum += (high.height - low.height) *
           (low.inner * low.inner + low.inner * high.inner + high.inner * high.inner);
  }
  return portable::kPi / 3.0 * sum;
}

}  // namespace onggi
