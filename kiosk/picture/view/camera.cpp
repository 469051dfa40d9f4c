#include "kiosk/picture/view/camera.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace onggi::view {
namespace {

constexpr double kNearest = 0.01;  // metres before the eye that still have a pixel
constexpr double kPi = 3.14159265358979323846;

double pixels_per_slope(const Camera& c) { return 0.5 * c.height / std::tan(0.5 * c.fov); }

struct Extent {
  float left = 1e9f, right = -1e9f, top = 1e9f, bottom = -1e9f;
  bool whole = true;
};

constexpr int kAround = 48;

// A ring's points on the unit circle: every frame needs them 60 times to frame the pot.
const std::array<Vec2, kAround>& ring() {
  static const std::array<Vec2, kAround> kRing = [] {
    std::array<Vec2, kAround> points;
    for (int i = 0; i < kAround; ++i) {
      const double a = 2.0 * kPi * i / kAround;
      points[static_cast<std::size_t>(i)] = {std::cos(a), std::sin(a)};
    }
    return points;
  }();
  return kRing;
}

/// A camera's projection with everything that does not depend on the point.
class Projection {
 public:
  explicit Projection(const Camera& c)
      : centre_{c.centre_x, c.centre_y}, pixels_(pixels_per_slope(c)) {
    c.basis(right_, up_, back_);
    eye_ = c.target + back_ * c.distance;
  }
  std::optional<std::pair<float, float>> operator()(Vec3 p) const {
    const Vec3 d = p - eye_;
    const double depth = -dot(d, back_);
    if (depth < kNearest) return std::nullopt;
    return std::pair{static_cast<float>(centre_.x + pixels_ * dot(d, right_) / depth),
                     static_cast<float>(centre_.y - pixels_ * dot(d, up_) / depth)};
  }

 private:
  Vec3 right_, up_, back_, eye_;
  Vec2 centre_;
  double pixels_;
};

// The extent of a standing cylinder's rings on the screen.
Extent extent_of(const Camera& camera, double height, double radius) {
  Extent e;
  const Projection project(camera);
  for (const Vec2 at : ring()) {
    for (const double y : {0.0, height}) {
      const auto p = project({radius * at.x, y, radius * at.y});
      if (!p) {
        e.whole = false;
        return e;
      }
      e.left = std::min(e.left, p->first);
      e.right = std::max(e.right, p->first);
      e.top = std::min(e.top, p->second);
      e.bottom = std::max(e.bottom, p->second);
    }
  }
  return e;
}

// From the eye; not a unit vector.
Vec3 ray_through(const Camera& camera, float px, float py) {
  Vec3 right, up, back;
  camera.basis(right, up, back);
  const double f = pixels_per_slope(camera);
  return right * ((px - camera.centre_x) / f) + up * ((camera.centre_y - py) / f) - back;
}

}  // namespace

Vec3 Camera::eye() const {
  Vec3 right, up, back;
  basis(right, up, back);
  return target + back * distance;
}

void Camera::basis(Vec3& right, Vec3& up, Vec3& back) const {
  const double ce = std::cos(elevation), se = std::sin(elevation);
  const double ca = std::cos(azimuth), sa = std::sin(azimuth);
  back = {sa * ce, se, ca * ce};
  right = {ca, 0.0, -sa};
  up = cross(back, right);
}

std::optional<std::pair<float, float>> Camera::project(Vec3 p) const {
  return Projection(*this)(p);
}

Vec2 Camera::on_axis_plane(float px, float py) const {
  Vec3 right, up, back;
  basis(right, up, back);
  const Vec3 ray = ray_through(*this, px, py);
  // The plane contains the axis and `right`; its normal is level and faces the eye.
  const Vec3 normal = {std::sin(azimuth), 0.0, std::cos(azimuth)};
  const Vec3 from = target + back * distance;
  const double along = dot(ray, normal);
  // A ray parallel to the plane never meets it; it can only come from a camera straight above.
  const double t = along < -1e-9 ? -dot(from, normal) / along : distance;
  const Vec3 hit = from + ray * t;
  return {dot(hit, right), hit.y};
}

std::optional<Vec3> Camera::on_level(float px, float py, double level) const {
  const Vec3 ray = ray_through(*this, px, py), from = eye();
  const double t = (level - from.y) / ray.y;
  return std::isfinite(t) && t > 0.0 ? std::optional(from + ray * t) : std::nullopt;
}

void Camera::matrices(float view[16], float projection[16]) const {
  Vec3 right, up, back;
  basis(right, up, back);
  const Vec3 from = target + back * distance;
  const Vec3 rows[3] = {right, up, back};
  for (int r = 0; r < 3; ++r) {
    view[0 + r] = static_cast<float>(rows[r].x);
    view[4 + r] = static_cast<float>(rows[r].y);
    view[8 + r] = static_cast<float>(rows[r].z);
    view[12 + r] = static_cast<float>(-dot(rows[r], from));
  }
  view[3] = view[7] = view[11] = 0.0f;
  view[15] = 1.0f;

  const double near = std::max(0.02, distance - 1.5), far = distance + 4.0;
  const double f = pixels_per_slope(*this);
  std::fill(projection, projection + 16, 0.0f);
  projection[0] = static_cast<float>(2.0 * f / width);
  projection[5] = static_cast<float>(2.0 * f / height);
  projection[8] = static_cast<float>(1.0 - 2.0 * centre_x / width);
  projection[9] = static_cast<float>(2.0 * centre_y / height - 1.0);
  projection[10] = static_cast<float>(-(far + near) / (far - near));
  projection[11] = -1.0f;
  projection[14] = static_cast<float>(-2.0 * far * near / (far - near));
}

Camera frame_pot(int width, int height, const Rect& box, double pot_height, double pot_radius) {
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.centre_x = box.x + 0.5f * box.w;
  camera.centre_y = box.y + 0.5f * box.h;
  camera.target = {0.0, 0.5 * pot_height, 0.0};

  // The nearest distance at which both rings fit the box: farther is smaller, so bisect.
  double low = 1.2 * pot_radius, high = 200.0 * (pot_height + pot_radius);
  for (int i = 0; i < 60; ++i) {
    camera.distance = 0.5 * (low + high);
    const Extent e = extent_of(camera, pot_height, pot_radius);
    const bool fits = e.whole && e.right - e.left <= box.w && e.bottom - e.top <= box.h;
    (fits ? high : low) = camera.distance;
  }
  camera.distance = high;

  // Perspective lowers the near ring more than it raises the far one, so centre again.
  const Extent e = extent_of(camera, pot_height, pot_radius);
  camera.centre_y += box.y + 0.5f * box.h - 0.5f * (e.top + e.bottom);
  return camera;
}

}  // namespace onggi::view
