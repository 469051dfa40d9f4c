#include "kiosk/visit/decorating/layers.h"

#include <algorithm>

namespace onggi::decorating {

Layers layers_on(const surface::Surface& surface, int j, int i, double glaze) {
  Layers out;
  out.cut = 1e-6 * std::max(-surface.relief(j, i), 0);
  const surface::Strata strata = surface.slip(j, i);
  for (int k = surface::kStrata - 1; k >= 0; --k)
    if (const surface::Stratum slip = strata.at(k); slip.code > 0)
      out.slips.push_back({slip.pigment, 1e-9 * surface::thickness_of(slip.code)});
  out.glaze = glaze;
  return out;
}

}  // namespace onggi::decorating
