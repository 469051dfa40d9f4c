#include "kiosk/collection/decoration/unrolled.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/math/portable.h"
#include "kiosk/collection/decoration/decorate.h"
#include "kiosk/collection/textures/srgb.h"

namespace onggi::decoration {

namespace {

using Light = std::array<double, 3>;

constexpr double kGlazeOfColor = 4e-4;  // m: the coat whose colour a file tells

void mix(Light& light, const Light& over, double share) {
  for (std::size_t k = 0; k < 3; ++k) light[k] += share * (over[k] - light[k]);
}
Light light_of(const std::array<float, 3>& color) {
  return {double{color[0]}, double{color[1]}, double{color[2]}};
}

class Fired {
 public:
  Fired(const surface::Surface& surface, const Decoration& decoration)
      : surface_(surface), decoration_(decoration) {}

  Light at(int j, int i) const {
    Light light = light_of(decoration_.body);
    const surface::Strata strata = surface_.slip(j, i);
    for (int k = surface::kStrata - 1; k >= 0; --k) {
      const surface::Stratum stratum = strata.at(k);
      if (stratum.code == 0) continue;
      const Pigment& pigment = decoration_.pigments[static_cast<std::size_t>(stratum.pigment)];
      const double coat = 1e-9 * surface::thickness_of(stratum.code);
      mix(light, light_of(pigment.color), -portable::expm1(-coat / pigment.hides));
    }
    mix(light, light_of(kCarbon), static_cast<double>(surface_.smoke(j, i)) / surface::kMostSmoke);
    if (const int units = surface_.glaze(j, i); units > 0) {
      const double level = 1e-6 * std::max(-surface_.relief(j, i), 0);
      const double glaze = 1e-9 * units * surface::kGlazeUnit + level;
      for (std::size_t k = 0; k < 3; ++k)
        light[k] *= portable::exp(glaze / kGlazeOfColor *
                                  portable::log(std::max(double{decoration_.glaze[k]}, 1e-3)));
    }
    return light;
  }

 private:
  const surface::Surface& surface_;
  const Decoration& decoration_;
};

/// The section's way, from the foot's outer edge over the highest point to the axis.
class Chain {
 public:
  Chain(const Section& section, const surface::Surface& surface) : points_(section.outline) {
    std::size_t foot = 0, top = 0;
    for (std::size_t n = 0; n < points_.size(); ++n)
      if (points_[n].y > points_[top].y) top = n;
    for (std::size_t n = 0; n < top; ++n)
      if (points_[n].y <= 0.0) foot = n;
    way_.resize(points_.size());
    for (std::size_t n = 1; n < points_.size(); ++n)
      way_[n] = way_[n - 1] + length(points_[n] - points_[n - 1]);
    foot_ = way_[foot];
    outside_ = way_[top] - foot_;
    double height = 0.0;
    for (int j = 0; j < surface.rows(); ++j) height = std::max(height, surface.row(j).height);
    const double scale = height / points_[top].y;
    inside_ = way_.back() - way_[top] - surface::kLeastRadius / scale;
    lip_ = static_cast<double>(lip_of(surface)) / (surface.rows() * surface::kRowHeight);
  }

  /// The share of the picture's height at a point of the section.
  double share(Vec2 at) const {
    std::size_t nearest = 0;
    for (std::size_t n = 1; n < points_.size(); ++n)
      if (length(points_[n] - at) < length(points_[nearest] - at)) nearest = n;
    const double way = std::max(way_[nearest] - foot_, 0.0);
    if (way <= outside_) return lip_ * way / outside_;
    return std::min(lip_ + (1.0 - lip_) * (way - outside_) / inside_, 1.0);
  }

 private:
  const std::vector<Vec2>& points_;
  std::vector<double> way_;  // to each point, m
  double foot_ = 0.0, outside_ = 0.0, inside_ = 0.0, lip_ = 0.0;
};

}  // namespace

Unrolled unrolled(const surface::Surface& surface, const Decoration& decoration) {
  Unrolled out{surface::kSectors, surface.rows(), {}};
  out.rgba.reserve(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) * 4);
  const Fired fired(surface, decoration);
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < surface::kSectors; ++i) {
      for (const double light : fired.at(j, i))
        out.rgba.push_back(static_cast<std::uint8_t>(
            std::lround(255.0 * std::clamp(textures::srgb_of_light(light), 0.0, 1.0))));
      out.rgba.push_back(255);
    }
  return out;
}

std::vector<std::uint32_t> close_round(Skin& skin) {
  std::vector<std::uint32_t> doubled;
  std::map<std::uint32_t, std::uint32_t> doubles;
  const auto later = [&](std::uint32_t i) {
    const auto [found, fresh] =
        doubles.try_emplace(i, static_cast<std::uint32_t>(skin.places.size()));
    if (fresh) {
      doubled.push_back(i);
      skin.mesh.positions.push_back(skin.mesh.positions[i]);
      if (!skin.mesh.normals.empty()) skin.mesh.normals.push_back(skin.mesh.normals[i]);
      skin.places.push_back({skin.places[i][0] + 1.0f, skin.places[i][1]});
    }
    return found->second;
  };
  for (auto& triangle : skin.mesh.triangles) {
    float most = 0.0f;
    for (const std::uint32_t i : triangle) most = std::max(most, skin.places[i][0]);
    for (std::uint32_t& i : triangle)
      if (most - skin.places[i][0] > 0.5f) i = later(i);
  }
  return doubled;
}

Skin placed(const TriangleMesh& mesh, const Section& section, const surface::Surface& surface) {
  Skin skin{mesh, {}};
  const Chain chain(section, surface);
  for (const auto& p : mesh.positions) {
    const double x = double{p[0]}, z = double{p[2]};
    const double turns = portable::atan2(z, x) / (2.0 * portable::kPi);
    skin.places.push_back({static_cast<float>(turns < 0.0 ? turns + 1.0 : turns),
                           static_cast<float>(chain.share({std::hypot(x, z), double{p[1]}}))});
  }
  close_round(skin);
  return skin;
}

}  // namespace onggi::decoration
