#include "engine/surface/ribbon.h"

namespace onggi::surface {

Corner beside(const Surface& surface, const Station& at, std::int64_t offset) {
  const std::int64_t width = surface.row(row_of(surface, at.along)).width;
  return {at.along + floor_div(offset * at.across_along, kUnit),
          at.round + floor_div(offset * at.across_round * kParts * kNanometres, kUnit * width)};
}

}  // namespace onggi::surface
