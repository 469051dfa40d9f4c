#pragma once

namespace onggi::effects {

/// False only in an engine that was built without any effect's stage (-DONGGI_WITHOUT_EFFECTS), to
/// which tests/determinism/without_effects.py compares the whole one.
#ifdef ONGGI_WITHOUT_EFFECTS
inline constexpr bool kBuilt = false;
#else
inline constexpr bool kBuilt = true;
#endif

}  // namespace onggi::effects
