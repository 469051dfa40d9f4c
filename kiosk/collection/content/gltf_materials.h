#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "kiosk/collection/content/gltf_container.h"
#include "kiosk/collection/content/gltf_document.h"

namespace onggi::content {

/// Fills `out.materials` and, of the pictures that they need, `out.pictures`: base colours alone
/// (metallic-roughness, KHR_materials_pbrSpecularGlossiness's diffuse one), with the place in the
/// picture (KHR_texture_transform) and its sampler's wraps. Of a texture's several pictures
/// EXT_texture_webp's is taken, else its own, else KHR_texture_basisu's. Data URIs are decoded in
/// their own place, files are read beneath `folder`, together `limits.file_mb` and
/// kMostPictures at the most, none where `limits.texture_px` is 0; a picture that cannot be had has
/// its reason in `fault`. Nothing here makes a file unsound. Allocates.
void read_materials(const nlohmann::json& document, const std::filesystem::path& folder,
                    GltfContainer& container, const settings::ReaderLimits& limits,
                    GltfDocument& out);

}  // namespace onggi::content
