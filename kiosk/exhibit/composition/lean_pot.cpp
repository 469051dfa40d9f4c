#include "kiosk/exhibit/composition/lean_pot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/math/vec.h"

namespace onggi::exhibit {
namespace {

constexpr double kAside = 0.00007;  // m: a printer's layer is thicker, a pixel of a phone wider
constexpr double kShade = 0.05;     // of a normal: about 3 degrees
constexpr double kColor = 0.02;     // linear, of the brightest there is
constexpr double kRough = 0.05;
constexpr int kFewestSectors = 48;

Vec3 vec(const std::array<float, 3>& p) { return {p[0], p[1], p[2]}; }

class Leaning {
 public:
  Leaning(const ClayMesh& pot, const std::vector<view::SkinPoint>& skin)
      : pot_(pot), skin_(skin), n_(static_cast<std::size_t>(pot.sectors)) {}

  LeanPot result() const {
    const std::vector<std::size_t> rings = kept_rings();
    const std::size_t step = sector_step(rings), count = n_ / step;
    LeanPot out;
    std::size_t before = 0;
    for (std::size_t r = 0; r < rings.size(); ++r) {
      const std::size_t first = out.mesh.positions.size();
      for (std::size_t k = 0; k < n_; k += step) {
        const std::size_t at = rings[r] * n_ + k;
        out.mesh.positions.push_back(pot_.mesh.positions[at]);
        out.mesh.normals.push_back(pot_.mesh.normals[at]);
        out.skin.push_back(skin_[at]);
      }
      if (r > 0 && face(rings[r]) == face(rings[r - 1])) join(out.mesh, before, first, count);
      before = first;
    }
    return out;
  }

 private:
  ClayFace face(std::size_t ring) const { return pot_.faces[ring * n_]; }

  /// A straight way from `a` to `b` passes `m` closely enough, and means the same there.
  bool stands_for(std::size_t a, std::size_t b, std::size_t m) const {
    const auto& p = pot_.mesh.positions;
    const Vec3 from = vec(p[a]), way = vec(p[b]) - from, off = vec(p[m]) - from;
    const double length2 = dot(way, way);
    const double t = length2 > 0 ? std::clamp(dot(off, way) / length2, 0.0, 1.0) : 0.0;
    const Vec3 aside = off - way * t;
    if (dot(aside, aside) > kAside * kAside) return false;
    const auto& n = pot_.mesh.normals;
    const Vec3 shade = vec(n[a]) * (1 - t) + vec(n[b]) * t - vec(n[m]);
    if (dot(shade, shade) > kShade * kShade) return false;
    const auto differs = [t](float x, float y, float z, double most) {
      const double mixed = (1 - t) * static_cast<double>(x) + t * static_cast<double>(y);
      return std::abs(mixed - static_cast<double>(z)) > most;
    };
    for (std::size_t k = 0; k < 3; ++k)
      if (differs(skin_[a].color[k], skin_[b].color[k], skin_[m].color[k], kColor)) return false;
    return !differs(skin_[a].roughness, skin_[b].roughness, skin_[m].roughness, kRough);
  }

  /// The first and last ring of each face, where faces meet, and of the others those that the
  /// straight way between two does not stand for.
  std::vector<std::size_t> kept_rings() const {
    const std::size_t rings = pot_.mesh.positions.size() / n_;
    std::vector<std::size_t> kept;
    std::size_t last = 0;
    for (std::size_t r = 0; r < rings; ++r) {
      const bool begins = r == 0 || face(r) != face(r - 1);
      const bool ends = r + 1 == rings || face(r) != face(r + 1);
      if (begins || ends || !spans(last, r + 1)) {
        kept.push_back(r);
        last = r;
      }
    }
    return kept;
  }
  bool spans(std::size_t a, std::size_t b) const {
    for (std::size_t m = a + 1; m < b; ++m)
      for (std::size_t k = 0; k < n_; ++k)
        if (!stands_for(a * n_ + k, b * n_ + k, m * n_ + k)) return false;
    return true;
  }

  /// The longest step round the axis that every kept ring allows.
  std::size_t sector_step(const std::vector<std::size_t>& rings) const {
    for (std::size_t step = n_ / kFewestSectors; step > 1; --step)
      if (n_ % step == 0 &&
          std::ranges::all_of(rings, [&](std::size_t r) { return skips(r * n_, step); }))
        return step;
    return 1;
  }
  bool skips(std::size_t ring, std::size_t step) const {
    for (std::size_t k = 0; k < n_; ++k)
      if (k % step != 0 &&
          !stands_for(ring + k - k % step, ring + (k - k % step + step) % n_, ring + k))
        return false;
    return true;
  }

  static void join(TriangleMesh& mesh, std::size_t before, std::size_t here, std::size_t count) {
    const auto& p = mesh.positions;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a]) return;  // A ring on the axis has no width.
      mesh.triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                static_cast<std::uint32_t>(c)});
    };
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t next = (k + 1) % count;
      add(before + k, here + k, before + next);
      add(before + next, here + k, here + next);
    }
  }

  const ClayMesh& pot_;
  const std::vector<view::SkinPoint>& skin_;
  std::size_t n_;
};

}  // namespace

LeanPot lean(const ClayMesh& pot, const std::vector<view::SkinPoint>& skin) {
  return Leaning(pot, skin).result();
}

}  // namespace onggi::exhibit
