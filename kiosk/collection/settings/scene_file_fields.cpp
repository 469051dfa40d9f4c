#include "kiosk/collection/settings/scene_file_fields.h"

#include <algorithm>
#include <string_view>
#include <type_traits>

#include "engine/contact/tool.h"
#include "engine/effects/kiln.h"
#include "engine/effects/prints.h"
#include "engine/scene/scene_def.h"

namespace onggi::settings {
namespace {

using fields::Field;
using fields::FieldKind;

/// What a number or switch of a scene does. Its range, unit and default are the engine's.
struct SceneWords {
  std::string_view table, key, words;
  std::string_view range{};  ///< Where another length bounds it.
};

constexpr SceneWords kSceneWords[] = {
    {"clay", "rows", "over the height; rows x sectors: at most 4,194,304 elements"},
    {"clay", "sectors", "round the axis"},
    {"clay", "height", "of the lump"},
    {"clay", "outer_radius",
     "of the lump; more than `inner_radius` + `wall_min`, less than `radius_max`", "m"},
    {"clay", "inner_radius", "of the hole; at least `radius_min`", "m"},
    {"clay", "floor_thickness", "solid clay at the bottom; the whole height: a lump to open",
     "m, 0 to the height"},
    {"clay", "floor_min", "thinnest floor that pressing leaves"},
    {"clay", "wall_min", "thinnest wall; more pressing moves the other side"},
    {"clay", "radius_min", "smallest inner radius above the floor"},
    {"clay", "radius_max", "largest outer radius"},
    {"clay", "keep_undo", "strokes can be taken back; doubles the memory, plus 32 MiB"},
    {"tool", "radius", "of the fingertip"},
    {"contact", "relaxation_time", "how soon clay gives way; higher: stiffer"},
    {"contact", "stiffness",
     "push of the clay, a metre of press and square metre of contact; higher: drier"},
    {"wheel", "max_speed", "fastest for a visitor"},
    {"wheel", "acceleration", "towards a new speed"},
    {"guard", "max_force", "greatest force"},
    {"guard", "max_slew", "fastest change of force"},
    {"guard", "engage_time", "from a hand's arrival to full force"},
    {"moisture", "wetting_time", "sponging until the clay drips"},
    {"moisture", "drying_time", "until about a third of the water is left"},
    {"moisture", "fire_time", "the same while a fire hangs in the pot"},
    {"moisture", "softening", "relaxation time, dripping wet / dry"},
    {"moisture", "weakening", "strength, dripping wet / dry"},
    {"moisture", "air", "how wet the clay stays in the end"},
    {"moisture", "sponge_height", "height of the wetted band; 0: the whole pot"},
    {"walls", "support", "how far along the wall one hand supports it against another"},
    {"walls", "tear_thickness",
     "a thinner wall tears; more than `wall_min`, in a kiosk at most 0.005; 0: never"},
    {"walls", "tear_strain", "a ring wider than in the lump by this share tears; 0: never"},
    {"walls", "bending_strength",
     "how hard a force device may push a thin wall before it bends; for the same clay, 1.73 times "
     "`[slump] yield_stress`; 0: a thin wall feels as hard as a thick one. The old name "
     "`yield_stress` is still read"},
    {"propagation", "reach",
     "a third follows at this distance, nothing at three times; higher: softer lines"},
    {"springback", "share", "this share; higher: leathery"},
    {"springback", "time", "until two thirds of that are back"},
    {"smoothing", "pace", "how fast lines fade; higher: in one turn"},
    {"wobble", "off_centre", "of a fresh lump"},
    {"wobble", "centring_time",
     "until a press of 1 N takes away two thirds of that; higher: a heavier lump"},
    {"wobble", "reach", "how far up and down a hand moves the lump"},
    {"slump", "yield_stress",
     "shear stress that the clay bears; lower: pots must stay low; at least what carries the lump: "
     "2209 for one of 200 mm"},
    {"slump", "viscosity", "of clay that flows; lower: a faster fall"},
    {"slump", "density", "of wet clay"},
    {"slump", "fall", "a pot that sags by this share of its height in a few seconds has fallen"},
    {"building", "coil", "diameter of the coil"},
    {"building", "tallest", "no ring is begun that would end higher; costs memory"},
    {"building", "pace", "a rim that passes faster takes no coil"},
    {"building", "drift", "how far outside the hand a ring comes to lie"},
    {"building", "joint", "strength of a joint as laid / of the wall"},
    {"building", "pinched",
     "0: pinching does not help a joint; 1: a well pinched one is as strong as the wall"},
    {"building", "wetness", "of the coil; wet coils slump"},
    {"beating", "energy", "what a blow spends on the clay; higher: fewer blows"},
    {"beating", "face", "radius of the paddle's face"},
    {"beating", "yield_stress", "stress at which dry clay yields under a blow; lower: softer clay"},
    {"prints", "pitch", "from cord to cord, or from bar to bar"},
    {"prints", "rings", "from ring to ring on the anvil; 0: a smooth anvil"},
    {"prints", "depth", "of the print of a whole blow"},
    {"friction", "coefficient", "of dry clay"},
    {"friction", "wet_factor", "friction, dripping wet / dry"},
    {"friction", "slip_speed", "friction fades in below this slip"},
    {"kiln", "drying_shrinkage", "share of every length lost in drying"},
    {"kiln", "firing_shrinkage", "share of the rest lost in the kiln"},
    {"kiln", "glaze_thickness", "thicker: deeper in colour; 0: bare clay"},
    {"paper", "c_eta", "ticks until clay gives way; below 1 it overshoots"},
    {"paper", "c_v", "push of an element, a metre of press"},
    {"paper", "c_r", "drag of the pot, a metre of the deepest press"},
};

/// What each effect is, as config/README.md says it, and what visitors get by it.
const fields::OptionalTable kEffects[] = {
    {.name = MoistureDef::kName,
     .words = "The sponge wets the clay: it slides, is softer, and dries again.",
     .gives = "Visitors find out how much water clay likes."},
    {.name = WallsDef::kName,
     .words = "Without a second hand a wall moves as a whole: collaring thickens it, opening thins "
              "it. A held wall gets thinner.",
     .gives = "A wall needs a hand on either side, as on a real wheel."},
    {.name = PropagationDef::kName,
     .words = "Pressed clay drags the wall above and below.",
     .gives = "Softer lines: a finger leaves no sharp groove."},
    {.name = SpringbackDef::kName,
     .words = "Part of a press comes back.",
     .gives = "Leathery clay, for hands that know the soft one."},
    {.name = SmoothingDef::kName,
     .words = "Ribs and the sponge even the wall.",
     .gives = "Fingers leave lines, and a tool takes them away."},
    {.name = WobbleDef::kName,
     .words = "A fresh lump beats against the hand until steady pressing centres it.",
     .gives = "Centring, the first thing that potters learn. It takes a visitor a while."},
    {.name = SlumpDef::kName,
     .words = "A pot too weak for its weight sags. A pot that spins too fast spreads.",
     .gives = "Pots can fall: too tall, too wet, too fast. Not for a first pot.",
     .needs = VolumeDef::kName},
    {.name = VolumeDef::kName,
     .words = "No clay is lost. Pulling up makes the wall thinner and the pot taller",
     .gives = "A pot grows by the clay that its wall gives."},
    {.name = BuildingDef::kName,
     .words = "The pot is built of coils that visitors lay on the rim.",
     .gives = "Jars as onggi makers build them, not thrown.",
     .needs = VolumeDef::kName},
    {.name = BeatingDef::kName,
     .words = "The wall is beaten thin between a paddle outside and an anvil inside.",
     .gives = "Paddle and anvil as tools.",
     .needs = VolumeDef::kName},
    {.name = PrintsDef::kName,
     .words = "Paddle and anvil leave their faces in the wall as relief.",
     .gives = "Patterns that are beaten in.",
     .needs = BeatingDef::kName},
    {.name = FrictionDef::kName,
     .words = "The wall drags the hand along.",
     .gives = "A force device pulls the hand with the turning clay."},
    {.name = KilnDef::kName,
     .words = "The pot dries, is fired, shrinks, and gets the chosen glaze.",
     .gives = "A finished pot at the end of the visit."},
};

/// "N/m^3" as the page writes it.
std::string page_unit(std::string unit) {
  for (const auto& [plain, raised] : {std::pair{"^2", "²"}, {"^3", "³"}})
    if (const auto at = unit.find(plain); at != std::string::npos) unit.replace(at, 2, raised);
  return unit;
}

template <class Def, class Value>
Field field_of_def(const DefField<Def, Value>& field) {
  const Def usual{};
  Field out{.table = Def::kName, .key = field.key};
  if constexpr (std::is_same_v<Value, bool>) {
    out.kind = FieldKind::boolean;
    out.usual = usual.*(field.value) ? "true" : "false";
  } else {
    out.kind = std::is_same_v<Value, int> ? FieldKind::whole : FieldKind::number;
    out.least = field.least;
    out.most = field.most;
    out.unit = page_unit(field.unit);
    out.usual = fields::number_words(static_cast<double>(usual.*(field.value)));
  }
  const auto said = std::ranges::find_if(kSceneWords, [&](const SceneWords& words) {
    return words.table == Def::kName && words.key == field.key;
  });
  if (said != std::end(kSceneWords)) {
    out.words = said->words;
    out.range = said->range;
  }
  return out;
}

template <class Def>
void add_def(std::vector<Field>& out) {
  each_field<Def>([&out](const auto& field) { out.push_back(field_of_def(field)); });
}

void add_tools(std::vector<Field>& out) {
  for (const SceneTool& tool : usual_tools()) {
    const ToolShape* shape = find_tool_shape(tool.name);
    if (shape == nullptr) continue;
    const auto size = [&](const char* key, double least, double most, double usual,
                          const char* words) {
      if (usual <= 0.0) return;  // the tool has no such size
      out.push_back({.table = tool.name,
                     .key = key,
                     .kind = FieldKind::number,
                     .words = words,
                     .range = "m, " + fields::number_words(least) + " to " +
                              fields::number_words(most) + "; 0: the usual size",
                     .usual = fields::number_words(usual),
                     .on_page = false});
    };
    size("radius", shape->least.radius, shape->most.radius, shape->usual.radius,
         tool.name == "flat_rib" ? "half of its width" : "its radius");
    size("length", shape->least.length, shape->most.length, shape->usual.length, "its length");
    size("thickness", shape->least.thickness, shape->most.thickness, shape->usual.thickness,
         "its thickness");
  }
}

Field quality() {
  return {.table = "",
          .key = "quality",
          .words = "`\"auto\"`: the machine chooses `rows` and `sectors`; `\"fixed\"`: as written",
          .usual = "\"fixed\"",
          .page = "kiosk/docs/which_grid.md",
          .choices = {"auto", "fixed"},
          .on_page = false};
}

Field to_hand() {
  return {.table = "tool",
          .key = "to_hand",
          .kind = FieldKind::texts,
          .words =
              "the other tools beside the wheel, named as below: `[\"palm\", \"sponge\", "
              "\"wire\"]`",
          .range = "names",
          .usual = "all"};
}

Field body() {
  Field out{.table = KilnDef::kName,
            .key = "body",
            .words =
                "sets both shrinkages: `\"earthenware\"` 10 % in all, `\"stoneware\"` 12.5 %, "
                "`\"porcelain\"` 17 %",
            .usual = "\"stoneware\""};
  for (const ClayBody& clay : clay_bodies()) out.choices.emplace_back(clay.name);
  return out;
}

// A number in the engine, a word in the file.
Field paddle() {
  Field out{.table = PrintsDef::kName,
            .key = "paddle",
            .words = "the paddle's face: plain wood, wound with cord, or cut with a grid",
            .usual = "\"plain\""};
  for (const std::string_view face : paddle_faces()) out.choices.emplace_back(face);
  return out;
}

fields::FieldList all_scene_fields() {
  fields::FieldList list{"scenes/*.toml", {quality()}};
  std::vector<Field>& out = list.fields;
  SceneDef def;
  each_part(def, [&out]<class Def>(Def&) {
    add_def<Def>(out);
    if constexpr (std::is_same_v<Def, ToolDef>) {
      out.push_back(to_hand());
      add_tools(out);
    }
  });
  each_effect(def, [&out]<class Def>(std::optional<Def>&) {
    if constexpr (std::is_same_v<Def, KilnDef>) out.push_back(body());
    add_def<Def>(out);
    if constexpr (std::is_same_v<Def, PrintsDef>)
      *std::ranges::find(out, PrintsDef::kName, &Field::table) = paddle();
  });
  add_def<PaperDef>(out);
  list.tables.assign(std::begin(kEffects), std::end(kEffects));
  return list;
}

}  // namespace

const fields::FieldList& scene_fields() {
  static const fields::FieldList kList = all_scene_fields();
  return kList;
}

}  // namespace onggi::settings
