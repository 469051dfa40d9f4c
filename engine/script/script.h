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

/// A scripted potter with the same tools as a visitor. Tests, benchmarks, attract mode and the
/// scripted visitor share the scripts.
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

namespace script {
struct ToolInHand;
}

/// One script: help, documents and errors use this row, and it plans the script.
struct ScriptInfo {
  /// Requirements that make_script() checks.
  struct Needs {
    std::string_view tool = {};  ///< Besides fingers, by name: "flat_rib". Empty: none.
    bool target = false;         ///< ScriptContext::target.
    bool wall = false;           ///< A lump that is open: solid for no more than half its height.
  };
  std::string_view name;
  std::string_view words;  ///< The action of the hands: "narrow a neck".
  Needs needs;
  std::string_view shows;  ///< The effect that it is there to show, by its table's name: "slump".
                           ///< Without it the moves are the same. Empty: none.
  std::unique_ptr<Script> (*plan)(const ScriptContext&, const script::ToolInHand&);
};

/// All scripts. engine/docs/scripts.md lists them in a table.
std::span<const ScriptInfo> scripts();
/// Null if there is no script of that name.
const ScriptInfo* find_script(std::string_view name);
/// Their names, in the same order.
std::span<const std::string_view> script_names();

/// True if `scene` has the effect that `script` shows, and its tool; false if the script shows no
/// effect.
bool shows_its_effect(const ScriptInfo& script, const SceneDef& scene);

/// Problem names the script, the nearest right name, and what is missing (follow without target).
Result<std::unique_ptr<Script>> make_script(std::string_view name, const ScriptContext& context);

}  // namespace onggi
