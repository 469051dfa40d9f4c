#include "kiosk/picture/render/coil_outline.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <vector>

#include "kiosk/picture/render/silhouette.h"

namespace onggi::render {
namespace {

constexpr float kNearEye = 0.01f;      // m: what is nearer has no place in the picture
constexpr float kOnTube = 0.001f;      // m: what is nearer hides the tube,
constexpr float kUnderTube = 0.0005f;  // and what is farther lies behind it
constexpr float kRests = -0.35f;       // of a unit vector: below, the tube is on the rim or near it
constexpr int kCapPoints = 6;          // of a round end

class CoilTracer {
 public:
  CoilTracer(const CoilOnRim& coil, double turned, const view::Camera& camera, float texel)
      : coil_(coil),
        turned_(turned),
        radius_(0.5f * static_cast<float>(coil.diameter)),
        eye_(vec(camera.eye())),
        frame_(camera.width, camera.height),
        texel_(texel) {
    float view[16], projection[16];
    camera.matrices(view, projection);
    clip_ = glm::make_mat4(projection) * glm::make_mat4(view);
    of_distance_ = {projection[10], projection[14]};
    wide_ = 1.5f * texel * static_cast<float>(camera.distance) / (0.5f * projection[5] * frame_.y);
  }

  void trace(Ribbons& ribbons, const CoilRun& run) {
    Line one, other;
    for (std::size_t k = run.first; k <= run.last; ++k) {
      const Side side = side_at(k);
      take(one, side.middle, side.up);
      take(other, side.middle, -side.up);
    }
    if (run.ring) {
      draw(ribbons, one);
      draw(ribbons, other);
      return;
    }
    // All round: along one side, about the end, back along the other, about the beginning.
    if (!run.flat_last) cap(one, run.last, 1.0f);
    one.insert(one.end(), other.rbegin(), other.rend());
    if (!run.flat_first) cap(one, run.first, -1.0f);
    one.push_back(one.front());
    draw(ribbons, one);
  }

 private:
  /// A place's middle; the way in which its tube turns away from the eye, of length 1; and along
  /// it.
  struct Side {
    glm::vec3 middle, up, along;
  };
  Side side_at(std::size_t place) const {
    const float a = angle_of(coil_, place, turned_);
    const glm::vec3 out(std::cos(a), 0, std::sin(a)), along(-out.z, 0, out.x);
    const glm::vec3 middle = coil_.centre[place % coil_.centre.size()] * out +
                             glm::vec3(0, static_cast<float>(coil_.height), 0);
    return {middle, glm::normalize(glm::cross(along, eye_ - middle)), along};
  }
  struct Point {
    EdgePoint edge;
    glm::vec2 middle{0.0f};  // of the tube there, pixels
    bool seen = false;       // against what lies behind, and not where it rests on the rim
  };
  using Line = std::vector<Point>;
  /// `way`: from the tube's middle, of length 1.
  void take(Line& line, glm::vec3 middle, glm::vec3 way) const {
    const glm::vec4 in = clip_ * glm::vec4(middle + radius_ * way, 1.0f),
                    of_middle = clip_ * glm::vec4(middle, 1.0f);
    const auto pixel = [&](const glm::vec4& p) {
      return (0.5f + 0.5f * glm::vec2(p) / p.w) * frame_;
    };
    const auto depth_of = [&](float metres) {
      return 0.5f + 0.5f * (of_distance_.y / metres - of_distance_.x);
    };
    const float nearer = kOnTube + std::sqrt(2.0f * radius_ * wide_);
    Point point;
    point.seen = std::min(in.w, of_middle.w) > kNearEye && way.y > kRests;
    point.edge = {
        pixel(in),
        {depth_of(std::max(in.w - nearer, kNearEye)), depth_of(in.w + kUnderTube), kElsewhere}};
    point.middle = pixel(of_middle);
    line.push_back(point);
  }
  /// Half a circle of the ball at an end: from one side to the other, or (at the beginning) back.
  void cap(Line& line, std::size_t place, float way) const {
    const Side side = side_at(place);
    glm::vec3 beyond = glm::normalize(glm::cross(side.up, eye_ - side.middle));
    if (glm::dot(beyond, side.along) * way < 0.0f) beyond = -beyond;
    for (int n = 1; n < kCapPoints; ++n) {
      const float a = glm::pi<float>() * static_cast<float>(n) / kCapPoints;
      take(line, side.middle, way * std::cos(a) * side.up + std::sin(a) * beyond);
    }
  }
  void draw(Ribbons& ribbons, const Line& line) const {
    std::vector<EdgePoint> piece;
    for (std::size_t n = 0; n < line.size(); ++n) {
      if (line[n].seen) piece.push_back(line[n].edge);
      if (line[n].seen && n + 1 < line.size()) continue;
      if (piece.size() > 1) {
        // The tube must lie left of the way.
        const Point& last = line[line[n].seen ? n : n - 1];
        const glm::vec2 way = last.edge.at - piece[piece.size() - 2].at,
                        in = last.middle - last.edge.at;
        if (way.x * in.y - way.y * in.x < 0.0f) std::reverse(piece.begin(), piece.end());
        add_ribbon(ribbons.corners, ribbons.outlines, piece, texel_);
      }
      piece.clear();
    }
  }

  const CoilOnRim& coil_;
  const double turned_;
  const float radius_;
  const glm::vec3 eye_;
  const glm::vec2 frame_;
  const float texel_;
  glm::mat4 clip_{1.0f};
  glm::vec2 of_distance_{0.0f};
  float wide_ = 0.0f;
};

}  // namespace

void add_coil_outline(Ribbons& ribbons, const CoilOnRim& coil, double turned, Opening opening,
                      const view::Camera& camera, float texel) {
  CoilTracer tracer(coil, turned, camera, texel);
  for (const CoilRun& run : runs_of(coil, turned, opening)) tracer.trace(ribbons, run);
}

}  // namespace onggi::render
