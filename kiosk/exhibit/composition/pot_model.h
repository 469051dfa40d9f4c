#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/profile/mesh.h"
#include "kiosk/collection/content/glb.h"
#include "kiosk/picture/view/skin_point.h"

namespace onggi::exhibit {

/// The pot as a GLB, coloured as visitors saw it: `skin` has one entry for each position of `mesh`.
/// Colours are COLOR_0 times a factor, the brightest colour, so that a viewer without vertex
/// colours still shows about the pot's colour. One material for each step of roughness
/// (kRoughnessStep), the smoothest first. It uses no extension, so every viewer shows it. `surface`
/// names the glaze or the clay. Deterministic bytes.
inline constexpr float kRoughnessStep = 0.1f;
std::vector<std::byte> pot_model(const TriangleMesh& mesh, const std::vector<view::SkinPoint>& skin,
                                 const std::string& surface, const std::string& title,
                                 const std::string& copyright);

/// The same for a decorated pot, of one material: the pictures say how it looks in place of colours
/// at its positions and steps of roughness. With a picture of normals it has tangents: round the
/// pot, which is to the picture's right everywhere.
std::vector<std::byte> pot_model(const TriangleMesh& mesh, const std::string& surface,
                                 const std::string& title, const std::string& copyright,
                                 content::GlbPicture picture);

}  // namespace onggi::exhibit
