#include "engine/clay/row_means.h"

#include <numeric>

namespace onggi::clay {

double row_mean(std::span<const float> radii) noexcept {
  return std::accumulate(radii.begin(), radii.end(), 0.0) / static_cast<double>(radii.size());
}

double row_spread(std::span<const float> radii, double mean) noexcept {
  double squares = 0.0;
  for (const float radius : radii) squares += (double{radius} - mean) * (double{radius} - mean);
  return squares;
}

Profile outline_of(std::span<const double> middle, std::span<const double> outer,
                   std::span<const double> inner, double rim) {
  Profile profile;
  if (middle.empty()) return profile;
  profile.points.reserve(middle.size() + 2);
  profile.points.push_back({0.0, outer.front(), inner.front()});
  for (std::size_t j = 0; j < middle.size(); ++j)
    if (middle[j] > profile.height() && middle[j] < rim)
      profile.points.push_back({middle[j], outer[j], inner[j]});
  profile.points.push_back({rim, outer.back(), inner.back()});
  return profile;
}

}  // namespace onggi::clay
