#pragma once

#include <string>
#include <vector>

#include "kiosk/collection/content/gltf.h"

namespace onggi::content {

/// What of a part is meant.
enum class Reach {
  alone,  ///< The node's own surface; where it carries none, what hangs on it.
  all,    ///< With what hangs on it.
};

/// One part's surface.
TriangleMesh mesh_of(const GltfModel& model, const GltfPart& part, Reach reach);

/// The colours of mesh_of()'s positions.
Coloring coloring_of(const GltfModel& model, const GltfPart& part, Reach reach);

/// What `--node NAME` and `node = "NAME"` name: a node alone, or by "NAME/*" with what hangs on it.
struct NamedPart {
  const GltfPart* part = nullptr;  ///< By its name, else by the node's number; nullptr: none.
  Reach reach = Reach::alone;
};
NamedPart find_part(const GltfModel& model, const std::string& name);

/// The parts that carry a surface themselves, where the file holds several objects: where at least
/// two groups of them stand apart from each other. Empty where all of it is one.
std::vector<const GltfPart*> separate_objects(const GltfModel& model);

}  // namespace onggi::content
