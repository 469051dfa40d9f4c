#include "kiosk/collection/content/lighter_mesh.h"

#include <meshoptimizer.h>

#include <cstring>

namespace onggi::content {

LighterMesh lighter(const TriangleMesh& mesh, std::size_t most) {
  if (mesh.triangles.size() <= most) return {};
  constexpr float kAnyError = 1.0f;  // of its size: the count is what is asked
  constexpr std::size_t kStride = sizeof(mesh.positions[0]);
  const float* at = mesh.positions[0].data();
  const std::size_t corners = mesh.positions.size();
  std::vector<unsigned int> all(3 * mesh.triangles.size());
  std::memcpy(all.data(), mesh.triangles.data(), all.size() * sizeof(all[0]));
  std::vector<unsigned int> few(all.size());
  std::size_t count = meshopt_simplify(few.data(), all.data(), all.size(), at, corners, kStride,
                                       3 * most, kAnyError, 0, nullptr);
  LighterMesh out;
  out.coarse = count > 3 * most;
  if (out.coarse)
    count = meshopt_simplifySloppy(few.data(), all.data(), all.size(), at, corners, kStride,
                                   3 * most, kAnyError, nullptr);
  out.triangles.resize(count / 3);
  std::memcpy(out.triangles.data(), few.data(), 3 * out.triangles.size() * sizeof(few[0]));
  return out;
}

}  // namespace onggi::content
