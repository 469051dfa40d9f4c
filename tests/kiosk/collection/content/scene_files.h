#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/profile/mesh.h"
#include "tests/kiosk/collection/content/temporary.h"

namespace onggi::content {

/// Writes glTF files of several objects.
class SceneFiles : public Temporary {
 protected:
  struct Object {
    std::string name;
    TriangleMesh mesh;
    std::array<double, 3> at{};
  };
  /// A glTF with a node for each object below a nameless root, buffers beside it; `more` are
  /// further members, `asset` further members of the asset, `accessor` of every position accessor.
  std::filesystem::path write_scene(const std::string& file, const std::vector<Object>& objects,
                                    const std::string& more = "", const std::string& asset = "",
                                    const std::string& accessor = "") {
    std::string bin, nodes, meshes, accessors, views, children;
    const auto view = [&](std::size_t from) {
      views += std::string(views.empty() ? "" : ",") +
               "{\"buffer\":0,\"byteOffset\":" + std::to_string(from) +
               ",\"byteLength\":" + std::to_string(bin.size() - from) + "}";
    };
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const Object& o = objects[i];
      std::size_t from = bin.size();
      bin.append(reinterpret_cast<const char*>(o.mesh.positions.data()),
                 12 * o.mesh.positions.size());
      view(from);
      from = bin.size();
      bin.append(reinterpret_cast<const char*>(o.mesh.triangles.data()),
                 12 * o.mesh.triangles.size());
      view(from);
      const std::string comma = i == 0 ? "" : ",", n = std::to_string(i);
      accessors += comma + "{\"bufferView\":" + std::to_string(2 * i) +
                   ",\"componentType\":5126,\"type\":\"VEC3\",\"count\":" +
                   std::to_string(o.mesh.positions.size()) + accessor +
                   "},{\"bufferView\":" + std::to_string(2 * i + 1) +
                   ",\"componentType\":5125,\"type\":\"SCALAR\",\"count\":" +
                   std::to_string(3 * o.mesh.triangles.size()) + "}";
      meshes += comma + "{\"primitives\":[{\"attributes\":{\"POSITION\":" + std::to_string(2 * i) +
                "},\"indices\":" + std::to_string(2 * i + 1) + "}]}";
      nodes += ",{\"name\":\"" + o.name + "\",\"mesh\":" + n + ",\"translation\":[" +
               std::to_string(o.at[0]) + "," + std::to_string(o.at[1]) + "," +
               std::to_string(o.at[2]) + "]}";
      children += comma + std::to_string(i + 1);
    }
    write(file + ".bin", bin);
    return write(file + ".gltf",
                 "{\"asset\":{\"version\":\"2.0\"" + asset +
                     "},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"children\":[" +
                     children + "]}" + nodes + "],\"meshes\":[" + meshes + "],\"accessors\":[" +
                     accessors + "],\"bufferViews\":[" + views + "],\"buffers\":[{\"byteLength\":" +
                     std::to_string(bin.size()) + ",\"uri\":\"" +
                     std::filesystem::path(file).filename().string() + ".bin\"}]" + more + "}");
  }
};

}  // namespace onggi::content
