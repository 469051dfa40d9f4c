#include "kiosk/visit/decorating/touched_place.h"

#include <array>
#include <cmath>

namespace onggi::decorating {

namespace {

constexpr double kTurn = 2.0 * 3.14159265358979323846;

struct Ray {
  Vec3 from, to;  // the eye; one metre before it
};

Ray ray_of(const view::Camera& camera, float x, float y) {
  Vec3 right, up, back;
  camera.basis(right, up, back);
  const double pixels = 0.5 * camera.height / std::tan(0.5 * camera.fov);
  const Vec3 way = right * ((static_cast<double>(x) - camera.centre_x) / pixels) +
                   up * ((camera.centre_y - static_cast<double>(y)) / pixels) - back;
  return {camera.eye(), way};
}

/// Where the ray meets the ring of clay between two rows: how far along it, and the share of the
/// way from the first row to the second.
struct Meeting {
  double far = 0.0, share = 0.0;
};

std::optional<Meeting> meeting(const Ray& ray, const surface::Row& a, const surface::Row& b) {
  // Radius and height are linear in the share s, and so is the ray's height in its length t. With
  // rise = 0 the height gives t, else s(t) goes into rho^2 = r(s)^2.
  const double rise = b.height - a.height, grow = b.radius - a.radius;
  const Vec3 &o = ray.from, &d = ray.to;
  std::optional<Meeting> nearest;
  const auto take = [&](double t, double s) {
    if (t > 0.0 && s >= 0.0 && s <= 1.0 && (!nearest || t < nearest->far)) nearest = {t, s};
  };
  if (std::abs(rise) < 1e-7) {
    if (std::abs(d.y) < 1e-12) return std::nullopt;
    const double t = (a.height - o.y) / d.y;
    const double rho = std::hypot(o.x + t * d.x, o.z + t * d.z);
    if (std::abs(grow) > 1e-9) take(t, (rho - a.radius) / grow);
    return nearest;
  }
  const double k = grow / rise;
  const double r0 = a.radius + k * (o.y - a.height), r1 = k * d.y;  // r = r0 + r1 t
  const double square = d.x * d.x + d.z * d.z - r1 * r1;
  const double half = o.x * d.x + o.z * d.z - r0 * r1;
  const double rest = o.x * o.x + o.z * o.z - r0 * r0;
  const double under = half * half - square * rest;
  if (under < 0.0 || std::abs(square) < 1e-12) return std::nullopt;
  for (const double side : {-1.0, 1.0}) {
    const double t = (-half + side * std::sqrt(under)) / square;
    if (r0 + r1 * t >= 0.0) take(t, (o.y + t * d.y - a.height) / rise);
  }
  return nearest;
}

}  // namespace

std::optional<Place> place_under(const view::Camera& camera, const surface::Surface& surface,
                                 double turned, float x, float y) {
  const Ray ray = ray_of(camera, x, y);
  std::optional<Meeting> nearest;
  int row = 0;
  for (int j = 0; j + 1 < surface.rows(); ++j) {
    const auto met = meeting(ray, surface.row(j), surface.row(j + 1));
    if (met && (!nearest || met->far < nearest->far)) nearest = met, row = j;
  }
  if (!nearest) return std::nullopt;
  const double px = ray.from.x + nearest->far * ray.to.x, pz = ray.from.z + nearest->far * ray.to.z;
  const double angle = std::atan2(pz, px) - turned;
  return Place{1e-6 * surface::kRowHeight * (row + 0.5 + nearest->share),
               angle / kTurn - std::floor(angle / kTurn)};
}

}  // namespace onggi::decorating
