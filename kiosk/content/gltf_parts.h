#pragma once

#include <string>
#include <vector>

#include "kiosk/content/gltf.h"

namespace onggi::content {

/// One part alone.
TriangleMesh mesh_of(const GltfModel& model, const GltfPart& part);

/// The part of this name, or of this node's number; nullptr where there is none.
const GltfPart* find_part(const GltfModel& model, const std::string& name);

/// The parts that carry a surface themselves, where the file holds several objects: where at least
/// two groups of them stand apart from each other. Empty where all of it is one.
std::vector<const GltfPart*> separate_objects(const GltfModel& model);

}  // namespace onggi::content
