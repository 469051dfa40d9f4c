#include "kiosk/picture/render/outline.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/scalar_constants.hpp>
#include <optional>

#include "kiosk/picture/render/backdrop.h"
#include "kiosk/picture/render/ribbons.h"

namespace onggi::render {
namespace {

constexpr float kPi = glm::pi<float>();
constexpr int kWheelCorners = 96;   // as in the wheel head's mesh
constexpr float kRowsApart = 3.0f;  // pixels between points of the wall's sides, at least
constexpr int kWallSteps = 128;     // of the wall's strips
constexpr float kEdge = 0.01f;      // of a texel: a strip's outermost middles are drawn

// A little longer than the strip, so that the middles of its ends are drawn.
glm::vec2 strip_at(float share, float row) {
  const float longer = 0.5f + (share - 0.5f) * 1.002f;
  return 2.0f * glm::vec2(Strips::x(longer), Strips::y(row)) - 1.0f;
}

class Tracer {
 public:
  Tracer(const ClaySurface& clay, const view::PotView& pot, const glm::mat4& clip, float wide)
      : clay_(clay),
        pot_(pot),
        clip_(clip),
        frame_(pot.camera.width, pot.camera.height),
        wide_(wide),
        size_(static_cast<float>(std::clamp(pot.size, 0.5, 1.0))),
        front_(0.5f * kPi - static_cast<float>(pot.camera.azimuth)),
        open_(0.5f * kPi * static_cast<float>(std::clamp(pot.cut_away, 0.0, 1.0))),
        height_(static_cast<float>(clay.height())) {
    const glm::vec3 eye = vec(pot.camera.eye()) / size_;
    away_ = std::hypot(eye.x, eye.z);
    eye_y_ = eye.y;
    const float lip = std::min(clay.lip(), 0.5f * height_);
    shoulder_ = height_ - lip;
  }

  Ribbons trace() {
    if (pot_.wheel) wheel_head();
    if (!clay_.empty() && height_ > 0.0f) {
      walls();
      foot();
      lip();
      if (open_ > 0.001f) section();
    }
    return std::move(out_);
  }

 private:
  EdgePoint project(glm::vec3 p) const {
    const glm::vec4 c = clip_ * glm::vec4(p, 1.0f);
    return {(0.5f + 0.5f * glm::vec2(c) / c.w) * frame_, c.w};
  }
  /// `turned` from the side that faces the eye.
  EdgePoint clay_at(float turned, float rho, float y) const {
    const float a = front_ + turned;
    return project(size_ * glm::vec3(rho * std::cos(a), y, rho * std::sin(a)));
  }
  float outer(float turned, float y) const { return clay_.outer_at(share_of(turned), y / height_); }
  float inner(float turned, float y) const { return clay_.inner_at(share_of(turned), y / height_); }
  float share_of(float turned) const {
    return (front_ + turned - static_cast<float>(pot_.clay_angle)) / (2.0f * kPi);
  }
  /// The cut-away has no clay there.
  bool left_out(float turned) const { return turned < 0.0f && turned > -open_; }
  void ribbon(const std::vector<EdgePoint>& line, bool closed = false) {
    add_ribbon(out_, line, closed, wide_);
  }
  float step_of_strip() const { return (Strips::kRows - 1) / (wide_ * Strips::kTall); }
  void corner(glm::vec3 place, float share, float row) {
    out_.strips.push_back({place, strip_at(share, row)});
  }

  void wheel_head();
  void walls();
  void side(float sign);
  void wall_strip(float sign, const std::vector<float>& turned);
  void foot();
  void lip();
  void section();

  const ClaySurface& clay_;
  const view::PotView& pot_;
  const glm::mat4 clip_;
  const glm::vec2 frame_;
  const float wide_, size_, front_, open_, height_;
  float away_ = 1, eye_y_ = 0, shoulder_ = 0;
  Ribbons out_;
};

// A disc with a band below. The band turns away from the eye at the same angle all the way down.
// The disc's turned edge catches the light, so its colours are a strip.
void Tracer::wheel_head() {
  const auto radius = static_cast<float>(pot_.wheel_radius);
  const float tangent = std::acos(std::min(radius / (away_ * size_), 1.0f));
  const auto at = [&](float turned, float rho, float y) {
    const float a = front_ + turned;
    return project({rho * std::cos(a), y, rho * std::sin(a)});
  };
  // From the visitor's left over the near side to the right, and over the far side back. Below the
  // near side is the band.
  std::vector<EdgePoint> near, far;
  // The band begins a little higher, so that no row of pixels is left out between it and the disc.
  const auto band_end = [&](float turned) {
    EdgePoint p = at(turned, radius, 0.0f);
    p.at.y += 2.0f;
    return p;
  };
  std::vector<EdgePoint> low{band_end(tangent)};
  const std::size_t begun = out_.strips.size();
  const int sides = static_cast<int>(std::lround(kWheelCorners * tangent / kPi));
  for (int i = 0; i <= kWheelCorners; ++i) {
    const bool before = i <= sides;
    const float turned =
        before ? tangent * (1.0f - 2.0f * static_cast<float>(i) / static_cast<float>(sides))
               : -tangent - 2.0f * (kPi - tangent) * static_cast<float>(i - sides) /
                                static_cast<float>(kWheelCorners - sides);
    const float share = (tangent - turned) / (2.0f * kPi);
    EdgePoint p = at(turned, radius, 0.0f);
    const glm::vec2 normal = right_of(at(turned - 0.01f, radius, 0.0f).at - p.at);
    constexpr float kInside = 0.02f;
    const float inwards =
        std::abs(glm::dot(p.at - at(turned, (1.0f - kInside) * radius, 0.0f).at, normal));
    const float deep = std::min(kInside * wide_ / std::max(inwards, 1e-3f), 0.9f);
    p.strip = {Strips::x(share), Strips::y(Strips::kWheel), step_of_strip()};
    const float round = (front_ + turned) / (2.0f * kPi);
    corner({round, 1.0f, 0.0f}, share, Strips::kWheel - kEdge);
    corner({round, 1.0f - deep, 0.0f}, share, Strips::kWheel + Strips::kRows - 1 + kEdge);
    if (before) {
      // At its ends lies the plaster below, not the band.
      if (std::abs(turned) < tangent - 0.3f) near.push_back(p);
      low.push_back(at(turned, radius, Backdrop::kTable));
    }
    if (i >= sides) far.push_back(p);
  }
  low.push_back(band_end(-tangent));
  join(out_.wheel, begun, out_.strips.size());
  ribbon(near);
  ribbon(low);
  ribbon(far);
}

void Tracer::walls() {
  side(-1.0f);
  side(1.0f);
}

// Where the wall turns away from the eye, row by row, and of all that the outermost on each line of
// the picture: the bulges between grooves hide the rest. The angle grows to the visitor's left.
void Tracer::side(float sign) {
  const EdgePoint low = clay_at(0.5f * kPi, outer(0.5f * kPi, 0.0f), 0.0f);
  const EdgePoint high = clay_at(0.5f * kPi, outer(0.5f * kPi, shoulder_), shoulder_);
  const int rows = std::clamp(static_cast<int>(glm::length(high.at - low.at)), 16, 600);
  const float step = shoulder_ / static_cast<float>(rows);
  const float strip = sign > 0.0f ? Strips::kLeft : Strips::kRight;
  std::vector<std::optional<EdgePoint>> lines(static_cast<std::size_t>(frame_.y));
  const auto along = [&](const EdgePoint& one, const EdgePoint& other) {
    const EdgePoint& a = one.at.y < other.at.y ? one : other;
    const EdgePoint& b = one.at.y < other.at.y ? other : one;
    const auto top = static_cast<int>(frame_.y) - 1;
    const int from = std::max(static_cast<int>(std::ceil(a.at.y - 0.5f)), 0),
              to = std::min(static_cast<int>(std::floor(b.at.y - 0.5f)), top);
    for (int line = from; line <= to; ++line) {
      const float t = (static_cast<float>(line) + 0.5f - a.at.y) / std::max(b.at.y - a.at.y, 1e-6f);
      const EdgePoint p{glm::mix(a.at, b.at, t), glm::mix(a.metres, b.metres, t),
                        glm::mix(a.strip, b.strip, t)};
      std::optional<EdgePoint>& most = lines[static_cast<std::size_t>(line)];
      if (!most || sign * (most->at.x - p.at.x) > 0.0f) most = p;
    }
  };
  // Rows that face the eye all round have no side, nor have those that it does not see. The side
  // ends between such a row and the next.
  struct Side {
    EdgePoint at;
    bool is = false;
  };
  Side last;
  std::vector<float> turns;
  for (int k = 0; k <= rows; ++k) {
    const float y = step * static_cast<float>(k);
    const float below = std::max(y - step, 0.0f), above = std::min(y + step, shoulder_);
    float turned = turns.empty() ? sign * 0.45f * kPi : turns.back();
    Side here;
    for (int times = 0; times < 2; ++times) {
      const float r = outer(turned, y);
      const float slope = (outer(turned, above) - outer(turned, below)) / (above - below);
      const float cosine = (r + slope * (eye_y_ - y)) / away_;
      here.is = std::abs(cosine) < 1.0f;
      turned = sign * std::acos(std::clamp(cosine, -1.0f, 1.0f));
    }
    here.at = clay_at(turned, outer(turned, y), y);
    here.at.strip = {Strips::x(y / shoulder_), Strips::y(strip), step_of_strip()};
    turns.push_back(turned);
    const bool gone = left_out(turned);
    if (gone) here.is = false;
    if (k > 0 && !gone && (here.is || last.is)) along(here.at, last.at);
    last = here;
  }
  wall_strip(sign, turns);
  std::vector<EdgePoint> edge;
  const auto end = [&] {
    if (sign > 0.0f) std::reverse(edge.begin(), edge.end());
    ribbon(edge);
    edge.clear();
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i]) {
      const bool last_of_all = i + 1 == lines.size() || !lines[i + 1];
      if (edge.empty() || last_of_all || glm::length(lines[i]->at - edge.back().at) >= kRowsApart)
        edge.push_back(*lines[i]);
    } else if (!edge.empty()) {
      end();
    }
  }
  if (!edge.empty()) end();
}

// The wall within a ribbon's width of its side, up the wall. On the screen a point turned by `a`
// from there lies r (1 - cos a) inside.
void Tracer::wall_strip(float sign, const std::vector<float>& turned) {
  const int row = sign > 0.0f ? Strips::kLeft : Strips::kRight;
  const float pixels = 0.5f * frame_.y / std::tan(0.5f * static_cast<float>(pot_.camera.fov));
  constexpr int kAcross = 2;
  std::array<std::vector<StripCorner>, kAcross + 1> lines;
  for (int k = 0; k <= kWallSteps; ++k) {
    const float share = static_cast<float>(k) / kWallSteps, y = share * shoulder_;
    const float at = share * static_cast<float>(turned.size() - 1);
    const auto low = static_cast<std::size_t>(at), up = std::min(low + 1, turned.size() - 1);
    const float side = std::lerp(turned[low], turned[up], at - static_cast<float>(low));
    const float r = outer(side, y);
    const float radius = std::max(size_ * r * pixels / clay_at(side, r, y).metres, 1.0f);
    for (std::size_t i = 0; i <= kAcross; ++i) {
      const float deep = static_cast<float>(i) / kAcross;
      const float a = std::acos(std::max(1.0f - deep * wide_ / radius, 0.0f));
      lines[i].push_back({{(side - sign * a) / (2.0f * kPi), share, 0.0f},
                          strip_at(share, static_cast<float>(row) + deep * (Strips::kRows - 1) +
                                              (i == 0         ? -kEdge
                                               : i == kAcross ? kEdge
                                                              : 0.0f))});
    }
  }
  for (std::size_t i = 0; i < kAcross; ++i) {
    const std::size_t begun = out_.strips.size();
    for (std::size_t k = 0; k < lines[i].size(); ++k) {
      out_.strips.push_back(lines[i][k]);
      out_.strips.push_back(lines[i + 1][k]);
    }
    join(out_.wall, begun, out_.strips.size());
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
  ribbon(edge);
}

void Tracer::lip() {
  const bool hollow = clay_.inner_at(0.0f, 1.0f) > 0.0f;
  std::vector<EdgePoint> out, in;
  std::vector<bool> wall_goes_on;
  const EdgePoint left = clay_at(0.5f * kPi, outer(0.5f * kPi, height_), height_),
                  right = clay_at(-0.5f * kPi, outer(-0.5f * kPi, height_), height_);
  const int steps = std::clamp(static_cast<int>(0.35f * glm::length(left.at - right.at)), 48, 160);
  // From the middle, or from the cut-away's left side, round to the visitor's left.
  const float span = 2.0f * kPi - open_;
  for (int i = 0; i <= steps; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(steps), turned = span * share;
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
    EdgePoint o = clay_at(turned, rho_out, base + deep * std::sin(a));
    EdgePoint n = clay_at(turned, rho_in, base + deep * std::sin(b));
    if (hollow) {
      const float thick = std::max(glm::length(o.at - n.at), 0.5f);
      const float rows = (Strips::kLipRows - 1) / static_cast<float>(Strips::kTall);
      const float from = along(rho_out), to = along(rho_in);
      o.strip = {Strips::x(share), Strips::y(Strips::kLip) + rows * from,
                 rows * (to - from) / thick};
      n.strip = {Strips::x(share), Strips::y(Strips::kLip) + rows * to, -o.strip.z};
      o.narrow = n.narrow = true;
      o.most_in = n.most_in = 0.5f * thick;
    }
    wall_goes_on.push_back(rho_out >= wide - 1e-6f);
    out.push_back(o);
    in.push_back(n);
  }
  // At the left and right ends of the mouth there is little room inside.
  float low = 1e9f, high = -1e9f;
  for (const EdgePoint& p : in) {
    low = std::min(low, p.at.y);
    high = std::max(high, p.at.y);
  }
  for (EdgePoint& p : in) p.most_out = 0.9f * std::abs(p.at.y - 0.5f * (low + high));
  if (hollow) ribbon(in);
  // Where the wall goes on below the lip is no edge.
  std::vector<EdgePoint> edge;
  for (std::size_t i = out.size(); i-- > 0;) {
    if (!wall_goes_on[i]) edge.push_back(out[i]);
    if (wall_goes_on[i] || i == 0) {
      ribbon(edge);
      edge.clear();
    }
  }
}

// Where the wall ends before the opening. The section itself is narrow and has a line of ink at its
// edges, which the picture draws.
void Tracer::section() {
  constexpr int kSteps = 160;
  std::vector<EdgePoint> edge;
  for (int i = 0; i <= kSteps; ++i) {
    const float y = shoulder_ * static_cast<float>(i) / kSteps;
    edge.push_back(clay_at(0.0f, outer(0.0f, y), y));
  }
  ribbon(edge);
}

}  // namespace

float Strips::x(float share) { return (0.5f + share * (kWide - 1)) / kWide; }

Ribbons outline_of(const ClaySurface& clay, const view::PotView& pot, const glm::mat4& clip,
                   float wide) {
  return Tracer(clay, pot, clip, wide).trace();
}

}  // namespace onggi::render
