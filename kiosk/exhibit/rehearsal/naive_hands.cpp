#include "kiosk/exhibit/rehearsal/naive_hands.h"

#include <algorithm>
#include <cmath>

namespace onggi::rehearsal {

using view::InputEvent;

namespace {

// Stroke speed on a screen 1280 wide, pixels a second: careful, usual, hurried.
constexpr double kSpeeds[] = {60, 150, 400};
constexpr double kEase = 0.25;     // s from rest to full speed, and back
constexpr double kTremor = 9.0;    // Hz
constexpr double kReadHint = 1.5;  // s from a hint to the touch of the button that it asks for
constexpr double kNotices = 0.8;   // s until a hand at work follows another hint
constexpr double kEnough = 3.0;    // s until they believe that the wall is good

InputEvent event(InputEvent::Kind kind, double x, double y) {
  InputEvent e;
  e.kind = kind;
  e.x = static_cast<float>(x);
  e.y = static_cast<float>(y);
  return e;
}

}  // namespace

NaiveHands::NaiveHands(std::uint64_t seed, double seconds, Pointer pointer)
    : random_(seed * 0x9e3779b97f4a7c15ULL + 1), pointer_(pointer), seconds_(seconds) {
  side_ = random_.uniform() < 0.8 ? 1.0 : -1.0;
  wait_until_ = random_.uniform(0.5, 2.5);  // People look before the first touch.
}

double NaiveHands::hand_speed() {
  const double u = random_.uniform();
  return kSpeeds[u < 0.3 ? 0 : u < 0.8 ? 1 : 2] * random_.uniform(0.8, 1.25) * scale_;
}

NaiveHands::Point NaiveHands::line_at(const screens::WheelSnapshot& sight, double height) const {
  Vec3 right, up, back;
  sight.camera.basis(right, up, back);
  const double r = side_ * sight.target->outer_at(height);
  const auto at = sight.camera.project({right.x * r, height, right.z * r});
  return at ? Point{at->first, at->second} : Point{};
}

NaiveHands::Point NaiveHands::clay_at(const screens::WheelSnapshot& sight, double height) const {
  Vec3 right, up, back;
  sight.camera.basis(right, up, back);
  const double h = std::min(height, sight.made->height());
  const double r = side_ * sight.made->outer_at(h);
  const auto at = sight.camera.project({right.x * r, h, right.z * r});
  return at ? Point{at->first, at->second} : Point{};
}

void NaiveHands::begin_stroke(std::vector<Point> path, double speed) {
  // Corners are cut: every point moves towards the middle of its neighbours.
  const int passes = speed > 250 * scale_ ? 24 : speed > 100 * scale_ ? 10 : 3;
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
      path[i] = {0.25 * path[i - 1].x + 0.5 * path[i].x + 0.25 * path[i + 1].x,
                 0.25 * path[i - 1].y + 0.5 * path[i].y + 0.25 * path[i + 1].y};
  length_ = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length_ += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
  path_ = std::move(path);
  along_ = 0;
  speed_ = speed;
  down_ = false;
  ++strokes_;
}

void NaiveHands::trace(const screens::WheelSnapshot& sight, double from, double to) {
  std::vector<Point> path;
  constexpr int kPoints = 40;
  // Strokes do not begin or end exactly on the line.
  const double aside = random_.uniform(-4, 4) * scale_;
  for (int i = 0; i <= kPoints; ++i) {
    Point p = line_at(sight, from + (to - from) * i / kPoints);
    path.push_back({p.x + aside * (1.0 - 0.5 * i / kPoints), p.y});
  }
  begin_stroke(std::move(path), hand_speed());
}

/// From the arrow's tail, or from the clay, to the line, and a little along it.
void NaiveHands::push(const screens::WheelSnapshot& sight, double height, bool inward) {
  const Point clay = clay_at(sight, height), line = line_at(sight, height);
  const double out = side_ * (inward ? 1.0 : -1.0);
  std::vector<Point> path{{clay.x + out * random_.uniform(2, 30) * scale_, clay.y}};
  for (int i = 1; i <= 8; ++i)
    path.push_back(
        {path[0].x + (line.x - path[0].x) * i / 8, path[0].y + (line.y - path[0].y) * i / 8});
  const double reach = random_.uniform(-0.25, 0.25) * sight.target->height();
  for (int i = 1; i <= 12; ++i)
    path.push_back(
        line_at(sight, std::clamp(height + reach * i / 12, 0.0, sight.target->height())));
  begin_stroke(std::move(path), hand_speed());
}

void NaiveHands::poke(const screens::WheelSnapshot& sight, double height) {
  const Point clay = clay_at(sight, height);
  const double in = -side_ * random_.uniform(12, 60) * scale_;
  const double up = random_.uniform(-10, 10) * scale_;
  begin_stroke({{clay.x - 0.3 * in, clay.y},
                {clay.x + 0.5 * in, clay.y + 0.5 * up},
                {clay.x + in, clay.y + up},
                {clay.x + 0.4 * in, clay.y + up},
                {clay.x - 0.3 * in, clay.y}},
               hand_speed());
}

void NaiveHands::scrub(const screens::WheelSnapshot& sight, double height) {
  const Point line = line_at(sight, height);
  const double high = random_.uniform(25, 100) * scale_;
  const int turns = 3 + static_cast<int>(random_.uniform(0, 4));
  const double lean = side_ * random_.uniform(-10, 2) * scale_;
  std::vector<Point> path;
  for (int n = 0; n <= turns; ++n) {
    const double to = n % 2 == 0 ? -high : high;
    for (int i = 0; i <= 10; ++i) {
      const double begin = n == 0 ? 0.0 : -to;
      path.push_back(
          {line.x + lean * (n + 0.1 * i) / turns, line.y + begin + (to - begin) * 0.1 * i});
    }
  }
  begin_stroke(std::move(path), hand_speed());
}

/// Holds nearly still on the rim. The wheel does the rest.
void NaiveHands::lay(const screens::WheelSnapshot& sight) {
  if (random_.uniform() < 0.12) side_ = -side_;
  const Point rim = clay_at(sight, sight.made->height());
  const double seconds = random_.uniform(3, 9);
  std::vector<Point> path{
      {rim.x + random_.uniform(-12, 6) * side_ * scale_, rim.y + random_.uniform(-10, 6) * scale_}};
  path.push_back(
      {path[0].x + random_.uniform(-8, 8) * scale_, path[0].y + random_.uniform(-6, 2) * scale_});
  begin_stroke(path, 1.0);
  speed_ = std::max(length_, 1.0) / seconds;
}

/// Up or down the wall, slowly: on the near face of the pot, between its middle and its side.
void NaiveHands::beat(const screens::WheelSnapshot& sight) {
  if (random_.uniform() < 0.12) side_ = -side_;
  const double height = sight.made->height();
  const bool up = random_.uniform() < 0.7;
  double low = random_.uniform(0.0, 0.3), high = low + random_.uniform(0.4, 0.7);
  if (sight.hint.press && random_.uniform() < 0.6) {  // at the arrow
    low = sight.hint.press->height / height - random_.uniform(0.0, 0.15);
    high = sight.hint.press->height / height + random_.uniform(0.0, 0.15);
  }
  const double across = random_.uniform(0.3, 0.95);
  const auto middle = sight.camera.project({0.0, 0.5 * height, 0.0});
  std::vector<Point> path;
  constexpr int kPoints = 12;
  for (int i = 0; i <= kPoints; ++i) {
    const double share = 1.0 * i / kPoints;
    Point p = clay_at(
        sight, std::clamp(low + (up ? share : 1.0 - share) * (high - low), 0.0, 1.0) * height);
    if (middle) p.x = middle->first + across * (p.x - middle->first);
    path.push_back(p);
  }
  begin_stroke(std::move(path), 60 * scale_);
  speed_ = length_ / random_.uniform(5, 14);
}

void NaiveHands::choose(const screens::WheelSnapshot& sight) {
  works_by_.clear();
  const std::string& key = sight.hint.key;
  if (key == "hint.lay_coil" || key == "hint.beat" || key == "hint.wet" || key == "hint.beaten") {
    works_by_ = key;
    changed_since_ = -1;
    return key == "hint.lay_coil" ? lay(sight) : beat(sight);
  }
  const double height = sight.target->height();
  const double u = random_.uniform();
  if (random_.uniform() < 0.12) side_ = -side_;
  // Almost everybody first follows the line.
  if (strokes_ < 2 || u < 0.42) {
    const bool up = random_.uniform() < 0.6;
    const bool whole = strokes_ < 2 || random_.uniform() < 0.5;
    const double low = whole ? random_.uniform(0.0, 0.08) : random_.uniform(0.0, 0.6);
    const double high = whole ? random_.uniform(0.92, 1.0) : low + random_.uniform(0.2, 0.4);
    return trace(sight, (up ? low : high) * height, (up ? high : low) * height);
  }
  const double where = sight.hint.press
                           ? sight.hint.press->height + random_.uniform(-0.06, 0.06) * height
                           : random_.uniform(0.05, 0.95) * height;
  const double at = std::clamp(where, 0.02 * height, 0.98 * height);
  if (u < 0.70) return push(sight, at, sight.hint.press ? sight.hint.press->inward : true);
  if (u < 0.80) return poke(sight, at);
  if (u < 0.92) return scrub(sight, at);
  wait_until_ = last_ + random_.uniform(1.0, 3.0);  // pauses to look
}

NaiveHands::Point NaiveHands::on_path(double along) const {
  double left = along;
  for (std::size_t i = 1; i < path_.size(); ++i) {
    const double piece = std::hypot(path_[i].x - path_[i - 1].x, path_[i].y - path_[i - 1].y);
    if (left <= piece && piece > 0) {
      const double share = left / piece;
      return {path_[i - 1].x + share * (path_[i].x - path_[i - 1].x),
              path_[i - 1].y + share * (path_[i].y - path_[i - 1].y)};
    }
    left -= piece;
  }
  return path_.back();
}

/// A tremor of some tenths of a pixel on top of a slow drift.
NaiveHands::Point NaiveHands::tremble(double dt) {
  const double size = (pointer_ == Pointer::finger ? 1.6 : 0.7) * scale_;
  const double wide = (pointer_ == Pointer::finger ? 5.0 : 2.5) * scale_;
  const double w = 2 * 3.14159265 * kTremor, damping = 0.2 * w;
  const double kick = size * w * std::sqrt(2 * damping * dt) * std::sqrt(3.0);
  const double drift = wide * std::sqrt(2 * dt / 0.8) * std::sqrt(3.0);
  // Semi-implicit, so that steps of a frame stay bounded.
  const auto shake = [&](double& x, double& v) {
    v = (v - w * w * x * dt + kick * random_.uniform(-1, 1)) / (1 + 2 * damping * dt);
    x = std::clamp(x + v * dt, -4 * size, 4 * size);
  };
  shake(shake_.x, shake_speed_.x);
  shake(shake_.y, shake_speed_.y);
  wander_.x += -wander_.x * std::min(1.0, dt / 0.8) + drift * random_.uniform(-1, 1);
  wander_.y += -wander_.y * std::min(1.0, dt / 0.8) + drift * random_.uniform(-1, 1);
  return {shake_.x + wander_.x, shake_.y + wander_.y};
}

/// The button that a hint asks for, some time after it came; empty: none yet.
std::string NaiveHands::asked_for(double now, const screens::WheelSnapshot& sight) {
  const std::string& key = sight.hint.key;
  const bool in = key == "hint.go_inside", good = key == "hint.beaten", wet = key == "hint.wet";
  const bool asks = in || wet || key == "hint.go_outside" || !sight.tool.empty() || good;
  if (!asks || key != asked_key_) {
    asked_since_ = asks ? now : -1;
    asked_key_ = key;
    return {};
  }
  if (now - asked_since_ <= (good ? kEnough : kReadHint) || random_.uniform() >= 0.7) return {};
  asked_since_ = now;
  wait_until_ = now + random_.uniform(0.6, 1.2);  // the way to the button and back
  if (good) return finish();
  if (wet) return "throw.fire";
  if (sight.tool.empty()) return in ? "throw.inside" : "throw.outside";
  tray_open_ = !tray_open_;
  return tray_open_ ? "throw.tools" : sight.tool;
}

std::string NaiveHands::finish() {
  done_ = true;
  return "throw.done";
}

NaiveHands::Move NaiveHands::step(double now, const screens::WheelSnapshot& sight, int width) {
  Move move;
  const double dt = std::clamp(now - last_, 0.0, 0.1);
  last_ = now;
  scale_ = width / 1280.0;
  const Point shake = tremble(std::max(dt, 1e-3));
  if (done_ || sight.target == nullptr || sight.made == nullptr || sight.made->points.empty())
    return move;

  if (path_.empty()) {
    if (now > seconds_) {
      move.control = finish();
      return move;
    }
    if (now < wait_until_) return move;
    move.control = asked_for(now, sight);
    if (!move.control.empty()) return move;
    choose(sight);
    if (path_.empty()) return move;
  }

  if (!works_by_.empty() && sight.hint.key != works_by_) {
    if (changed_since_ < 0) changed_since_ = now;
    if (now - changed_since_ > kNotices) along_ = length_;
  }
  // Slower at both ends, as hands are.
  const double ease =
      std::max(0.15, std::min(1.0, std::min(along_, length_ - along_) / (speed_ * kEase) + 0.15));
  if (down_) along_ += speed_ * ease * dt;
  Point p = on_path(std::min(along_, length_));
  p.x += shake.x;
  p.y += shake.y;
  if (!down_) {
    down_ = true;
    move.events.push_back(event(InputEvent::Kind::pointer_down, p.x, p.y));
    return move;
  }
  move.events.push_back(event(InputEvent::Kind::pointer_move, p.x, p.y));
  if (along_ >= length_) {
    move.events.push_back(event(InputEvent::Kind::pointer_up, p.x, p.y));
    path_.clear();
    const double pause = pointer_ == Pointer::finger ? 0.5 : 0.35;
    wait_until_ = now + pause * random_.uniform(0.5, 3.0);
  }
  return move;
}

}  // namespace onggi::rehearsal
