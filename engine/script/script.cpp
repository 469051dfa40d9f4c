#include "engine/script/script.h"

#include <algorithm>
#include <array>

#include "engine/base/nearest_name.h"
#include "engine/script/beating_up.h"
#include "engine/script/carving.h"
#include "engine/script/coiling.h"
#include "engine/script/demonstrations.h"
#include "engine/script/forming.h"
#include "engine/script/upright.h"

namespace onggi {
namespace {

using namespace script;

// The script of some moves. Each kind of moves has its own play().
template <auto kMoves>
std::unique_ptr<Script> plays(const ScriptContext& context, const ToolInHand& tool) {
  return play(context, tool, *kMoves);
}

constexpr ScriptInfo kScripts[] = {
    // name, words, needs, shows, plan
    {"true", "cut a lump to an even cylinder", {}, "", plays<turn_true>},
    {"collar", "narrow a neck", {}, "", plays<narrow_neck>},
    {"belly", "push a barrel out from inside", {}, "", plays<push_barrel>},
    {"bowl", "flare the wall to the rim", {}, "", plays<flare_wall>},
    {"groove", "hold one fingertip to the wall", {}, "", plays<hold_finger>},
    {"follow", "bring the clay to a vessel's own outline", {.target = true}, "", follow},
    {"open",
     "go down the middle of a lump, out along the floor, up the wall",
     {},
     "",
     plays<open_up>},
    {"press_rim",
     "lay a fingertip on the lip and press the pot lower by a twentieth",
     {},
     "",
     plays<press_lip>},
    {"flare_rim", "draw the lip outwards from within", {.wall = true}, "", plays<flare_lip>},
    {"squeeze",
     "take a third off the wall between a hand outside and one inside, drawing up",
     {.wall = true},
     "",
     plays<squeeze_wall>},
    {"facet",
     "press eight flats with the flat rib, the wheel still",
     {.tool = "flat_rib"},
     "",
     plays<press_flats>},
    {"flute",
     "draw twelve grooves upwards with the loop trimmer, the wheel still",
     {.tool = "loop_trimmer"},
     "",
     plays<draw_grooves>},
    {"incise",
     "wind a line up the wall with the needle, the wheel slow",
     {.tool = "needle"},
     "",
     plays<wind_line>},
    {"trim_foot",
     "turn clay off the foot with the loop trimmer",
     {.tool = "loop_trimmer"},
     "",
     plays<turn_off_foot>},
    {"cut_off", "draw the wire through under the pot", {.tool = "wire"}, "", plays<draw_wire>},
    {"pull_tall",
     "pull the wall up between two hands, four times",
     {},
     "volume",
     plays<pull_four_times>},
    {"collapse",
     "pull it thin, three times, then drown it on a fast wheel until it falls",
     {},
     "slump",
     plays<pull_and_drown>},
    {"dry_out",
     "press when wet, wait, press when drier",
     {},
     "moisture",
     plays<press_wet_and_drier>},
    {"re_wet", "the same, and wet it again", {}, "moisture", plays<press_and_wet_again>},
    {"centre",
     "press steadily until a lump no longer wobbles",
     {},
     "wobble",
     plays<press_steadily>},
    {"rib_smooth",
     "leave a line with a finger, and take it away with the flat rib",
     {.tool = "flat_rib"},
     "smoothing",
     plays<draw_and_even>},
    {"coil_up", "lay five rings of coil on the rim, the wheel slow", {}, "building", lay_rings},
    {"build",
     "build a vessel of rings of coil, and beat it out where the scene beats",
     {.target = true},
     "building",
     build_up},
    {"beat",
     "beat the wall between paddle and anvil, from the foot to the rim",
     {},
     "beating",
     beat_wall},
};

constexpr auto kNames = [] {
  std::array<std::string_view, std::size(kScripts)> names;
  for (std::size_t n = 0; n < names.size(); ++n) names[n] = kScripts[n].name;
  return names;
}();

// Names of the scripts for which `wanted` is true, for a person.
template <class Wanted>
std::string names_of(const Wanted& wanted) {
  std::string all;
  for (const ScriptInfo& script : kScripts)
    if (wanted(script)) all += (all.empty() ? "" : ", ") + std::string(script.name);
  return all;
}

std::string where_of(std::string_view name) { return "script \"" + std::string(name) + "\""; }

tl::unexpected<Problem> no_such(std::string_view name) {
  const std::string nearest = nearest_name(name, kNames);
  return problem(where_of(name), "There is no script of that name.",
                 (nearest.empty() ? "" : "Did you mean \"" + nearest + "\"? ") + "There are " +
                     names_of([](const ScriptInfo&) { return true; }) + ".");
}

// Null if the tool is not to hand.
const SceneTool* tool_of(const ScriptInfo& script, const SceneDef& scene) {
  const auto tool = std::ranges::find(scene.tools, script.needs.tool, &SceneTool::name);
  return scene.paper || tool == scene.tools.end() ? nullptr : &*tool;
}

Result<void> check(const ScriptInfo& script, const ScriptContext& context) {
  const std::string where = where_of(script.name);
  if (!(context.pace >= 0.25 && context.pace <= 4.0))
    return problem(where, "Its pace is outside 0.25 to 4.", "Write a pace from 0.25 to 4.");
  if (auto good = validate(context.scene); !good) return good;
  const ClayDef& clay = context.scene.clay;
  if (script.needs.wall && clay.floor_thickness > 0.5 * clay.height)
    return problem(where, "It works a wall, and this lump is solid for more than half its height.",
                   "Open it first: script \"open\".");
  if (!script.needs.tool.empty() && tool_of(script, context.scene) == nullptr)
    return problem(
        where,
        "It needs the " + std::string(script.needs.tool) + ", which this scene does not have.",
        "Choose a scene that has this tool.");
  if (!script.needs.target) return {};
  if (context.target == nullptr)
    return problem(where, "It follows a vessel's outline, but no vessel is given.",
                   "Choose a vessel, or a script that needs none: " +
                       names_of([](const ScriptInfo& s) { return !s.needs.target; }) + ".");
  return validate(*context.target, where + ", target");
}

}  // namespace

std::span<const ScriptInfo> scripts() { return kScripts; }

const ScriptInfo* find_script(std::string_view name) {
  const auto script = std::ranges::find(kScripts, name, &ScriptInfo::name);
  return script == std::end(kScripts) ? nullptr : script;
}

std::span<const std::string_view> script_names() { return kNames; }

bool shows_its_effect(const ScriptInfo& script, const SceneDef& scene) {
  if (scene.paper || (!script.needs.tool.empty() && tool_of(script, scene) == nullptr))
    return false;
  bool there = false;
  each_effect(scene, [&]<class Def>(const std::optional<Def>& effect) {
    there = there || (effect && script.shows == Def::kName);
  });
  return there;
}

Result<std::unique_ptr<Script>> make_script(std::string_view name, const ScriptContext& context) {
  const ScriptInfo* script = find_script(name);
  if (script == nullptr) return no_such(name);
  if (auto good = check(*script, context); !good) return tl::unexpected<Problem>(good.error());
  script::ToolInHand tool;
  if (const SceneTool* own = tool_of(*script, context.scene))
    tool = {static_cast<std::uint8_t>(own - context.scene.tools.data() + 1),
            sized(*find_tool_shape(own->name), own->size)};
  return script->plan(context, tool);
}

}  // namespace onggi
