#include "engine/scene/hand_state.h"

#include <algorithm>
#include <cmath>

namespace onggi::scene {
namespace {

constexpr double kFarthestHand = 10.0;  // metres per axis: no device reaches farther
// m: smallest tool size for the jump check, which is four sizes a tick
constexpr double kSmallestReach = 0.004;

bool plausible(Vec3 p) {
  return is_finite(p) && std::fabs(p.x) <= kFarthestHand && std::fabs(p.y) <= kFarthestHand &&
         std::fabs(p.z) <= kFarthestHand;
}

bool is_share(double v) { return v >= 0.0 && v <= 1.0; }

}  // namespace

std::vector<Tool> tools_of(const SceneDef& def) {
  std::vector<Tool> tools{{find_tool_shape("sphere"), {def.tool.radius, 0.0, 0.0}}};
  for (const SceneTool& tool : def.tools) {
    const ToolShape* shape = find_tool_shape(tool.name);
    tools.push_back({shape, sized(*shape, tool.size)});
  }
  return tools;
}

void HandState::leave() noexcept {
  present = false;
  rests = used_up = strikes = false;
  struck = 0.0;
  contact.release();
  wire = {};
  guard.release();
  velocity.release();
}

bool HandState::take(const HandInput& in, std::span<const Tool> tools, ToolSweep& sweep) noexcept {
  const bool good = plausible(in.position) && plausible(in.handle) && std::isfinite(in.roll) &&
                    (!in.paddle || (is_share(in.swing) && is_share(in.anvil))) &&
                    in.tool < tools.size();
  if (!good) guard.release();
  if (!good && !present) return false;
  const bool holds_coil = in.coil && !in.paddle;
  if (good && (in.tool != tool || holds_coil != coil || in.paddle != paddle)) {
    leave();
    tool = in.tool;
    coil = holds_coil;
    paddle = in.paddle;
  }
  const Tool& mine = tools[tool];
  const Vec3 to = good ? in.position : at;
  // No hand moves four tool radii in a tick: it was put down elsewhere.
  if (present &&
      length(to - at) > 4.0 * std::max(mine.shape->smallest_feature(mine.size), kSmallestReach))
    leave();
  if (!present) guard.release();
  if (good && !mine.shape->round()) hold_as(in, mine, to);
  sweep.shape = mine.shape;
  sweep.size = mine.size;
  sweep.from = present ? at : to;
  sweep.to = to;
  sweep.along = along;
  sweep.across = across;
  sweep.wish = in.side;
  at = to;
  present = true;
  if (good) {
    swing = paddle ? in.swing : 1.0;
    anvil = paddle ? in.anvil : 0.0;
    // Without energy it is no blow, and no step to take back.
    strikes = paddle && in.blow && !blow && std::max(swing, anvil) > 0.0;
    blow = paddle && in.blow;
    if (!blow || strikes) struck = 0.0;
  }
  return good;
}

void HandState::hold_as(const HandInput& in, const Tool& mine, Vec3 to) noexcept {
  const bool inner = contact.side() == WallSide::inside;
  const bool wished = in.side == SideWish::inside || (in.side == SideWish::by_position && inner);
  const ToolPlace place =
      hold_tool(*mine.shape, to, in.handle, in.roll, contact.touching() ? inner : wished);
  along = place.along;
  across = place.across;
}

void HandState::add_to(StateHash& hash, std::span<const Tool> tools) const {
  const auto add = [&hash](Vec3 v) {
    hash.add(v.x);
    hash.add(v.y);
    hash.add(v.z);
  };
  add(at);
  add(guard.force());
  hash.add(guard.ramp());
  hash.add(std::uint64_t{present} | std::uint64_t{contact.touching()} << 1 |
           std::uint64_t{guard.armed()} << 2 | static_cast<std::uint64_t>(contact.side()) << 3 |
           static_cast<std::uint64_t>(contact.place()) << 4 | std::uint64_t{tool} << 8 |
           std::uint64_t{wire.drawing} << 16 | std::uint64_t{coil} << 17 |
           std::uint64_t{rests} << 18 | std::uint64_t{used_up} << 19 | std::uint64_t{blow} << 20 |
           std::uint64_t{paddle} << 21 | std::uint64_t{anvil > 0.0} << 22);
  // A full swing against a full anvil, or against none, is told by the bits.
  if (swing < 1.0 || (anvil > 0.0 && anvil < 1.0)) {
    hash.add(swing);
    hash.add(anvil);
  }
  if (struck > 0.0) hash.add(struck);
  if (tools[tool].shape->round()) return;  // round tools have no handle
  add(along);
  add(across);
  if (wire.drawing) add(wire.way);
}

// The face on the wall, and the handle up and to the visitor's right, where it hides little.
static HandView seen_paddle(const HandState& hand, const Tool& tool, double face) noexcept {
  constexpr double kThick = 0.008;  // m
  constexpr double kUpright = 1.5;  // up for each way round
  HandView view;
  const double out = length(Vec2{hand.at.x, hand.at.z});
  const Vec3 away = out > 0.0 ? (1.0 / out) * Vec3{hand.at.x, 0.0, hand.at.z} : Vec3{1.0, 0.0, 0.0};
  const bool right = -away.z >= 0.0;
  const Vec3 handle{right ? -away.z : away.z, kUpright, right ? away.x : -away.x};
  view.present = hand.present;
  view.tool = hand.tool;
  view.name = kPaddle;
  view.body = BodyKind::box;
  view.radius = 0.8 * face;
  view.length = 2.0 * face;
  view.thickness = kThick;
  view.along = (1.0 / length(handle)) * handle;
  view.across = away;
  view.at = hand.at + (0.5 * kThick - tool.size.radius) * away;
  return view;
}

HandView seen(const HandState& hand, const Tool& tool, const BeatingDef* beating) noexcept {
  if (hand.paddle && beating != nullptr) return seen_paddle(hand, tool, beating->face);
  HandView view;
  view.present = hand.present;
  view.tool = hand.tool;
  view.name = tool.shape->name;
  view.body = tool.shape->body;
  view.radius = tool.size.radius;
  view.length = tool.size.length;
  view.thickness = tool.size.thickness;
  view.at = hand.at;
  if (tool.shape->round()) return view;  // round tools have no handle
  view.along = hand.along;
  view.across = hand.across;
  return view;
}

}  // namespace onggi::scene
