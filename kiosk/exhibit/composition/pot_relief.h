#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/clay/clay_mesh.h"
#include "engine/surface/surface.h"
#include "kiosk/collection/decoration/unrolled.h"
#include "kiosk/keepsake/souvenir/relief_model.h"

namespace onggi::exhibit {

/// Between two places of a printed pot, m, as it is printed.
inline constexpr double kReliefGrid = 3e-4;
/// What lies nearer to a straight line between the places around it is left out, m: a coat is even
/// only to the steps in which its thickness is kept.
inline constexpr double kReliefEven = 4e-5;
/// From here on a relief moves the corners of the model, m.
inline constexpr double kReliefMoves = 3e-4;

/// The pot with its relief, for its STL. `body`: the clay's mesh (faced_mesh_of), and `places`,
/// where its positions lie in the unrolled picture of `surface`. All of it is `size` as large as
/// that. A grid of kReliefGrid along the outline, and round the pot where it is widest; coarser
/// where it is even within kReliefEven. Relief stands across the body, which is round there: each
/// row faces as the middle of the pot does. Allocates, some 10 MB; 0.2 s, for a worker thread.
souvenir::ReliefModel relief_of(const ClayMesh& body,
                                const std::vector<std::array<float, 2>>& places,
                                const surface::Surface& surface, double size,
                                const std::string& title);

/// Moves the positions of a decorated pot's model to the relief, for beads and bands that change
/// its outline; a picture of normals shows what is finer. Each goes to the mean height of the
/// relief over `wide` x `high` shares of the picture, times `share`, across the surface; positions
/// that are equal stay equal. Nothing is moved where no mean reaches kReliefMoves. `skin` has
/// normals, and is `size` as large as `surface`. `share`: as in normals_of(), for glass runs level
/// over it. Returns whether it moved something. Allocates.
bool raise(decoration::Skin& skin, const surface::Surface& surface, double size, double share,
           double wide, double high);

}  // namespace onggi::exhibit
