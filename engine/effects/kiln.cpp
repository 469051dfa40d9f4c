#include "engine/effects/kiln.h"

namespace onggi {

std::span<const DefField<KilnDef>> KilnDef::fields() {
  static constexpr DefField<KilnDef> kFields[] = {
      {"drying_shrinkage", &KilnDef::drying_shrinkage, 0.0, 0.15, ""},
      {"firing_shrinkage", &KilnDef::firing_shrinkage, 0.0, 0.2, ""},
      {"glaze_thickness", &KilnDef::glaze_thickness, 0.0, 0.002, "m"},
  };
  return kFields;
}

std::span<const ClayBody> clay_bodies() {
  // Totals are the middles of 8-12 %, 11-15 % and 14-20 %. The split is an estimate: bodies dry
  // much alike, and denser ware shrinks more in the kiln.
  static constexpr ClayBody kBodies[] = {
      {"earthenware", 0.06, 0.0426},  // 10 %
      {"stoneware", 0.0625, 0.0666},  // 12.5 %
      {"porcelain", 0.06, 0.117},     // 17 %
  };
  return kBodies;
}

const ClayBody* find_clay_body(std::string_view name) {
  for (const ClayBody& body : clay_bodies())
    if (body.name == name) return &body;
  return nullptr;
}

double size_after(const KilnDef& def, const Firing& at) noexcept {
  return (1.0 - def.drying_shrinkage * at.dried) * (1.0 - def.firing_shrinkage * at.fired);
}

}  // namespace onggi
