#include "kiosk/picture/render/tool_painter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/contact/tool.h"
#include "kiosk/picture/render/shaders.h"

namespace onggi::render {
namespace {

constexpr float kNowhere = 1e3f;  // m: far away, so nothing fades

// As linear light.
const glm::vec3 kSlip(0.30f, 0.185f, 0.125f), kBoxwood(0.47f, 0.31f, 0.165f),
    kSteel(0.36f, 0.37f, 0.38f), kBrass(0.42f, 0.30f, 0.13f), kSponge(0.66f, 0.45f, 0.19f);

// Metres.
constexpr double kHandle = 0.07, kHandleRadius = 0.0042, kFerrule = 0.016, kFerruleRadius = 0.0022;
constexpr double kPaddleHandle = 0.06;
constexpr double kToggle = 0.03, kToggleRadius = 0.0055;
// Visible length of a finger before it fades into the air, in radii.
constexpr double kFinger = 3.2;

// Sideways for each metre up, of a finger within the pot: by itself, and under a narrow neck.
constexpr float kInsideLean = 0.16f, kMostLeanIn = -1.5f;

struct Material {
  glm::vec3 color;
  float roughness = 0.5f, mirrors = 0.04f, fibre = 0, pores = 0;
  bool soft = false;
};
const Material kFlesh{kSlip, 0.3f, 0.04f, 0, 0, true};
const Material kWood{kBoxwood, 0.42f, 0.04f, 1.0f};
const Material kMetal{kSteel, 0.24f, 0.42f};
const Material kWire{kBrass, 0.30f, 0.35f};
const Material kPorous{kSponge, 0.9f, 0.02f, 0, 1.0f};

/// A mesh under construction. Per vertex: place, normal, and whether it belongs to the far half.
struct Maker {
  std::vector<float> v;
  std::vector<std::uint32_t> t;

  std::uint32_t add(glm::vec3 at, glm::vec3 normal, float far_half = 0) {
    v.insert(v.end(), {at.x, at.y, at.z, normal.x, normal.y, normal.z, far_half});
    return static_cast<std::uint32_t>(v.size() / 7 - 1);
  }
  void face(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    t.insert(t.end(), {a, b, c, a, c, d});
  }
  Mesh mesh(Mesh::Of of = Mesh::Of::triangles) const {
    return Mesh(v.data(), v.size(), t.data(), t.size(), {3, 3, 1}, of);
  }
};

/// A unit sphere about the origin; its upper half counts as the far half.
Mesh capsule() {
  Maker make;
  constexpr std::uint32_t kRound = 32, kDown = 8;  // of each half
  for (std::uint32_t half = 0; half < 2; ++half)
    for (std::uint32_t j = 0; j <= kDown; ++j) {
      const float polar =
          0.5f * glm::pi<float>() * (static_cast<float>(j) / kDown + static_cast<float>(half));
      for (std::uint32_t i = 0; i <= kRound; ++i) {
        const float a = 2 * glm::pi<float>() * static_cast<float>(i) / kRound;
        const glm::vec3 p(std::sin(polar) * std::cos(a), std::cos(polar),
                          std::sin(polar) * std::sin(a));
        make.add(p, p, half == 0 ? 1.0f : 0.0f);
      }
    }
  // One strip from the bands between rings.
  for (std::uint32_t band = 0; band + 1 < 2 * (kDown + 1); ++band) {
    const std::uint32_t upper = band * (kRound + 1), lower = upper + kRound + 1;
    if (band > 0) make.t.insert(make.t.end(), {make.t.back(), lower});
    for (std::uint32_t i = 0; i <= kRound; ++i) make.t.insert(make.t.end(), {lower + i, upper + i});
  }
  return make.mesh(Mesh::Of::strip);
}

Mesh box() {
  Maker make;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 n(0), a(0), b(0);
      n[axis] = side;
      a[(axis + 1) % 3] = side;
      b[(axis + 2) % 3] = 1;
      const std::uint32_t k = make.add(n - a - b, n);
      make.add(n + a - b, n);
      make.add(n + a + b, n);
      make.add(n - a + b, n);
      make.face(k, k + 1, k + 2, k + 3);
    }
  return make.mesh();
}

/// A drum of radius 1 from z = -1 to 1, with a hole of radius `hole` through it.
Mesh drum(float hole) {
  Maker make;
  constexpr int kRound = 96;
  const auto band = [&make](float r0, float z0, glm::vec2 n0, float r1, float z1, glm::vec2 n1) {
    for (int i = 0; i <= kRound; ++i) {
      const float a = 2 * glm::pi<float>() * static_cast<float>(i) / kRound;
      const glm::vec3 d(std::cos(a), std::sin(a), 0), z(0, 0, 1);
      const std::uint32_t k = make.add(r0 * d + z0 * z, n0.x * d + n0.y * z);
      make.add(r1 * d + z1 * z, n1.x * d + n1.y * z);
      if (i < kRound) make.face(k, k + 2, k + 3, k + 1);
    }
  };
  const glm::vec2 out(1, 0), in(-1, 0), front(0, 1), back(0, -1);
  band(1, -1, out, 1, 1, out);
  band(1, 1, front, hole, 1, front);
  if (hole > 0) band(hole, 1, in, hole, -1, in);
  band(hole, -1, back, 1, -1, back);
  return make.mesh();
}

/// Sets the uniforms of one body for the current program.
struct Placer {
  const Program& program;

  void set(const Material& material, glm::vec3 middle, glm::vec3 along, glm::vec3 across,
           glm::vec3 half, float stretch = 0, glm::vec2 fade = {kNowhere, 2 * kNowhere}) const {
    program.set("base_color", material.color);
    program.set("roughness", material.roughness);
    program.set("mirrors", material.mirrors);
    program.set("fibre", material.fibre);
    program.set("pores", material.pores);
    program.set("softly", material.soft ? 1.0f : 0.0f);
    program.set("middle", middle);
    program.set("axis_x", glm::cross(along, across));
    program.set("axis_y", along);
    program.set("axis_z", across);
    program.set("half_size", half);
    program.set("stretch", stretch);
    program.set("fade", fade);
  }
  void rod(const Mesh& capsule, const Material& material, glm::vec3 from, glm::vec3 along,
           glm::vec3 across, double radius, double length,
           glm::vec2 fade = {kNowhere, 2 * kNowhere}) const {
    set(material, from, along, across, glm::vec3(static_cast<float>(radius)),
        static_cast<float>(length), fade);
    capsule.draw();
  }
};

ToolMaterial material_of(const HandView& hand) {
  const ToolShape* const shape = find_tool_shape(hand.name);
  return shape != nullptr ? shape->material : ToolMaterial::skin;
}
bool is_sponge(const HandView& hand) { return material_of(hand) == ToolMaterial::sponge; }
bool is_needle(const HandView& hand) { return material_of(hand) == ToolMaterial::edge; }
bool is_loop(const HandView& hand) {
  const ToolShape* const shape = find_tool_shape(hand.name);
  return shape != nullptr && shape->cuts;
}

}  // namespace

glm::vec3 finger_lean(const HandView& hand, const Levels& levels) {
  const glm::vec3 tip = vec(hand.at);
  const float rho = std::hypot(tip.x, tip.z);
  const glm::vec3 away = rho > 1e-4f ? glm::vec3(tip.x / rho, 0, tip.z / rho) : glm::vec3(1, 0, 0);
  const double level = levels.height / kLevels;
  const auto inner_at = [&](double height) {
    const double t = levels.height > 0 ? std::clamp(height / levels.height, 0.0, 0.999) : 0.0;
    return levels.inner[static_cast<std::size_t>(t * kLevels)];
  };
  if (rho > inner_at(hand.at.y)) return glm::normalize(away + glm::vec3(0, 0.75f, 0));
  // Where the wall closes in above, the finger leans in.
  float out = kInsideLean;
  const auto radius = static_cast<float>(hand.radius);
  const double end = std::min(hand.at.y + kFinger * hand.radius, levels.height);
  for (double y = hand.at.y + hand.radius; level > 0 && y < end; y += level)
    out = std::min(out, (inner_at(y) - radius - rho) / static_cast<float>(y - hand.at.y));
  return glm::normalize(away * std::max(out, kMostLeanIn) + glm::vec3(0, 1, 0));
}

Result<std::unique_ptr<ToolPainter>> ToolPainter::create() {
  std::unique_ptr<ToolPainter> painter(new ToolPainter);
  auto program = Program::create("tool", {k_common_glsl, k_light_glsl, k_tool_glsl});
  if (!program) return tl::unexpected(program.error());
  painter->program_ = std::move(*program);
  painter->capsule_ = capsule();
  painter->box_ = box();
  painter->drum_ = drum(0.13f);  // a rib has a hole for the thumb
  painter->ring_ = drum(0.86f);
  return painter;
}

bool ToolPainter::fades(const HandView& hand) {
  return (hand.body == BodyKind::ball && !is_sponge(hand)) ||
         (hand.body == BodyKind::capsule && !is_needle(hand));
}

double ToolPainter::reach(const HandView& hand) {
  switch (hand.body) {
    case BodyKind::ball:
      return is_sponge(hand) ? hand.radius : (kFinger + 1.0) * hand.radius;
    case BodyKind::capsule:
      return hand.length + (kFinger + 1.0) * hand.radius + (is_needle(hand) ? kHandle : 0.0);
    case BodyKind::box:
      return length(Vec3{hand.radius, 0.5 * hand.length, 0.5 * hand.thickness}) +
             (hand.name == scene::kPaddle ? kPaddleHandle : 0.0);
    case BodyKind::cylinder:
      return hand.radius + hand.thickness + (is_loop(hand) ? kFerrule + kHandle + 0.01 : 0.0);
    case BodyKind::wire:
      return 0.5 * hand.length + kToggle;
  }
  return 0.0;
}

void ToolPainter::draw(const HandView& hand, const Levels& levels, const glm::mat4& clip,
                       const std::function<void(const Program&)>& light) const {
  program_.use();
  light(program_);
  program_.set("clip_from_studio", clip);
  const Placer place{program_};
  const glm::vec3 at = vec(hand.at), along = vec(hand.along), across = vec(hand.across);
  const auto radius = static_cast<float>(hand.radius);
  const glm::vec3 half(radius, 0.5f * static_cast<float>(hand.length),
                       0.5f * static_cast<float>(hand.thickness));
  switch (hand.body) {
    case BodyKind::ball: {
      if (is_sponge(hand)) return place.rod(capsule_, kPorous, at, along, across, radius, 0);
      const glm::vec3 lean = finger_lean(hand, levels);
      const glm::vec3 level = glm::normalize(glm::cross(lean, glm::vec3(0.36f, 0, -0.93f)));
      return place.rod(capsule_, kFlesh, at, lean, level, radius, kFinger * radius,
                       glm::vec2(0.3f, kFinger) * radius);
    }
    case BodyKind::capsule: {
      if (!is_needle(hand)) {
        const auto knuckle = static_cast<float>(hand.length);
        return place.rod(capsule_, kFlesh, at, along, across, radius, knuckle + kFinger * radius,
                         glm::vec2(knuckle, knuckle + static_cast<float>(kFinger) * radius));
      }
      place.rod(capsule_, kMetal, at, along, across, radius, hand.length);
      return place.rod(capsule_, kWood, at + along * static_cast<float>(hand.length), along, across,
                       kHandleRadius, kHandle);
    }
    case BodyKind::box:
      place.set(kWood, at, along, across, half);
      box_.draw();
      if (hand.name == scene::kPaddle)
        place.rod(capsule_, kWood, at + along * half.y, along, across, 0.9 * half.z, kPaddleHandle);
      return;
    case BodyKind::cylinder: {
      const bool loop = is_loop(hand);
      place.set(loop ? kMetal : kWood, at, along, across, {radius, radius, half.z});
      (loop ? ring_ : drum_).draw();
      if (!loop) return;
      const glm::vec3 neck = at + along * radius;
      place.rod(capsule_, kMetal, neck, along, across, kFerruleRadius, kFerrule);
      return place.rod(capsule_, kWood, neck + along * static_cast<float>(kFerrule), along, across,
                       kHandleRadius, kHandle);
    }
    case BodyKind::wire:
      place.rod(capsule_, kWire, at - along * half.y, along, across, radius, hand.length);
      for (const float end : {-1.0f, 1.0f})
        place.rod(capsule_, kWood,
                  at + along * (end * half.y) - across * static_cast<float>(0.5 * kToggle), across,
                  along, kToggleRadius, kToggle);
  }
}

}  // namespace onggi::render
