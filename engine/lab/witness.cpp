#include "engine/lab/witness.h"

#include <array>

namespace onggi::lab {

std::span<const WitnessFamily> witness_families() {
  static const std::array<WitnessFamily, 6> kFamilies{{{"contact", contact_witnesses()},
                                                       {"effects", effect_witnesses()},
                                                       {"walls", wall_witnesses()},
                                                       {"building", building_witnesses()},
                                                       {"force", force_witnesses()},
                                                       {"clay", clay_witnesses()}}};
  return kFamilies;
}

}  // namespace onggi::lab
