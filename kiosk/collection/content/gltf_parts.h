#pragma once

#include <string>
#include <vector>

#include "kiosk/collection/content/gltf.h"

namespace onggi::content {

/// Which surface of a part is meant.
enum class Reach {
  alone,  ///< The node's own surface; if it has none, the surface of its children.
  all,    ///< The node with its children.
};

/// The surface of one part.
TriangleMesh mesh_of(const GltfModel& model, const GltfPart& part, Reach reach);

/// The colours of mesh_of()'s positions.
Coloring coloring_of(const GltfModel& model, const GltfPart& part, Reach reach);

/// What `--node NAME` and `node = "NAME"` select: a node alone, or with "NAME/*" the node with its
/// children.
struct NamedPart {
  const GltfPart* part = nullptr;  ///< Found by name, else by the node's number; nullptr: none.
  Reach reach = Reach::alone;
};
NamedPart find_part(const GltfModel& model, const std::string& name);

/// The parts with a surface of their own, if the file holds several objects (at least two groups
/// that do not touch). Empty if everything is one object.
std::vector<const GltfPart*> separate_objects(const GltfModel& model);

}  // namespace onggi::content
