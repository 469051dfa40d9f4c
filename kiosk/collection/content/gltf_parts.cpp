#include "kiosk/collection/content/gltf_parts.h"

#include <algorithm>
#include <numeric>

namespace onggi::content {

namespace {

struct Extent {
  std::array<float, 3> low{}, high{};
};

Extent extent_of(const GltfModel& model, const GltfPart& part) {
  Extent out;
  for (std::size_t i = 0; i < part.own_positions; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const float v = model.mesh.positions[part.first_position + i][k];
      out.low[k] = i == 0 ? v : std::min(out.low[k], v);
      out.high[k] = i == 0 ? v : std::max(out.high[k], v);
    }
  return out;
}

/// Touching boxes belong to one thing: a handle and its jar, a cup and its saucer.
bool touch(const Extent& a, const Extent& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.low[k] > b.high[k] || b.low[k] > a.high[k]) return false;
  return true;
}

}  // namespace

TriangleMesh mesh_of(const GltfModel& model, const GltfPart& part, Reach reach) {
  const bool alone = reach == Reach::alone && part.own_triangles > 0;
  const std::size_t positions = alone ? part.own_positions : part.positions;
  const std::size_t triangles = alone ? part.own_triangles : part.triangles;
  TriangleMesh out;
  const auto run = [&](const auto& all) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(part.first_position);
    return std::decay_t<decltype(all)>(first, first + static_cast<std::ptrdiff_t>(positions));
  };
  out.positions = run(model.mesh.positions);
  if (!model.mesh.normals.empty()) out.normals = run(model.mesh.normals);
  out.triangles.reserve(triangles);
  const auto base = static_cast<std::uint32_t>(part.first_position);
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto& t = model.mesh.triangles[part.first_triangle + i];
    out.triangles.push_back({t[0] - base, t[1] - base, t[2] - base});
  }
  return out;
}

Coloring coloring_of(const GltfModel& model, const GltfPart& part, Reach reach) {
  const bool alone = reach == Reach::alone && part.own_triangles > 0;
  return model.coloring.part(part.first_position, alone ? part.own_positions : part.positions);
}

NamedPart find_part(const GltfModel& model, const std::string& name) {
  const auto named = [&model](const std::string& wanted) -> const GltfPart* {
    for (const GltfPart& part : model.parts)
      if (part.name == wanted) return &part;
    for (const GltfPart& part : model.parts)
      if (std::to_string(part.node) == wanted) return &part;
    return nullptr;
  };
  if (const GltfPart* part = named(name)) return {part, Reach::alone};
  const std::string all = "/*";
  if (name.size() > all.size() && name.compare(name.size() - all.size(), all.size(), all) == 0)
    return {named(name.substr(0, name.size() - all.size())), Reach::all};
  return {};
}

std::vector<const GltfPart*> separate_objects(const GltfModel& model) {
  std::vector<const GltfPart*> parts;
  for (const GltfPart& part : model.parts)
    if (part.mesh) parts.push_back(&part);
  if (parts.size() < 2) return {};
  std::vector<Extent> extents;
  for (const GltfPart* part : parts) extents.push_back(extent_of(model, *part));

  // Merge groups into the first one while any of them touches it.
  std::vector<bool> joined(parts.size(), false);
  std::vector<std::size_t> edge{0};
  joined[0] = true;
  while (!edge.empty()) {
    const std::size_t i = edge.back();
    edge.pop_back();
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (!joined[k] && touch(extents[i], extents[k])) {
        joined[k] = true;
        edge.push_back(k);
      }
  }
  if (std::all_of(joined.begin(), joined.end(), [](bool j) { return j; })) return {};
  return parts;
}

}  // namespace onggi::content
