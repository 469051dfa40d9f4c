#pragma once

#include <span>

#include "engine/base/field_check.h"

namespace onggi {

/// One number of a definition: its key in a scene's TOML, where it lies in the Def, and its range.
/// The TOML reader, validate() and the replay all go by this one list, so that a field is written
/// down once. The Def of every effect and of every other part of a scene has
///
///   static constexpr const char* kName;              // the table in a scene's TOML
///   static std::span<const DefField<Def>> fields();  // all its numbers
///
/// and, where it has some, whole numbers before those and switches behind them:
///
///   static std::span<const DefField<Def, int>> counts();
///   static std::span<const DefField<Def, bool>> switches();
///
template <class Def, class Value = double>
struct DefField {
  const char* key;
  Value Def::*value;
  double least, most;
  const char* unit;                ///< "m", "s"; "" where it has none.
  const char* formerly = nullptr;  ///< The key that it had before: files that have it still open.
};

/// Calls `visit` with each DefField of a Def: counts, numbers, switches.
template <class Def, class Visit>
void each_field(Visit&& visit) {
  if constexpr (requires { Def::counts(); })
    for (const DefField<Def, int>& field : Def::counts()) visit(field);
  for (const DefField<Def>& field : Def::fields()) visit(field);
  if constexpr (requires { Def::switches(); })
    for (const DefField<Def, bool>& field : Def::switches()) visit(field);
}

/// First of the definition's numbers that is out of range or none.
template <class Def>
void check_fields(FieldCheck& check, const Def& def) {
  each_field<Def>([&](const auto& field) {
    check.range(field.key, def.*(field.value), field.least, field.most, field.unit);
  });
}
template <class Def>
Result<void> check_fields(const Def& def) {
  FieldCheck check(Def::kName);
  check_fields(check, def);
  return check.result();
}

}  // namespace onggi
