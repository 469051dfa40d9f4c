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

/// A scripted potter with a visitor's tools, for tests, benchmarks, attract mode and the scripted
/// visitor.
class Script {
 public:
  virtual ~Script() = default;
  /// The hands `t` seconds after the script began; t must not fall. No allocation, no throw: it
  /// runs on the 1 kHz thread.
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

/// One script: its row for help, documents and errors, and its planner.
struct ScriptInfo {
  /// Requirements that make_script() checks.
  struct Needs {
    std::string_view tool = {};  ///< By name, besides fingers: "flat_rib". Empty: none.
    bool target = false;         ///< ScriptContext::target.
    bool wall = false;           ///< The lump must be open: solid for at most half its height.
  };
  std::string_view name;
  std::string_view words;  ///< The action of the hands: "narrow a neck".
  Needs needs;
  std::string_view shows;  ///< The effect that it shows, by its table's name: "slump". Without the
                           ///< effect the moves are the same. Empty: none.
  std::unique_ptr<Script> (*plan)(const ScriptContext&, const script::ToolInHand&);
};

/// All scripts. engine/docs/scripts.md lists them in a table.
std::span<const ScriptInfo> scripts();
/// Null if there is no script of that name.
const ScriptInfo* find_script(std::string_view name);
/// Their names, in the same order.
std::span<const std::string_view> script_names();

/// True if `scene` has the effect that `script` shows, and its tool; false if the script shows
/// none.
bool shows_its_effect(const ScriptInfo& script, const SceneDef& scene);

/// Problem: the script, the nearest right name, and what is missing (follow without target).
Result<std::unique_ptr<Script>> make_script(std::string_view name, const ScriptContext& context);

}  // namespace onggi
