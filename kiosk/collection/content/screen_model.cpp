#include "kiosk/collection/content/screen_model.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "kiosk/collection/content/lighter_mesh.h"

namespace onggi::content {
namespace {

using textures::TexturePixels;

/// The same surface with a colour at each corner, and no picture.
Coloring without_pictures(const Coloring& coloring) {
  Coloring out;
  for (const auto& light : baked(coloring))
    out.colors.push_back({display_of(light[0]), display_of(light[1]), display_of(light[2])});
  return out;
}

template <class List>
void keep_only(List& list, const std::vector<std::uint32_t>& kept) {
  if (list.empty()) return;
  List out;
  out.reserve(kept.size());
  for (const std::uint32_t at : kept) out.push_back(list[at]);
  list = std::move(out);
}

/// Drops positions that no triangle has.
void compact(TriangleMesh& mesh, Coloring& coloring) {
  constexpr std::uint32_t kNotKept = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(mesh.positions.size(), kNotKept), kept;
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle) {
      std::uint32_t& to = place[corner];
      if (to == kNotKept) {
        to = static_cast<std::uint32_t>(kept.size());
        kept.push_back(corner);
      }
      corner = to;
    }
  keep_only(mesh.positions, kept);
  keep_only(mesh.normals, kept);
  keep_only(coloring.colors, kept);
  keep_only(coloring.places, kept);
  keep_only(coloring.picture, kept);
}

/// Each pixel is the mean, in light, of `step` x `step`; at the far edges of what is left of them.
TexturePixels shrunk(const TexturePixels& pixels, int step) {
  std::array<float, 256> light;
  for (std::size_t i = 0; i < light.size(); ++i) light[i] = light_of(static_cast<std::uint8_t>(i));
  TexturePixels out;
  out.width = (pixels.width + step - 1) / step;
  out.height = (pixels.height + step - 1) / step;
  out.rgb.reserve(3 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      std::array<float, 3> sum{};
      float count = 0;
      for (int v = y * step; v < std::min((y + 1) * step, pixels.height); ++v)
        for (int u = x * step; u < std::min((x + 1) * step, pixels.width); ++u, ++count) {
          const std::size_t at =
              3 * (static_cast<std::size_t>(v) * static_cast<std::size_t>(pixels.width) +
                   static_cast<std::size_t>(u));
          for (std::size_t k = 0; k < 3; ++k) sum[k] += light[pixels.rgb[at + k]];
        }
      for (const float whole : sum) out.rgb.push_back(display_of(whole / count));
    }
  return out;
}

std::size_t size_of(int width, int height, int step) {
  const auto side = [step](int whole) {
    return static_cast<std::size_t>((whole + step - 1) / step);
  };
  return side(width) * side(height);
}

void shrink_pictures(Coloring& coloring) {
  // Pictures that share their pixels go on sharing them.
  std::map<const TexturePixels*, std::shared_ptr<const TexturePixels>> all;
  for (const Coloring::Picture& picture : coloring.pictures)
    all[picture.pixels.get()] = picture.pixels;
  int step = 1;
  const auto pixels = [&] {
    std::size_t sum = 0;
    for (const Coloring::Picture& picture : coloring.pictures)
      sum += size_of(picture.pixels->width, picture.pixels->height, step);
    return sum;
  };
  while (pixels() > kScreenPixels) ++step;
  if (step == 1) return;
  for (auto& [from, to] : all) to = std::make_shared<TexturePixels>(shrunk(*from, step));
  for (Coloring::Picture& picture : coloring.pictures) picture.pixels = all[picture.pixels.get()];
}

}  // namespace

void fit_to_screen(TriangleMesh& mesh, Coloring& coloring) {
  if (LighterMesh few = lighter(mesh, kScreenTriangles); !few.triangles.empty()) {
    if (few.coarse && !coloring.pictures.empty()) coloring = without_pictures(coloring);
    mesh.triangles = std::move(few.triangles);
  }
  if (mesh.positions.size() > 3 * kScreenTriangles ||
      mesh.positions.size() > 3 * mesh.triangles.size())
    compact(mesh, coloring);
  shrink_pictures(coloring);
}

}  // namespace onggi::content
