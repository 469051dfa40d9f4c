#pragma once

namespace onggi::effects {

/// False only in an engine built without effects (-DONGGI_WITHOUT_EFFECTS).
/// tests/determinism/without_effects.py compares that engine with the whole one.
#ifdef ONGGI_WITHOUT_EFFECTS
inline constexpr bool kBuilt = false;
#else
inline constexpr bool kBuilt = true;
#endif

}  // namespace onggi::effects
