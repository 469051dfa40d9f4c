#include "engine/script/former.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"
#include "engine/scene/wall_ring.h"

namespace onggi::script {
namespace {

constexpr double kUsualWater = 0.8;     // s of the sponge, every third pass
constexpr double kGoodEnough = 0.0003;  // m: a smaller error is left as it is
constexpr double kDeepest =
    0.007;                        // m: the least that a roughing pass takes, where so much is left
constexpr int kMostPasses = 6;    // of one roughing
constexpr double kOver = 0.0004;  // m: widened beyond the goal, for the outside to cut back
constexpr double kHeldRoom = 0.001;  // m that the holding finger needs beyond itself
constexpr double kTouchSpeed = 0.1;  // m/s, from clear air to the clay

}  // namespace

Former::Former(const SceneDef& scene, Choreography& hand, double haste)
    : scene_(scene), hand_(hand), haste_(haste), radius_(scene.tool.radius) {
  const ClayDef& clay = scene.clay;
  const auto count = static_cast<std::size_t>(std::clamp(clay.height / 0.0005, 64.0, 1000.0));
  spacing_ = clay.height / static_cast<double>(count);
  floor_ = clay.floor_thickness;
  outer_.assign(count, clay.outer_radius);
  inner_.assign(count, clay.inner_radius);
  for (std::size_t n = 0; n < count && height_of(n) < clay.floor_thickness; ++n) inner_[n] = 0.0;
}

void Former::set_goal(std::function<double(double)> outer_at) {
  goal_ = std::move(outer_at);
  aim();
}

void Former::aim() {
  const ClayDef& clay = scene_.clay;
  goal_outer_.resize(outer_.size());
  goal_inner_.resize(outer_.size());
  for (std::size_t n = 0; n < outer_.size(); ++n) {
    goal_outer_[n] =
        std::clamp(goal_(height_of(n)), clay.radius_min + clay.wall_min, clay.radius_max - kOver);
    // A widened wall ends a little too wide.
    const double over = goal_outer_[n] > outer_[n] ? kOver : -kOver;
    const scene::WallRing ring{outer_[n], inner_[n]};
    goal_inner_[n] = over + (scene_.volume ? scene::worked(scene_, ring, goal_outer_[n]).inner
                                           : goal_outer_[n] - clay.wall_min);
  }
}

double Former::area(double outer, double inner, double height) const {
  const double in = height < floor_ ? 0.0 : inner;
  return (outer - in) * (outer + in);
}

// Kept clay gets higher where its ring lost area, and lower where it gained.
void Former::restack(const std::vector<double>& outer_before,
                     const std::vector<double>& inner_before) {
  const std::size_t count = outer_.size();
  std::vector<double> top(count);
  double height = 0.0;
  double floor = 0.0;
  for (std::size_t n = 0; n < count; ++n) {
    const double at = height_of(n);
    height +=
        spacing_ * area(outer_before[n], inner_before[n], at) / area(outer_[n], inner_[n], at);
    top[n] = height;
    if (at < floor_) floor = height;
  }
  const std::vector<double> outer = outer_;
  const std::vector<double> inner = inner_;
  spacing_ = height / static_cast<double>(count);
  floor_ = floor;
  std::size_t from = 0;
  for (std::size_t n = 0; n < count; ++n) {
    while (from + 1 < count && top[from] < height_of(n)) ++from;
    outer_[n] = outer[from];
    inner_[n] = inner[from];
  }
}

// The tool's centre along a face: as near as the sphere gets without cutting below the face.
std::vector<double> Former::centre_path(WallSide side, const std::vector<double>& face) const {
  const int count = static_cast<int>(face.size());
  const int reach = static_cast<int>(radius_ / spacing_);
  std::vector<double> centre(face.size());
  for (int n = 0; n < count; ++n) {
    double best = side == WallSide::outside ? 0.0 : 1.0;
    for (int m = std::max(0, n - reach); m <= std::min(count - 1, n + reach); ++m) {
      const double dy = (m - n) * spacing_;
      const double bulge = std::sqrt(std::max(0.0, (radius_ - dy) * (radius_ + dy)));
      const double at = face[static_cast<std::size_t>(m)];
      best = side == WallSide::outside ? std::max(best, at + bulge) : std::min(best, at - bulge);
    }
    centre[static_cast<std::size_t>(n)] = std::max(best, 0.0);
  }
  return centre;
}

// Distance between an outer tool at `centre` and one that holds the inner face there; 0 if none
// fits.
double Former::room_of(std::size_t n, const std::vector<double>& centre) const {
  if (!holds() || height_of(n) < floor_ + 1.02 * radius_) return 0.0;
  // The sphere's nearest approach to the face.
  const auto reach = static_cast<std::size_t>(radius_ / spacing_);
  double inner = inner_[n];
  for (std::size_t m = n - std::min(n, reach); m < std::min(inner_.size(), n + reach + 1); ++m) {
    const double dy = (static_cast<double>(m) - static_cast<double>(n)) * spacing_;
    const double bulge = std::sqrt(std::max(0.0, (radius_ - dy) * (radius_ + dy)));
    if (height_of(m) > floor_) inner = std::min(inner, inner_[m] - bulge + radius_);
  }
  if (inner < radius_ + kHeldRoom) return 0.0;
  return std::max(centre[n] - radius_ - inner, scene_.clay.wall_min);
}

void Former::pass(WallSide side, const std::vector<double>& face, std::size_t first,
                  std::size_t last, std::string_view phase, double speed) {
  const ClayDef& clay = scene_.clay;
  // The floor stops an inside tool. Outside, a fingertip half sunk to the wheel head reaches the
  // foot.
  const double lowest = side == WallSide::inside ? floor_ + 1.02 * radius_ : 0.1 * radius_;
  std::vector<double> wall = face;
  if (side == WallSide::inside)
    for (std::size_t n = 0; n < wall.size() && height_of(n) < floor_; ++n)
      wall[n] = 1.0;  // floor rows are no wall to keep clear of
  const std::vector<double> centre = centre_path(side, wall);
  const double from = std::max(lowest, height_of(first) - radius_);
  const double to = std::max(from, std::min(height(), height_of(last) + radius_));
  std::vector<Vec2> path;
  std::vector<double> rooms;
  for (std::size_t n = 0; n < centre.size(); ++n) {
    if (height_of(n) < from || height_of(n) > to) continue;
    path.push_back({centre[n], height_of(n)});
    if (side == WallSide::outside) rooms.push_back(room_of(n, centre));
  }
  if (path.empty()) return;

  wet_every_third_pass();
  hand_.phase("carry");
  double clear = 0.0;
  if (side == WallSide::outside) {
    clear = *std::ranges::max_element(outer_) + radius_ + 0.002;
  } else {
    // The farthest from the axis that the pot lets a fingertip down.
    for (std::size_t n = 0; n < inner_.size(); ++n)
      if (height_of(n) > path.front().y - radius_) {
        const double room = inner_[n] - radius_ - 0.002;
        clear = clear == 0.0 ? room : std::min(clear, room);
      }
    clear = std::max(clear, 0.0);
  }
  hand_.carry(side, {clear, path.front().y}, height(), *std::ranges::max_element(outer_), radius_);
  hand_.phase(phase);
  hand_.glide(std::vector<Vec2>{path.front()}, kTouchSpeed);
  hand_.wait_turns(1.0);
  hand_.glide(path, speed * haste_, rooms);
  hand_.wait_turns(1.0);
  hand_.lift();

  // The face that the sphere leaves.
  const std::vector<double> outer_before = outer_;
  const std::vector<double> inner_before = inner_;
  const auto put = [&](std::size_t m, const scene::WallRing& ring) {
    outer_[m] = ring.outer;
    inner_[m] = ring.inner;
  };
  const int reach = static_cast<int>(radius_ / spacing_);
  for (std::size_t n = 0; n < centre.size(); ++n) {
    if (height_of(n) < from || height_of(n) > to) continue;
    for (int step = -reach; step <= reach; ++step) {
      const auto m = static_cast<std::size_t>(static_cast<int>(n) + step);
      if (m >= outer_.size()) continue;
      const double dy = step * spacing_;
      const double bulge = std::sqrt(std::max(0.0, (radius_ - dy) * (radius_ + dy)));
      if (side == WallSide::outside) {
        const double cut = std::max(centre[n] - bulge, clay.radius_min + clay.wall_min);
        if (cut >= outer_[m]) continue;
        if (room_of(n, centre) > 0.0)
          put(m, {cut, std::min(inner_[m], cut - clay.wall_min)});
        else
          put(m, scene::narrowed(scene_, {outer_[m], inner_[m]}, cut));
      } else if (const double cut = centre[n] + bulge; height_of(m) > floor_ && cut > inner_[m]) {
        put(m, scene::widened(scene_, {outer_[m], inner_[m]}, cut));
      }
    }
  }
  if (!scene_.volume) return;
  restack(outer_before, inner_before);
  aim();
}

// Clay that should stand must not get too wet: at wetness w its strength is weakening^w of the dry
// one, and it must bear one and a half times its weight at the foot.
double Former::seconds_of_water() const {
  if (!scene_.slump || !scene_.moisture || scene_.moisture->weakening >= 1.0) return kUsualWater;
  constexpr double kRoot3 = 1.7320508075688772;
  const double weight = scene_.slump->density * 9.81 * height();
  const double share = 1.5 * weight / (kRoot3 * scene_.slump->yield_stress);
  const double most = portable::log(share) / portable::log(scene_.moisture->weakening);
  if (most >= 1.0) return kUsualWater;
  const double dry = 1.0 - wet_;
  if (1.0 - most >= dry) return 0.0;
  return std::min(kUsualWater, scene_.moisture->wetting_time * portable::log(dry / (1.0 - most)));
}

void Former::wet_every_third_pass() {
  if (passes_++ % 3 != 0) return;
  const double seconds = seconds_of_water();
  if (seconds < 0.05) return;  // too short to matter
  if (scene_.moisture)
    wet_ -= (1.0 - wet_) * portable::expm1(-seconds / scene_.moisture->wetting_time);
  hand_.lift();
  hand_.phase("water");
  hand_.water(true);
  hand_.wait(seconds);
  hand_.water(false);
}

void Former::open(std::string_view phase, double speed) {
  double most = 0.0;
  for (std::size_t n = 0; n < inner_.size(); ++n)
    if (height_of(n) > floor_) most = std::max(most, goal_inner_[n] - inner_[n]);
  const double step = std::max(kDeepest, most / kMostPasses);
  for (int k = 0; k < kMostPasses; ++k) {
    std::vector<double> face(inner_.size());
    std::size_t first = inner_.size();
    std::size_t last = 0;
    for (std::size_t n = 0; n < inner_.size(); ++n) {
      face[n] = std::min(goal_inner_[n], inner_[n] + step);
      if (height_of(n) <= floor_ || face[n] - inner_[n] < kGoodEnough) continue;
      first = std::min(first, n);
      last = n;
    }
    if (first > last) return;
    pass(WallSide::inside, face, first, last, phase, speed);
  }
}

void Former::narrow(std::string_view phase, double speed) {
  double most = 0.0;
  for (std::size_t n = 0; n < outer_.size(); ++n) most = std::max(most, outer_[n] - goal_outer_[n]);
  const double step = std::max(kDeepest, most / kMostPasses);
  for (int k = 0; k < kMostPasses; ++k) {
    std::vector<double> face(outer_.size());
    std::size_t first = outer_.size();
    std::size_t last = 0;
    for (std::size_t n = 0; n < outer_.size(); ++n) {
      face[n] = std::max(goal_outer_[n], outer_[n] - step);
      if (outer_[n] - face[n] < kGoodEnough) continue;
      first = std::min(first, n);
      last = n;
    }
    if (first > last) return;
    pass(WallSide::outside, face, first, last, phase, speed);
  }
}

void Former::smooth(WallSide side, std::string_view phase, double speed) {
  pass(side, side == WallSide::outside ? goal_outer_ : goal_inner_, 0, outer_.size() - 1, phase,
       speed);
}

void Former::finish(WallSide side, std::string_view phase, double speed) {
  smooth(side, phase, speed / haste_);
}

void Former::rest() {
  hand_.lift();
  hand_.phase("lift");
  const double widest = *std::ranges::max_element(outer_);
  hand_.carry(WallSide::outside, {widest + 6.0 * radius_, 0.8 * height()}, height(), widest,
              radius_);
  hand_.wheel(3.0);
  hand_.wait(1.5);
}

}  // namespace onggi::script
