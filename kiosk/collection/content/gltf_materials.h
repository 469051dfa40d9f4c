#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "kiosk/collection/content/gltf_container.h"
#include "kiosk/collection/content/gltf_document.h"

namespace onggi::content {

/// Fills `out.materials`, and `out.pictures` with the pictures that they need: only base colours
/// (metallic-roughness, or the diffuse one of KHR_materials_pbrSpecularGlossiness), with their
/// place in the picture (KHR_texture_transform) and the sampler's wraps. If a texture has several
/// pictures, EXT_texture_webp's comes first, then its own, then KHR_texture_basisu's. Data URIs are
/// decoded in place and files are read beneath `folder`, together at most `limits.file_mb` and
/// kMostPictures; none if `limits.texture_px` is 0. A picture that cannot be read has the reason in
/// `fault`. A fault here never makes the file invalid. Allocates.
void read_materials(const nlohmann::json& document, const std::filesystem::path& folder,
                    GltfContainer& container, const settings::ReaderLimits& limits,
                    GltfDocument& out);

}  // namespace onggi::content
