#include "kiosk/picture/render/outline.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/scalar_constants.hpp>
#include <optional>

#include "kiosk/picture/render/backdrop.h"
#include "kiosk/picture/render/silhouette.h"

namespace onggi::render {
namespace {

constexpr float kPi = glm::pi<float>();
constexpr int kRimCorners = 96;     // as in the wheel head's mesh
constexpr float kOnHead = 0.0003f;  // m: nearer to the eye than the wheel head's plane
constexpr float kAll = 0.99999f;    // depth of what is drawn at all
constexpr float kNarrow = 4.0f;     // texels: a narrower lip needs a strip
constexpr float kCorner = 1.0f;     // texels: less room in the mouth is none

class Tracer {
 public:
  Tracer(const ClaySurface& clay, const CoatTexture& coat, const WallMesh& wall,
         const view::PotView& pot, const glm::mat4& clip, float texel)
      : clay_(clay),
        coat_(coat),
        wall_(wall),
        pot_(pot),
        clip_(clip),
        frame_(pot.camera.width, pot.camera.height),
        texel_(texel),
        beside_(1.42f * texel),
        size_(static_cast<float>(std::clamp(pot.size, 0.5, 1.0))),
        front_(0.5f * kPi - static_cast<float>(pot.camera.azimuth)),
        open_(0.5f * kPi * static_cast<float>(std::clamp(pot.cut_away, 0.0, 1.0))),
        height_(static_cast<float>(clay.height())) {
    float view[16], projection[16];
    pot.camera.matrices(view, projection);
    of_distance_ = {projection[10], projection[14]};
    pixels_ = 0.5f * projection[5] * frame_.y;
    const glm::vec3 eye = vec(pot.camera.eye()) / size_;
    away_ = std::hypot(eye.x, eye.z);
    eye_y_ = eye.y;
    shoulder_ = height_ - std::min(clay.lip(), 0.5f * height_);
  }

  Ribbons trace() {
    if (pot_.wheel) wheel_head();
    if (!clay_.empty() && height_ > 0.0f) {
      sides();
      foot();
      lip();
      if (open_ > 0.001f) section();
    }
    return std::move(out_);
  }

 private:
  struct Projected {
    glm::vec2 at;
    float metres;
  };
  Projected project(glm::vec3 p) const {
    const glm::vec4 c = clip_ * glm::vec4(p, 1.0f);
    return {(0.5f + 0.5f * glm::vec2(c) / c.w) * frame_, c.w};
  }
  float depth_of(float metres) const {
    return 0.5f + 0.5f * (of_distance_.y / metres - of_distance_.x);
  }
  /// `turned` from the side that faces the eye.
  glm::vec3 place(float turned, float rho, float y) const {
    const float a = front_ + turned;
    return {rho * std::cos(a), y, rho * std::sin(a)};
  }
  EdgePoint clay_at(float turned, float rho, float y, float hides = kHides,
                    float behind = kBehind) const {
    const Projected p = project(size_ * place(turned, rho, y));
    return {p.at, {depth_of(p.metres - hides), depth_of(p.metres + behind), 0.0f}};
  }
  EdgePoint wheel_at(float turned, float rho, float y) const {
    const Projected p = project(place(turned, rho, y));
    return {p.at, {depth_of(p.metres - kHides), kAll, 1.0f}};
  }
  float outer(float turned, float y) const {
    const float share = share_of(turned), up = y / height_;
    return clay_.outer_at(share, up) + coat_.bead_at(share, up);
  }
  float inner(float turned, float y) const { return clay_.inner_at(share_of(turned), y / height_); }
  float share_of(float turned) const {
    return (front_ + turned - static_cast<float>(pot_.clay_angle)) / (2.0f * kPi);
  }
  /// The cut-away has no clay there.
  bool left_out(float turned) const { return turned < 0.0f && turned > -open_; }
  void outline(const std::vector<EdgePoint>& line) {
    add_ribbon(out_.corners, out_.outlines, line, texel_);
  }
  void crease(std::vector<EdgePoint>& line) {
    for (EdgePoint& p : line)
      p.depths = {std::min(beside_, p.most_out), std::min(beside_, p.most_in), p.depths.x};
    add_ribbon(out_.corners, out_.creases, line, texel_);
  }

  void wheel_head();
  void sides();
  void foot();
  struct OfLip;
  OfLip lip_at(float turned, float share, float behind) const;
  bool is_hollow() const { return clay_.inner_at(0.0f, 1.0f) > 0.0f; }
  void lip();
  void section();

  const ClaySurface& clay_;
  const CoatTexture& coat_;
  const WallMesh wall_;
  const view::PotView& pot_;
  const glm::mat4 clip_;
  const glm::vec2 frame_;
  const float texel_;
  const float beside_;  // pixels from a crease where no texel reaches over it, whatever its way
  const float size_, front_, open_, height_;
  glm::vec2 of_distance_{0.0f};  // makes depth of a distance (Camera::matrices)
  float pixels_ = 1;             // in a metre, a metre before the eye
  float away_ = 1, eye_y_ = 0, shoulder_ = 0;
  Ribbons out_;
};

// A disc with a band below. The band turns away from the eye at the same angle all the way down.
void Tracer::wheel_head() {
  const auto radius = static_cast<float>(pot_.wheel_radius);
  const Projected middle = project(glm::vec3(0.0f)), right = project({radius, 0.0f, 0.0f}),
                  near = project({0.0f, 0.0f, radius});
  const glm::mat2 ways(right.at - middle.at, near.at - middle.at);
  if (std::abs(glm::determinant(ways)) < 1.0f) return;  // the eye is level with it
  const float depth = depth_of(middle.metres);
  const glm::vec2 slope =
      glm::vec2(depth_of(right.metres) - depth, depth_of(near.metres) - depth) * glm::inverse(ways);
  out_.head = {slope, depth - glm::dot(slope, middle.at),
               -0.5f * kOnHead * of_distance_.y / (middle.metres * middle.metres)};

  // From a point of the plane, in radii, to a pixel, and back.
  const glm::mat3 pixel_of(
      glm::vec3(right.at * right.metres - middle.at * middle.metres, right.metres - middle.metres),
      glm::vec3(near.at * near.metres - middle.at * middle.metres, near.metres - middle.metres),
      glm::vec3(middle.at * middle.metres, middle.metres));
  const glm::mat3 back = glm::inverse(pixel_of);
  out_.disc = glm::transpose(back) * glm::mat3(1, 0, 0, 0, 1, 0, 0, 0, -1) * back;

  const float tangent = std::acos(std::min(radius / (away_ * size_), 1.0f));
  // From the visitor's left over the near side to the right, and over the far side back. Below the
  // near side is the band.
  std::vector<EdgePoint> low{wheel_at(tangent, radius, 0.0f)}, near_side, far_side;
  for (int i = 0; i <= kRimCorners; ++i) {
    const float t = static_cast<float>(i) / kRimCorners, turned = tangent * (1.0f - 2.0f * t);
    low.push_back(wheel_at(turned, radius, Backdrop::kTable));
    far_side.push_back(wheel_at(-tangent - 2.0f * (kPi - tangent) * t, radius, 0.0f));
    // At its ends lies the plaster below, not the band.
    if (std::abs(turned) < tangent - 0.3f) near_side.push_back(wheel_at(turned, radius, 0.0f));
  }
  low.push_back(wheel_at(-tangent, radius, 0.0f));
  crease(near_side);
  outline(low);
  outline(far_side);
}

// The outermost of the drawn mesh on each line of the picture. Its corners, not the clay's rows,
// say where that is: a row that is out of round or nearly level has no one place where it turns
// away.
void Tracer::sides() {
  struct Corner {
    MeshCorner at;  // its own: angle from the front, height and radius
    bool is_end;    // of the part of the circle that is drawn
  };
  const auto across = static_cast<std::size_t>(wall_.columns) + 1;
  std::vector<Corner> corners;
  corners.reserve(across * (static_cast<std::size_t>(wall_.rows) + 1));
  // What the ribbon covers of the wall is that much nearer than its side.
  const float wide = 1.5f * texel_ * away_ * size_ / pixels_;
  for (int j = 0; j <= wall_.rows; ++j)
    for (int i = 0; i <= wall_.columns; ++i) {
      const float turned = wall_.from - front_ +
                           wall_.span * static_cast<float>(i) / static_cast<float>(wall_.columns);
      const float top = inner(turned, height_), thick = outer(turned, height_) - top;
      const float deep =
          std::min(static_cast<float>(kLipRadius), top > 0.0f ? 0.5f * thick : thick);
      const float y = (height_ - deep) * static_cast<float>(j) / static_cast<float>(wall_.rows);
      const float r = outer(turned, y);
      corners.push_back(
          {{clay_at(turned, r, y, kHides + std::sqrt(2.0f * r * size_ * wide)), {turned, y, r}},
           i == 0 || i == wall_.columns});
    }

  // No side: the lip's, the foot's or the opening's edge.
  Silhouette silhouette(Silhouette::By::lines, frame_);
  const auto take = [&](const Corner& one, const Corner& other, bool is_side) {
    silhouette.take(one.at, other.at, is_side && !(one.is_end && other.is_end));
  };
  for (std::size_t j = 0; j <= static_cast<std::size_t>(wall_.rows); ++j)
    for (std::size_t i = 0; i < across; ++i) {
      const std::size_t at = j * across + i;
      const bool level_side = j > 0 && j < static_cast<std::size_t>(wall_.rows);
      const bool has_next = i + 1 < across, has_above = j < static_cast<std::size_t>(wall_.rows);
      if (has_next) take(corners[at], corners[at + 1], level_side);
      if (has_above) take(corners[at], corners[at + across], true);
      if (has_next && has_above) take(corners[at], corners[at + across + 1], true);
    }

  for (const std::size_t side : {0u, 1u}) {
    std::vector<std::optional<EdgePoint>> edge;
    for (Silhouette::Most& most : silhouette.most()[side]) {
      // Between its corners the mesh lacks the clay's finer grooves. Where the two are far apart,
      // such as in a step, the mesh is what is seen.
      const float more = (outer(most.own.x, most.own.y) - most.own.z) * pixels_ / away_;
      if (std::abs(more) < 0.5f * texel_) most.point.at.x += side == 0 ? -more : more;
      edge.push_back(most.is_side ? std::optional(most.point) : std::nullopt);
    }
    // Where it leaps, what is level there is of the nearer or of the farther part.
    for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
      if (!edge[i] || !edge[i + 1]) continue;
      glm::vec3 &one = edge[i]->depths, &next = edge[i + 1]->depths;
      if (std::abs(edge[i]->at.x - edge[i + 1]->at.x) <= kLeap) continue;
      one.x = next.x = std::min(one.x, next.x);
      one.y = next.y = std::max(one.y, next.y);
    }
    for (const auto& line : lines_through(edge, Silhouette::By::lines, side == 1, AtLeap::joined))
      outline(line);
  }
}

void Tracer::foot() {
  const float r = outer(0.0f, 0.0f);
  const float side = std::acos(std::min(r / away_, 1.0f));
  std::vector<EdgePoint> edge;
  constexpr int kSteps = 48;
  for (int i = kSteps; i >= 0; --i) {
    const float turned = side * (2.0f * static_cast<float>(i) / kSteps - 1.0f);
    if (!left_out(turned)) edge.push_back(clay_at(turned, outer(turned, 0.0f), 0.0f));
  }
  outline(edge);
}

/// The lip where it is seen, at an angle from the middle.
struct Tracer::OfLip {
  EdgePoint out, in;          ///< Its edges towards the outside and the inside.
  float hole = 0, thick = 0;  ///< Of the mouth, m; of the lip in the picture, pixels.
  bool goes_on = false;       ///< The wall goes on below: no outline.
  float cosine = 0;           ///< Of the angle.
};

Tracer::OfLip Tracer::lip_at(float turned, float share, float behind) const {
  const bool hollow = is_hollow();
  const float top = outer(turned, height_) - (hollow ? inner(turned, height_) : 0.0f);
  const float deep = std::min(static_cast<float>(kLipRadius), hollow ? 0.5f * top : top);
  const float wide = outer(turned, height_ - deep),
              hole = hollow ? inner(turned, height_ - deep) : 0.0f;
  const float wall = wide - hole;
  const float edge = std::min(deep, hollow ? 0.5f * wall : wall), base = height_ - deep;
  const auto tilt = [&](float beyond) {
    return std::clamp(std::atan2(beyond, eye_y_ - height_), 0.0f, 0.5f * kPi);
  };
  const float cosine = std::cos(turned);
  const float a = tilt(wide - away_ * cosine), b = tilt(away_ * cosine - hole);
  const float rho_out = wide - edge * (1.0f - std::cos(a)),
              rho_in = hole + edge * (1.0f - std::cos(b));
  const auto along = [&](float rho) {
    return std::acos(std::clamp(1.0f - 2.0f * (wide - rho) / wall, -1.0f, 1.0f)) / kPi;
  };
  OfLip of{clay_at(turned, rho_out, base + deep * std::sin(a)),
           clay_at(turned, rho_in, base + deep * std::sin(b), kHides, behind),
           hole,
           0.0f,
           rho_out >= wide - 1e-6f,
           cosine};
  if (!hollow) return of;
  of.thick = std::max(glm::length(of.out.at - of.in.at), 0.5f);
  const float rows = (LipStrip::kTall - 1) / static_cast<float>(LipStrip::kTall);
  const float from = along(rho_out), to = along(rho_in);
  of.out.strip = {LipStrip::x(share), LipStrip::y(from), rows * (to - from) / of.thick};
  of.in.strip = {LipStrip::x(share), LipStrip::y(to), -of.out.strip.z};
  of.out.most_in = of.in.most_in = 0.5f * of.thick;
  // At the left and right ends of the mouth there is little room inside.
  of.in.most_out = 0.9f * std::abs(of.in.at.y - clay_at(0.5f * kPi, rho_in, height_).at.y);
  return of;
}

void Tracer::lip() {
  const bool hollow = is_hollow();
  const glm::vec2 left = clay_at(0.5f * kPi, outer(0.5f * kPi, height_), height_).at,
                  right = clay_at(-0.5f * kPi, outer(-0.5f * kPi, height_), height_).at;
  const int steps = std::clamp(static_cast<int>(0.35f * glm::length(left - right)), 48, 160);
  // Across the mouth lies what is seen behind the near lip.
  const float behind = std::min(2.0f * kBehind, inner(0.0f, height_));
  // From the middle, or from the cut-away's left side, round to the visitor's left.
  const float span = 2.0f * kPi - open_;
  std::vector<OfLip> round;
  for (int i = 0; i <= steps; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(steps);
    round.push_back(lip_at(span * share, share, behind));
  }
  // All of it has the strip or none: between a point with its place there and one without lie
  // places anywhere in the strip.
  const bool narrow = hollow && std::any_of(round.begin(), round.end(), [this](const OfLip& of) {
                        return of.thick < kNarrow * texel_;
                      });
  std::vector<EdgePoint> out, near_in, far_in, hem;
  std::optional<EdgePoint> on_wall;  // the last point where the wall goes on below the lip
  // The wall meets the lip upright, so that its first bend is seen.
  const auto below = [](EdgePoint p) {
    p.at.y -= 1.5f;
    return p;
  };
  const auto end = [&](std::vector<EdgePoint>& edge, bool reversed, bool is_crease) {
    if (reversed) std::reverse(edge.begin(), edge.end());
    is_crease ? crease(edge) : outline(edge);
    edge.clear();
  };
  for (OfLip& of : round) {
    const bool last = &of == &round.back();
    if (!narrow) of.out.strip = of.in.strip = EdgePoint{}.strip;
    if (hollow) {
      // On the near side the mouth is behind the lip, on the far side the wall goes on below.
      const bool is_near = of.cosine * away_ > of.hole;
      const bool room = of.in.most_out > kCorner * texel_;
      if (room && is_near) near_in.push_back(of.in);
      if (room && !is_near && narrow) far_in.push_back(of.in);
      if (!room || !is_near) end(near_in, false, false);
      if (!room || is_near) end(far_in, false, true);
    }
    // Where the wall goes on below the lip is no outline.
    if (out.empty() && !of.goes_on && on_wall) out = {below(*on_wall), *on_wall};
    if (!out.empty() || !of.goes_on) out.push_back(of.out);
    if (!out.empty() && of.goes_on) out.push_back(below(of.out));
    if (of.goes_on || last) end(out, true, false);
    if (of.goes_on) on_wall = of.out;
    // Near the sides a texel reaches past the clay.
    const bool facing = of.goes_on && of.cosine > 0.5f;
    if (facing) hem.push_back(of.out);
    if (!facing || last) end(hem, true, true);
  }
  end(near_in, false, false);
  end(far_in, false, true);
}

// Where the opening ends: the wall that is left, the floor, and the wall's section.
void Tracer::section() {
  std::vector<EdgePoint> near, far, floor;
  const auto add = [&](float y) {
    near.push_back(clay_at(0.0f, outer(0.0f, y), y));
    far.push_back(clay_at(-open_, outer(-open_, y), y));
  };
  // The rows of the drawn section: between them it has no finer edge.
  const float on_floor = std::min(static_cast<float>(clay_.floor_top()), shoulder_);
  for (const float share : {0.0f, 0.5f}) add(share * on_floor);
  for (int i = 0; i <= wall_.section_rows; ++i)
    add(std::lerp(on_floor, shoulder_,
                  static_cast<float>(i) / static_cast<float>(wall_.section_rows)));
  for (const float share : {1.0f, 0.5f, 0.0f})
    floor.push_back(clay_at(0.0f, share * outer(0.0f, 0.0f), 0.0f));
  for (const float share : {0.5f, 1.0f})
    floor.push_back(clay_at(-open_, share * outer(-open_, 0.0f), 0.0f));
  outline(near);
  outline(floor);
  outline(far);

  // Where the section meets the inside, from the lip down and along the floor to the axis.
  std::vector<EdgePoint> within;
  for (int i = wall_.section_rows; i >= 0; --i) {
    const float y = std::lerp(on_floor, shoulder_,
                              static_cast<float>(i) / static_cast<float>(wall_.section_rows));
    if (inner(-open_, y) <= 0.0f) continue;
    within.push_back(clay_at(-open_, inner(-open_, y), y));
    // Its colour comes from the middle of the wall.
    const glm::vec2 outside = clay_at(-open_, outer(-open_, y), y).at;
    within.back().most_in = 0.5f * glm::length(outside - within.back().at);
  }
  if (!within.empty()) {
    const glm::vec2 below = clay_at(-open_, 0.0f, 0.0f).at;
    within.push_back(clay_at(-open_, 0.0f, on_floor));
    within.back().most_in = 0.5f * glm::length(below - within.back().at);
  }
  crease(within);
}

}  // namespace

Ribbons outline_of(const ClaySurface& clay, const CoatTexture& coat, const WallMesh& wall,
                   const view::PotView& pot, const glm::mat4& clip, float texel) {
  return Tracer(clay, coat, wall, pot, clip, texel).trace();
}

}  // namespace onggi::render
