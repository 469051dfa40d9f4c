#include "engine/script/choreography.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"
#include "engine/math/random.h"

namespace onggi::script {
namespace {

constexpr double kCarrySpeed = 0.45;   // m/s, a hand in the air
constexpr double kSwayDepth = 0.0001;  // m, a steady hand's wandering along the radius
constexpr double kSwayPace = 0.08;     // share of its speed
constexpr double kSample = 0.001;      // m between keys of a glide

}  // namespace

Choreography::Choreography(double pace, double most_wheel_speed, std::uint64_t seed)
    : pace_(pace), wheel_pace_(std::min(pace, 1.5)), most_wheel_(most_wheel_speed) {
  Random random(seed);
  for (double& phase : sway_phase_) phase = random.uniform(0.0, 2.0 * portable::kPi);
  now_.phase = "wait";
  now_.place = {0.2, 0.2};
  put();
}

void Choreography::wheel(double speed) {
  now_.wheel_speed = std::min(speed * wheel_pace_, most_wheel_);
}

void Choreography::wait(double seconds) {
  put();
  now_.time += seconds;
  put();
}

void Choreography::wait_turns(double turns) {
  if (now_.wheel_speed > 0.0) wait(turns * 2.0 * portable::kPi / now_.wheel_speed);
}

void Choreography::go(Vec2 place, double speed) {
  put();
  now_.time += length(place - now_.place) / (speed * pace_);
  now_.place = place;
  put();
}

void Choreography::grip(double room, double seconds) {
  now_.active = true;
  if (now_.grip == 0.0) now_.grip = room;
  put();
  now_.time += seconds / pace_;
  now_.place.x += 0.5 * (room - now_.grip);
  now_.grip = room;
  put();
}

void Choreography::raise(double way, double speed) {
  go({now_.place.x, now_.place.y + way}, speed);
}

void Choreography::lift() {
  if (!now_.active) return;
  if (now_.grip > 0.0) {
    grip(now_.grip + 0.008, 0.16);
    now_.active = false;
    now_.grip = 0.0;
    put();
    return;
  }
  const double away = now_.side == WallSide::outside ? 0.004 : -0.004;
  go({std::max(now_.place.x + away, 0.0), now_.place.y}, 0.05);
  now_.active = false;
  put();
}

void Choreography::carry(WallSide side, Vec2 place, double rim, double widest, double radius) {
  lift();
  const double above = rim + 2.0 * radius;
  const double beside = widest + 2.0 * radius;
  if (side == WallSide::inside && now_.side == side) {
    go({place.x, now_.place.y}, kCarrySpeed);  // back down within the pot
  } else if (side != now_.side) {
    // Over the rim, on the free side of the wall.
    if (now_.side == WallSide::outside) go({beside, now_.place.y}, kCarrySpeed);
    go({now_.place.x, above}, kCarrySpeed);
    go({side == WallSide::outside ? beside : place.x, above}, kCarrySpeed);
  } else {
    go({beside, now_.place.y}, kCarrySpeed);
    go({beside, place.y}, kCarrySpeed);
  }
  go({now_.place.x, place.y}, kCarrySpeed);
  now_.side = side;
  go(place, kCarrySpeed);
}

// -1..1: three waves a few centimetres long, by the seed.
double Choreography::sway(double length) const {
  constexpr double kWave[3] = {0.031, 0.053, 0.113};
  double sum = 0.0;
  for (int n = 0; n < 3; ++n)
    sum += portable::sin(2.0 * portable::kPi * length / kWave[n] + sway_phase_[n]);
  return sum / 3.0;
}

void Choreography::glide(std::span<const Vec2> path, double speed, std::span<const double> rooms) {
  now_.active = true;
  put();
  const double begun = now_.time;
  for (std::size_t at = 0; at < path.size(); ++at) {
    const Vec2 corner = path[at];
    if (at < rooms.size()) now_.grip = rooms[at];
    const Vec2 from = now_.place;
    const double way = length(corner - from);
    const int parts = std::max(1, static_cast<int>(std::ceil(way / kSample)));
    for (int n = 1; n <= parts; ++n) {
      const double step = way / parts;
      glided_ += step;
      const double t = static_cast<double>(n) / parts;
      now_.time += step / (speed * pace_ * (1.0 + kSwayPace * sway(0.5 * glided_)));
      now_.place = from + t * (corner - from);
      keys_.push_back(now_);
      keys_.back().place.x = std::max(0.0, now_.place.x + kSwayDepth * sway(glided_));
    }
  }
  glide_time_ += now_.time - begun;
}

std::vector<Key> Choreography::finish() {
  lift();
  put();
  return std::move(keys_);
}

}  // namespace onggi::script
