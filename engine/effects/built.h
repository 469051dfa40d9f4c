#pragma once

namespace onggi {

/// False only in an engine that was built without any effect's stage (-DONGGI_WITHOUT_EFFECTS), to
/// which tests/determinism/without_effects.py compares the whole one.
#ifdef ONGGI_WITHOUT_EFFECTS
inline constexpr bool kEffectsBuilt = false;
#else
inline constexpr bool kEffectsBuilt = true;
#endif

}  // namespace onggi
