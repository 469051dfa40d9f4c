#include "kiosk/collection/content/model.h"

#include <algorithm>
#include <cmath>

#include "engine/math/unit.h"
#include "engine/profile/extraction.h"
#include "kiosk/collection/decoration/decorate.h"

namespace onggi::content {

namespace {

constexpr int kSectors = 96;           // A chord error of 0.05 % of the radius.
constexpr double kTolerance = 0.0004;  // Of the vessel's size.
// cos(18 degrees). Well under the 40 degrees at which a mesh shows an edge, so that thinning a
// round rim leaves it round.
constexpr double kMostTurn = 0.95105651629515357;

bool lies_near(const std::vector<Vec2>& chain, std::size_t first, std::size_t last, double limit) {
  const Vec2 along = unit(chain[last] - chain[first]);
  const Vec2 start = unit(chain[first + 1] - chain[first]);
  for (std::size_t i = first + 1; i < last; ++i) {
    const Vec2 to = chain[i] - chain[first];
    if (std::abs(along.x * to.y - along.y * to.x) > limit) return false;
    if (dot(start, unit(chain[i + 1] - chain[i])) < kMostTurn) return false;
  }
  return true;
}

/// The chain without points that lie on a straight link between their neighbours.
Section thinned(const Section& section) {
  std::vector<Vec2> chain;
  double size = 0.0;
  for (const Vec2& p : section.outline) {
    if (chain.empty() || !(p == chain.back())) chain.push_back(p);
    size = std::max({size, p.x, p.y});
  }
  if (chain.size() < 3) return {chain};
  Section out;
  out.outline.push_back(chain.front());
  for (std::size_t first = 0; first + 1 < chain.size();) {
    std::size_t last = first + 1;
    while (last + 1 < chain.size() && lies_near(chain, first, last + 1, kTolerance * size)) ++last;
    out.outline.push_back(chain[last]);
    first = last;
  }
  return out;
}

}  // namespace

TriangleMesh turned(const Drawing& drawing) { return revolve(thinned(drawing.section), kSectors); }

Result<surface::Surface> decorated(const Drawing& drawing, const decoration::Decoration& decoration,
                                   const std::string& name) {
  const ExtractionOptions options{.slices = 400, .up = Vec3{0, 1, 0}};
  const auto found = extract_profile(turned(drawing), options, name);
  if (!found) return tl::unexpected<Problem>(found.error());
  return decoration::decorated(found->profile, decoration, name);
}

namespace {

// Credits the drawing's source, not the vessel's owner, who did not make the model.
std::string credit_of(const Drawing& drawing) { return "Drawn from: " + drawing.source; }

}  // namespace

std::vector<std::byte> make_glb(const Drawing& drawing) {
  return write_glb(turned(drawing), drawing.title, credit_of(drawing));
}

std::vector<std::byte> make_glb(const Drawing& drawing, const TriangleMesh& mesh,
                                const GlbPicture& picture) {
  return write_glb(mesh, drawing.title, credit_of(drawing), GlbMaterial{}, picture);
}

}  // namespace onggi::content
