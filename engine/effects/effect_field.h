#pragma once

#include <span>

#include "engine/base/field_check.h"

namespace onggi {

/// One number of an effect: its key in a scene's TOML, where it lies in the Def, and its range. The
/// TOML reader, validate() and the replay all go by this one list, so that a field is written down
/// once. Every effect's Def has
///
///   static constexpr const char* kName;                 // the table in a scene's TOML
///   static std::span<const EffectField<Def>> fields();  // all its numbers
///
template <class Def>
struct EffectField {
  const char* key;
  double Def::*value;
  double least, most;
  const char* unit;  ///< "m", "s"; "" where it has none.
};

/// First of the effect's numbers that is out of range or none.
template <class Def>
Result<void> check_fields(const Def& def) {
  FieldCheck check(Def::kName);
  for (const EffectField<Def>& field : Def::fields())
    check.range(field.key, def.*(field.value), field.least, field.most, field.unit);
  return check.result();
}

}  // namespace onggi
