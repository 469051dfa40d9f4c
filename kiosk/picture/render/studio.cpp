#include "kiosk/picture/render/studio.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kiosk/picture/view/studio_window.h"

namespace onggi::render {
namespace {

constexpr int kSkySize = 32;   // texels of the sharpest level
constexpr int kSkyLevels = 5;  // roughness 0, 1/4 .. 1
constexpr int kGrainSize = 256;

const glm::vec3 kWindow = glm::normalize(vec(view::window_at(view::kWindowLeft)));

glm::vec3 octahedral(float x, float z) {
  glm::vec3 d(x, 1.0f - std::abs(x) - std::abs(z), z);
  if (d.y < 0) {
    const float fx = (1.0f - std::abs(z)) * (x >= 0 ? 1.0f : -1.0f);
    d.z = (1.0f - std::abs(x)) * (z >= 0 ? 1.0f : -1.0f);
    d.x = fx;
  }
  return glm::normalize(d);
}

struct Ray {
  glm::vec3 direction;
  float solid_angle;
};

// Directions of an octahedral grid. A texel's solid angle comes from the Jacobian of normalising
// (x, 1-|x|-|z|, z): the cube of the normalised vector's 1-norm.
std::vector<Ray> rays(int size) {
  std::vector<Ray> out;
  float sum = 0;
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i) {
      const auto at = [size](int k) {
        return (static_cast<float>(k) + 0.5f) / static_cast<float>(size) * 2.0f - 1.0f;
      };
      const glm::vec3 d = octahedral(at(i), at(j));
      const float one_norm = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
      out.push_back({d, one_norm * one_norm * one_norm});
      sum += out.back().solid_angle;
    }
  }
  for (Ray& r : out) r.solid_angle *= 4.0f * glm::pi<float>() / sum;
  return out;
}

// Uniform fine noise in three octaves, for the grain of clay and the fibres of wood.
Texture make_grain() {
  std::vector<float> sum(kGrainSize * kGrainSize, 0.0f);
  std::uint32_t state = 0x9E3779B9u;
  const auto next = [&state] {
    state = state * 1664525u + 1013904223u;
    return static_cast<float>(state >> 8) / 16777216.0f;
  };
  for (const int cells : {32, 64, 256}) {
    std::vector<float> lattice(static_cast<std::size_t>(cells * cells));
    for (float& v : lattice) v = next();
    for (int y = 0; y < kGrainSize; ++y) {
      for (int x = 0; x < kGrainSize; ++x) {
        const float fx = static_cast<float>(x * cells) / kGrainSize,
                    fy = static_cast<float>(y * cells) / kGrainSize;
        const int x0 = static_cast<int>(fx), y0 = static_cast<int>(fy);
        const auto cell = [&](int cx, int cy) {
          return lattice[static_cast<std::size_t>((cy % cells) * cells + cx % cells)];
        };
        const float tx = fx - static_cast<float>(x0), ty = fy - static_cast<float>(y0);
        const float top = cell(x0, y0) + tx * (cell(x0 + 1, y0) - cell(x0, y0));
        const float low = cell(x0, y0 + 1) + tx * (cell(x0 + 1, y0 + 1) - cell(x0, y0 + 1));
        sum[static_cast<std::size_t>(y * kGrainSize + x)] += (top + ty * (low - top)) / 3.0f;
      }
    }
  }
  std::vector<std::uint8_t> texels(sum.size());
  std::transform(sum.begin(), sum.end(), texels.begin(), [](float v) {
    return static_cast<std::uint8_t>(std::clamp((v - 0.5f) * 1.7f + 0.5f, 0.0f, 1.0f) * 255.0f);
  });
  Texture t =
      Texture::create(GL_R8, kGrainSize, kGrainSize, GL_RED, GL_UNSIGNED_BYTE, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  // Mipmap levels: its finest octave is finer than a pixel and would flicker.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 4);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glGenerateMipmap(GL_TEXTURE_2D);
  return t;
}

Texture make_sky(glm::vec3 (*light)(glm::vec3)) {
  const std::vector<Ray> from = rays(kSkySize);
  std::vector<glm::vec3> radiance;
  for (const Ray& r : from) radiance.push_back(light(r.direction));
  Texture sky = Texture::create(GL_RGB16F, kSkySize, kSkySize, GL_RGB, GL_FLOAT, radiance.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, kSkyLevels - 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  for (int level = 1; level < kSkyLevels; ++level) {
    const int size = kSkySize >> level;
    // A Phong lobe as wide as GGX of this roughness at normal incidence.
    const float rough = static_cast<float>(level) / (kSkyLevels - 1);
    const float power = 2.0f / (rough * rough * rough * rough) - 2.0f;
    std::vector<glm::vec3> blurred;
    for (const Ray& to : rays(size)) {
      glm::vec3 sum(0.0f);
      float weight = 0;
      for (std::size_t i = 0; i < from.size(); ++i) {
        const float cosine = glm::dot(to.direction, from[i].direction);
        if (cosine <= 0) continue;
        const float w = from[i].solid_angle * cosine * std::pow(cosine, power);
        sum += w * radiance[i];
        weight += w;
      }
      blurred.push_back(sum / weight);
    }
    calls::texture_image(level, GL_RGB16F, size, size, GL_RGB, GL_FLOAT, blurred.data());
  }
  return sky;
}

}  // namespace

glm::vec3 window_direction(double window) { return glm::normalize(vec(view::window_at(window))); }

glm::vec3 studio_light(glm::vec3 d) {
  const glm::vec3 wall(0.37f, 0.33f, 0.285f), ceiling(0.52f, 0.51f, 0.50f);
  const glm::vec3 floor(0.29f, 0.225f, 0.17f), far(0.15f, 0.115f, 0.085f);
  const float up = glm::smoothstep(0.0f, 0.8f, d.y), down = glm::smoothstep(0.0f, -0.5f, d.y);
  glm::vec3 light = glm::mix(wall, ceiling, up);
  light = glm::mix(light, floor, down);
  // Away from the window the room is dim and warm; the wall beside the window glows.
  const float away = glm::smoothstep(-0.1f, 1.0f, -glm::dot(d, kWindow));
  light = glm::mix(light, far, 0.75f * away);
  const float near = glm::smoothstep(0.55f, 0.95f, glm::dot(d, kWindow));
  return light + near * glm::vec3(0.42f, 0.44f, 0.46f);
}

std::array<glm::vec3, 9> irradiance_terms(glm::vec3 (*light)(glm::vec3), int size) {
  // Real harmonics' normalisation squared, times the cosine lobe's 1, 2/3, 1/4 (Ramamoorthi and
  // Hanrahan 2001), so that a white sphere of light gives 1.
  std::array<glm::vec3, 9> t{};
  for (const Ray& r : rays(size)) {
    const glm::vec3 d = r.direction, l = light(d) * r.solid_angle / (4.0f * glm::pi<float>());
    t[0] += l;
    t[1] += l * (2.0f * d.y);
    t[2] += l * (2.0f * d.z);
    t[3] += l * (2.0f * d.x);
    t[4] += l * (3.75f * d.x * d.y);
    t[5] += l * (3.75f * d.y * d.z);
    t[6] += l * (0.3125f * (3.0f * d.z * d.z - 1.0f));
    t[7] += l * (3.75f * d.x * d.z);
    t[8] += l * (0.9375f * (d.x * d.x - d.y * d.y));
  }
  return t;
}

Studio::Studio()
    : terms_(irradiance_terms(studio_light, kSkySize)),
      sky_(make_sky(studio_light)),
      grain_(make_grain()) {}

void Studio::light(const Program& program, int unit) const {
  const glm::vec3 window = window_direction(window_);
  const glm::vec3 across = glm::normalize(glm::cross(glm::vec3(0, 1, 0), window));
  const double turned = window_ - view::kWindowLeft;
  program.set("sh[0]", terms_.data(), 9);
  program.set("room_turn", glm::vec2(std::cos(turned), std::sin(turned)));
  program.set("window_dir", window);
  program.set("window_across", across);
  program.set("window_up", glm::cross(window, across));
  program.set("window_light", glm::vec3(0.84f, 0.85f, 0.855f));
  sky_.bind(unit);
  program.set("sky", unit);
}

}  // namespace onggi::render
