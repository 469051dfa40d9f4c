#include "kiosk/collection/content/gltf_strictness.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "kiosk/collection/content/gltf_document.h"
#include "kiosk/collection/content/json_words.h"

namespace onggi::content {
namespace {

using json_words::list_of;
using nlohmann::json;

Result<void> check_transforms(const std::string& name, const json& document) {
  struct Transform {
    const char* key;
    std::size_t numbers;
  };
  constexpr std::array<Transform, 4> kAll{
      {{"matrix", 16}, {"translation", 3}, {"rotation", 4}, {"scale", 3}}};
  const json& nodes = list_of(document, "nodes");
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const auto& [key, numbers] : kAll) {
      if (!nodes[i].is_object() || !nodes[i].contains(key)) continue;
      const json& given = nodes[i][key];
      const auto count = static_cast<std::size_t>(
          std::count_if(given.begin(), given.end(), [](const json& v) { return v.is_number(); }));
      if (given.is_array() && given.size() == numbers && count == numbers) continue;
      return unsound(name + ", node " + std::to_string(i),
                     std::string("its ") + key + " has " + std::to_string(count) +
                         " numbers, but it needs " + std::to_string(numbers) + ".");
    }
  return {};
}

Result<void> check_sparse(const std::string& name, const json& document) {
  const json& accessors = list_of(document, "accessors");
  for (std::size_t i = 0; i < accessors.size(); ++i) {
    if (!accessors[i].is_object() || !accessors[i].contains("sparse")) continue;
    const json& sparse = accessors[i]["sparse"];
    const json count = sparse.is_object() ? sparse.value("count", json()) : json();
    if (count.is_number_unsigned() && count.get<std::uint64_t>() > 0) continue;
    return unsound(name + ", accessor " + std::to_string(i),
                   "its sparse part has " + (count.is_number() ? count.dump() : "no number of") +
                       " elements, but it needs one or more.");
  }
  return {};
}

void note_scene(const json& document, std::vector<std::string>& warnings) {
  if (!document.contains("scene")) return;
  const json& scene = document["scene"];
  const std::size_t scenes = list_of(document, "scenes").size();
  if (scene.is_number_unsigned() && scene.get<std::uint64_t>() < scenes) return;
  warnings.push_back("The file asks for scene " + scene.dump().substr(0, 20) + " but has only " +
                     std::to_string(scenes) + "; every node without a parent is shown.");
}

bool any_weight(const json& weights) {
  return std::any_of(weights.begin(), weights.end(),
                     [](const json& w) { return w.is_number() && w.get<double>() != 0.0; });
}

void note_morphs(const json& document, std::vector<std::string>& warnings) {
  const json &meshes = list_of(document, "meshes"), &nodes = list_of(document, "nodes");
  std::vector<bool> moved(meshes.size(), false);
  for (std::size_t i = 0; i < meshes.size(); ++i)
    moved[i] = any_weight(list_of(meshes[i], "weights"));
  for (const json& node : nodes)
    if (node.is_object() && node.contains("mesh") && node["mesh"].is_number_unsigned() &&
        any_weight(list_of(node, "weights")))
      if (const auto mesh = node["mesh"].get<std::size_t>(); mesh < moved.size())
        moved[mesh] = true;
  std::size_t count = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const json& primitives = list_of(meshes[i], "primitives");
    if (moved[i] && std::any_of(primitives.begin(), primitives.end(),
                                [](const json& p) { return !list_of(p, "targets").empty(); }))
      ++count;
  }
  if (count > 0)
    warnings.push_back("Morph weights move " + std::to_string(count) +
                       (count == 1 ? " mesh" : " meshes") +
                       "; they are left out, and the shape is the one without them.");
}

}  // namespace

Result<void> check_strictly(const std::string& name, const json& document,
                            std::vector<std::string>& warnings) {
  if (auto good = check_transforms(name, document); !good) return good;
  if (auto good = check_sparse(name, document); !good) return good;
  note_scene(document, warnings);
  note_morphs(document, warnings);
  return {};
}

}  // namespace onggi::content
