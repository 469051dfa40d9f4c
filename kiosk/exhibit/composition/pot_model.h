#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/profile/mesh.h"
#include "kiosk/picture/view/skin_point.h"

namespace onggi::exhibit {

/// The pot as a GLB, coloured as it was seen: `skin` has one a position of `mesh`. Colours are
/// COLOR_0 times a factor, the brightest of them, so that a viewer that knows no colours at corners
/// has one that is the pot's; a material each for what is as rough, within kRoughnessStep, the
/// smoothest first. No extension: any viewer shows it whole. `surface` names the glaze or the clay.
/// Deterministic bytes.
inline constexpr float kRoughnessStep = 0.1f;
std::vector<std::byte> pot_model(const TriangleMesh& mesh, const std::vector<view::SkinPoint>& skin,
                                 const std::string& surface, const std::string& title,
                                 const std::string& copyright);

}  // namespace onggi::exhibit
