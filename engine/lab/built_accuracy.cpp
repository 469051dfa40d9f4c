#include "engine/lab/built_accuracy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/lab/plain_beaten.h"
#include "engine/lab/plain_ring.h"
#include "engine/lab/scene_fields.h"
#include "engine/math/portable.h"
#include "engine/scene/scene.h"

namespace onggi::lab {
namespace {

constexpr int kEvenHeights = 400;  // at which faces are compared
constexpr double kRingEnds = 0.1;  // of a ring's height, left out below and above, as in coil_work

bool lays(const BuiltScript& script) { return script.work.def.building.has_value(); }

SceneDef built_scene() {
  SceneDef def = on_a_wall(bare({}));
  def.clay.wall_min = 0.002;
  def.volume.emplace();
  return def;
}

// The same as Scene does: the wheel gathers speed evenly.
double wheel_angle(const SceneDef& def, double speed, double t) {
  const double full_at = speed / def.wheel.acceleration;
  return t < full_at ? 0.5 * def.wheel.acceleration * t * t : speed * (t - 0.5 * full_at);
}

SceneDef on_grid(const BuiltScript& script, const AccuracySetting& setting) {
  SceneDef def = script.work.def;
  def.clay.rows = setting.rows;
  def.clay.sectors = setting.sectors;
  return def;
}

// The blows of a work, as a hand strikes them, each at the tick of 1 ms in which it lands.
std::vector<PlainBlow> blows_of(const SceneWork& work) {
  constexpr double kBlowTick = 1e-3;
  std::vector<PlainBlow> all;
  bool before = false;
  for (long n = 1; n <= std::lround(work.seconds / kBlowTick); ++n) {
    const double t = kBlowTick * static_cast<double>(n);
    const Hands hands = work.hands(t);
    const HandInput& hand = hands.hand[0];
    if (hand.blow && !before)
      all.push_back({hand.position.y,
                     portable::atan2(hand.position.z, hand.position.x) -
                         wheel_angle(work.def, hands.wheel_speed, t),
                     hand.swing, hand.anvil});
    before = hand.blow;
  }
  return all;
}

// The engine's face at even heights, straight between the middles of its rows.
FaceGrid even_face(const Clay& clay, WallSide side, double low, double high) {
  FaceGrid face{kEvenHeights, clay.sectors(), low, (high - low) / (kEvenHeights - 1), 0.0, {}};
  for (int k = 0; k < kEvenHeights; ++k) {
    const double up = low + k * face.thickness;
    const int above = std::clamp(clay.first_row_above(up), 1, clay.rows() - 1);
    const double apart = clay.row_height(above) - clay.row_height(above - 1);
    const double share = std::clamp((up - clay.row_height(above - 1)) / apart, 0.0, 1.0);
    const auto of = [&](int j) {
      return side == WallSide::outside ? clay.outer(j) : clay.inner(j);
    };
    for (std::size_t i = 0; i < of(above).size(); ++i) {
      const auto below = double{of(above - 1)[i]};
      face.radius.push_back(below + share * (double{of(above)[i]} - below));
    }
  }
  return face;
}

// Of the rows above the lump's, m^3.
double volume_above(const Clay& clay, int lump_rows) {
  double sum = 0.0;
  for (int j = lump_rows; j < clay.rows(); ++j) {
    double squares = 0.0;
    for (std::size_t i = 0; i < clay.outer(j).size(); ++i) {
      const auto outer = double{clay.outer(j)[i]}, inner = double{clay.inner(j)[i]};
      squares += (outer - inner) * (outer + inner);
    }
    sum += squares * clay.row_thickness(j) * portable::kPi / clay.sectors();
  }
  return sum;
}

double moved_volume(const std::array<FaceGrid, 2>& faces, const ClayDef& fresh) {
  return displaced(faces[0], fresh.outer_radius) + displaced(faces[1], fresh.inner_radius);
}

// A run of the engine, tick by tick.
class Builder {
 public:
  Builder(const BuiltScript& script, const AccuracySetting& setting)
      : script_(script),
        substeps_(setting.substeps),
        scene_(std::move(*Scene::create(on_grid(script, setting)))) {}

  // True: clay was laid, rose or was struck.
  bool tick(double from, double to) {
    const int rows = scene_.clay().rows();
    bool works = false;
    for (int n = 0; n < substeps_; ++n) {
      const double end = from + (to - from) * (n + 1) / substeps_;
      const Hands hands = script_.work.hands(end);
      const Feedback felt = scene_.step(hands, (to - from) / substeps_);
      const HandInput& hand = hands.hand[0];
      works = works || (hand.coil && felt.hand[0].contact) ||
              (hand.blow && !lay_ && felt.hand[0].blow > 0.0);
      lay_ = hand.blow;
      turned_ = felt.clay_angle - wheel_angle(script_.work.def, hands.wheel_speed, end);
    }
    return works || scene_.clay().rows() != rows;
  }
  std::array<FaceGrid, 2> faces() const {
    std::array<FaceGrid, 2> both{
        even_face(scene_.clay(), WallSide::outside, script_.low, script_.high),
        even_face(scene_.clay(), WallSide::inside, script_.low, script_.high)};
    // In the first tick the wheel may have begun elsewhere.
    for (FaceGrid& face : both) face.turned = turned_;
    return both;
  }
  const Clay& clay() const { return scene_.clay(); }

 private:
  const BuiltScript& script_;
  int substeps_;
  Scene scene_;
  bool lay_ = false;  // the paddle lies on the wall
  double turned_ = 0.0;
};

AccuracyErrors built_errors(const BuiltScript& script, const Builder& built,
                            const BuiltTruth& truth, double& volume) {
  AccuracyErrors out;
  const std::array<FaceGrid, 2> faces = built.faces();
  double squares = 0.0;
  for (std::size_t side = 0; side < faces.size(); ++side) {
    const FaceDifference off = difference(faces[side], truth.face[side]);
    squares += 0.5 * off.rms * off.rms;
    out.shape_max = std::max(out.shape_max, off.most);
  }
  out.shape_rms = std::sqrt(squares);
  volume = lays(script) ? volume_above(built.clay(), built.clay().def().rows)
                        : moved_volume(faces, script.work.def.clay);
  out.volume = std::fabs(volume / truth.volume - 1.0);
  out.force_rms = std::numeric_limits<double>::quiet_NaN();
  return out;
}

}  // namespace

std::vector<BuiltScript> built_scripts() {
  SceneDef coiled = built_scene(), beaten = built_scene();
  coiled.building.emplace().tallest = 0.25;
  beaten.beating.emplace();
  std::vector<BuiltScript> all{
      {"coil", "a hand lays a ring that wanders by 2 mm", coil_work("coil", coiled)},
      {"blows", "eight blows on an anvil, up a turning wall", blow_work("blows", beaten)}};
  const SceneWork& ring = all[0].work;
  const double high = ring.outline_to - ring.outline_from;
  all[0].low = ring.outline_from + kRingEnds * high;
  all[0].high = ring.outline_to - kRingEnds * high;
  all[1].low = 0.2 * beaten.clay.height;
  all[1].high = 0.8 * beaten.clay.height;
  return all;
}

bool is_built(const std::string& name) { return name == "coil" || name == "blows"; }

bool can_work(const BuiltScript& script, const AccuracySetting& setting) {
  return setting.model == AccuracySetting::Model::shipped &&
         validate(on_grid(script, setting)).has_value();
}

BuiltTruth truth_of(const BuiltScript& script, int rows, int sectors) {
  BuiltTruth truth;
  const SceneDef& def = script.work.def;
  constexpr WallSide kSides[] = {WallSide::outside, WallSide::inside};
  if (lays(script)) {
    const PlainRing ring(def.building->coil, script.work.hands, script.work.seconds);
    const double rim = def.clay.height;
    for (const WallSide side : kSides)
      truth.face[side == WallSide::outside ? 0 : 1] =
          ring.face(side, rim, script.low - rim, script.high - rim, kEvenHeights, sectors);
    truth.volume = ring.volume();
    return truth;
  }
  ClayDef grid = def.clay;
  grid.rows = rows;
  grid.sectors = sectors;
  PlainBeaten wall(grid, *def.beating);
  for (const PlainBlow& blow : blows_of(script.work)) wall.strike(blow);
  for (const WallSide side : kSides)
    truth.face[side == WallSide::outside ? 0 : 1] =
        wall.face(side, script.low, script.high, kEvenHeights);
  truth.volume = moved_volume(truth.face, def.clay);
  return truth;
}

AccuracyRow measure_built(const BuiltScript& script, const BuiltTruth& truth,
                          const AccuracySetting& setting, WorkClock clock, int passes) {
  AccuracyRow row;
  row.script = script.name;
  row.setting = setting;
  row.mean_force = row.true_force = row.impulse = std::numeric_limits<double>::quiet_NaN();
  const long ticks = std::lround(script.work.seconds * setting.rate_hz);
  std::vector<double> least(static_cast<std::size_t>(ticks), 1e300);
  std::vector<bool> worked(least.size());
  for (int pass = 0; pass < passes; ++pass) {
    Builder built(script, setting);
    for (std::size_t n = 0; n < least.size(); ++n) {
      const double from = static_cast<double>(n) / setting.rate_hz;
      const double to = static_cast<double>(n + 1) / setting.rate_hz;
      const double begin = clock();
      worked[n] = built.tick(from, to);
      least[n] = std::min(least[n], clock() - begin);
    }
    if (pass == 0) row.errors = built_errors(script, built, truth, row.displaced);
  }
  std::vector<double> times;
  for (std::size_t n = 0; n < least.size(); ++n)
    if (worked[n]) times.push_back(least[n]);
  row.p50 = percentile(times, 0.5);
  row.p999 = percentile(times, 0.999);
  row.worst = percentile(std::move(times), 1.0);
  return row;
}

}  // namespace onggi::lab
