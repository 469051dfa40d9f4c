#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/profile/profile.h"
#include "engine/scene/hands.h"
#include "engine/scene/scene_def.h"

namespace onggi {

class Clay;

/// A scripted potter: moves the same tools a visitor has. Tests, benches, attract mode and the
/// scripted visitor share them.
class Script {
 public:
  virtual ~Script() = default;
  /// The hands `t` seconds after the script began. Pure but for the script's own progress along its
  /// plan; t never goes back. No allocation, no throw: it runs on the 1 kHz thread.
  virtual Hands at(double t, const Clay& clay) noexcept = 0;
  virtual double duration() const = 0;  ///< Seconds; at() after that leaves the hands lifted.
  /// A short id of what the hands do at `t`, for hints and tests: "open", "collar", "lift"...
  virtual std::string_view phase(double t) const = 0;
};

struct ScriptContext {
  SceneDef scene;                   ///< As given to Scene::create.
  const Profile* target = nullptr;  ///< At workspace scale; needed by "follow" only. Copied.
  std::uint64_t seed = 1;           ///< Small human unevenness in speed and path.
  double pace = 1.0;                ///< 0.25..4; 2 does the same moves in half the time.
};

/// "true", "collar", "belly", "bowl", "groove", "follow"; "open", "press_rim", "flare_rim",
/// "squeeze"; "facet", "flute", "incise", "trim_foot", "cut_off" (carving.h);
/// "pull_tall", "collapse", "dry_out", "re_wet", "centre", "rib_smooth" (throwing.h).
std::span<const std::string_view> script_names();

/// Problem names the script, the nearest right name, and what is missing (follow without target).
Result<std::unique_ptr<Script>> make_script(std::string_view name, const ScriptContext& context);

}  // namespace onggi
