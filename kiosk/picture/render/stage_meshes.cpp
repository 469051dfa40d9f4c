#include "kiosk/picture/render/stage_meshes.h"

#include <cmath>
#include <utility>
#include <vector>

namespace onggi::render {

Mesh section_mesh(int rows) {
  constexpr int kFloor = 2, kAcross = 12;
  std::vector<float> places;
  std::vector<std::uint32_t> indices;
  const auto add = [&places](float across, float up) {
    places.insert(places.end(), {across, up});
    return static_cast<std::uint32_t>(places.size() / 2 - 1);
  };
  const auto rise = [&](float from, float to, int steps) {
    std::uint32_t left = add(0, from), right = add(1, from);
    for (int i = 1; i <= steps; ++i) {
      const float up = from + (to - from) * static_cast<float>(i) / static_cast<float>(steps);
      const std::uint32_t next = add(0, up), beside = add(1, up);
      indices.insert(indices.end(), {left, right, beside, left, beside, next});
      left = next;
      right = beside;
    }
    return std::pair(left, right);
  };
  rise(-1.0f, -0.0001f, kFloor);
  const auto [left, right] =
      rise(0.0f, static_cast<float>(rows - 1) / static_cast<float>(rows), rows - 1);
  std::uint32_t before = add(0, 1);
  for (int i = 1; i <= kAcross; ++i) {
    const std::uint32_t next = add(static_cast<float>(i) / kAcross, 1);
    const std::uint32_t low = 2 * i <= kAcross ? left : right;
    indices.insert(indices.end(), {before, low, next});
    if (2 * i == kAcross) indices.insert(indices.end(), {next, left, right});
    before = next;
  }
  return Mesh(places.data(), places.size(), indices.data(), indices.size(), {2});
}

Mesh wheel_head_mesh(std::uint32_t corners) {
  std::vector<float> places;
  for (const float lower : {-1.0f, 0.0f, 1.0f})
    for (std::uint32_t i = 0; i <= corners; ++i)
      places.insert(places.end(), {static_cast<float>(i) / static_cast<float>(corners),
                                   std::abs(lower), lower < 0 ? 0.0f : 1.0f});
  std::vector<std::uint32_t> indices = disc_indices(corners);
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t a = corners + 1 + i, b = a + corners + 1;
    indices.insert(indices.end(), {a, b, b + 1, a, b + 1, a + 1});
  }
  return Mesh(places.data(), places.size(), indices.data(), indices.size(), {3});
}

}  // namespace onggi::render
