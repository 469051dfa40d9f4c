#include "kiosk/visit/screens/pot_picture.h"

#include <algorithm>
#include <cmath>

namespace onggi::screens {

namespace {
constexpr double kBeside = 0.008;  // m

/// One step of an exponential approach with time constant `tau`. It ends when the rest is
/// invisible.
double eased(double from, double to, double dt, double tau) {
  const double next = to + (from - to) * std::exp(-dt / tau);
  return std::abs(next - to) < 2e-5 ? to : next;
}
}  // namespace

void PotPicture::update(const Desk& desk, double dt, const Profile* target, bool cut, bool hold) {
  const bool fresh = serial_ != desk.status.scene_serial;
  const ClayView& clay = desk.world.wheel->clay;
  if (clay.rows() > 0 && (fresh || desk.now - made_at_ > 0.12)) {
    made_ = clay.profile();
    made_at_ = desk.now;
  }

  // Space for the target and for the current width of the clay.
  double height = made_.height(), radius = made_.points.empty() ? 0.0 : made_.max_radius();
  if (target != nullptr && !target->points.empty()) {
    height = std::max(height, target->height());
    radius = std::max(radius, target->max_radius());
  }
  if (fresh || radius_ == 0 || desk.still()) {
    if (!hold || fresh) height_ = height, radius_ = radius;
  } else if (!hold) {
    height_ = eased(height_, height, dt, 0.5);
    radius_ = eased(radius_, std::max(radius, radius_ * 0.97), dt, 0.5);
  }
  // A bat a little wider than pot and lump, as a potter would choose. It stays for the life of the
  // pot.
  if (fresh || wheel_radius_ == 0) wheel_radius_ = std::clamp(1.35 * radius, 0.09, 0.175);
  serial_ = desk.status.scene_serial;

  const double open = cut ? 1.0 : 0.0, there = desk.pot_ready() ? 1.0 : 0.0;
  cut_ = desk.still() ? open : eased(cut_, open, dt, 0.12);
  shown_ = desk.still() ? there : std::clamp(shown_ + (there > 0 ? dt : -dt) / 0.4, 0.0, 1.0);
}

bool PotPicture::on_clay(Vec2 at) const {
  if (made_.points.empty() || at.y < -kBeside || at.y > made_.height() + kBeside) return false;
  return std::abs(at.x) < made_.outer_at(std::clamp(at.y, 0.0, made_.height())) + kBeside;
}

view::Camera PotPicture::camera(const Page& page) const {
  const Regions& where = page.where();
  const std::array<double, 14> of{static_cast<double>(page.width()),
                                  static_cast<double>(page.height()),
                                  where.pot.x,
                                  where.pot.y,
                                  where.pot.w,
                                  where.pot.h,
                                  where.words.x,
                                  where.words.y,
                                  where.words.w,
                                  (where.portrait ? 1.0 : 0.0) + (where.mirrored ? 2.0 : 0.0),
                                  where.all.y + where.all.h,
                                  height_,
                                  radius_,
                                  wheel_radius_};
  if (!framed_ || framed_->of != of) framed_ = Framed{of, frame(page)};
  return framed_->camera;
}

view::Camera PotPicture::frame(const Page& page) const {
  constexpr double kHeadThickness = 0.024;
  constexpr int kAround = 24;
  const double height = std::max(height_, 0.02), radius = std::max(radius_, 0.01);
  const Regions& where = page.where();
  view::Rect box = where.pot;
  const float foot = where.portrait ? where.words.y : where.all.y + where.all.h;
  for (int i = 0;; ++i) {
    const view::Camera camera = view::frame_pot(page.width(), page.height(), box, height, radius);
    const double r = wheel_radius_;
    const auto front = camera.project({0, -kHeadThickness, r});
    float left = 1e9f, right = -1e9f;
    for (int k = 0; k < kAround; ++k) {
      const double a = 2 * 3.14159265358979 * k / kAround;
      const auto at = camera.project({r * std::cos(a), 0, r * std::sin(a)});
      if (!at) return camera;
      left = std::min(left, at->first);
      right = std::max(right, at->first);
    }
    if (!front || i == 24) return camera;
    // The wheel head must be wholly on the screen, and not under the words.
    bool clear = left >= where.all.x && right <= where.all.x + where.all.w;
    if (!where.portrait)
      clear = clear &&
              (where.mirrored ? right <= where.words.x : left >= where.words.x + where.words.w);
    if (clear && front->second <= foot) return camera;
    // Shrink it. In portrait shrink from below, so that the rim keeps its place.
    const float w = box.w * 0.97f, h = box.h * 0.97f;
    box = {box.x + (box.w - w) / 2, where.portrait ? box.y : box.y + (box.h - h) / 2, w, h};
  }
}

void PotPicture::show_round(const Desk& desk, double dt, double speed) {
  if (desk.still()) return;
  constexpr double kSlowing = 20.0;  // rad/s^2: like a wheel's motor
  if (!turn_speed_) turn_speed_ = desk.status.feedback.wheel_speed;
  *turn_speed_ += std::clamp(speed - *turn_speed_, -kSlowing * dt, kSlowing * dt);
  turned_ = std::remainder(turned_ + *turn_speed_ * dt, 2 * 3.14159265358979);
}

view::PotView PotPicture::view(const Desk& desk, const Page& page) const {
  const ClayView& clay = desk.world.wheel->clay;
  view::PotView pot;
  pot.camera = camera(page);
  pot.wheel_angle = desk.status.feedback.wheel_angle + turned_;
  pot.clay_angle = clay.angle + turned_;
  pot.wheel_radius = wheel_radius_;
  pot.window =
      page.where().mirrored && !page.where().portrait ? view::kWindowRight : view::kWindowLeft;
  pot.wetness = desk.status.feedback.wetness;
  pot.wetness_by_row = clay.wet;
  pot.cut_away = cut_ < 0.004 ? 0.0 : cut_;
  pot.opacity = desk.pot_ready() ? shown_ : 0.0;
  if (desk.pot_ready()) pot.hands = desk.status.hand;
  return pot;
}

}  // namespace onggi::screens
