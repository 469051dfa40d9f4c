#include "engine/profile/axis_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace onggi::extraction {

namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;

void add_outer(Matrix3& m, Vec3 a, Vec3 b, double weight) {
  const std::array<double, 3> av{a.x, a.y, a.z}, bv{b.x, b.y, b.z};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) m[r][c] += weight * av[r] * bv[c];
}

/// Eigenvectors of a symmetric matrix by Jacobi rotations, smallest eigenvalue first.
std::array<Vec3, 3> eigenvectors(Matrix3 m) {
  Matrix3 v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < 30; ++sweep)
    for (std::size_t p = 0; p < 2; ++p)
      for (std::size_t q = p + 1; q < 3; ++q) {
        if (m[p][q] == 0.0) continue;
        const double theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
        const double t =
            (theta >= 0.0 ? 1.0 : -1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
        for (std::size_t k = 0; k < 3; ++k) {
          const double a = m[k][p], b = m[k][q];
          m[k][p] = c * a - s * b;
          m[k][q] = s * a + c * b;
        }
        for (std::size_t k = 0; k < 3; ++k) {
          const double a = m[p][k], b = m[q][k];
          m[p][k] = c * a - s * b;
          m[q][k] = s * a + c * b;
        }
        for (std::size_t k = 0; k < 3; ++k) {
          const double a = v[k][p], b = v[k][q];
          v[k][p] = c * a - s * b;
          v[k][q] = s * a + c * b;
        }
      }
  std::array<std::size_t, 3> order{0, 1, 2};
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = i + 1; j < 3; ++j)
      if (m[order[j]][order[j]] < m[order[i]][order[i]]) std::swap(order[i], order[j]);
  std::array<Vec3, 3> out;
  for (std::size_t i = 0; i < 3; ++i) out[i] = {v[0][order[i]], v[1][order[i]], v[2][order[i]]};
  return out;
}

/// Inverse by cofactors; false where the matrix is all but singular.
bool inverse(const Matrix3& m, Matrix3& out) {
  const auto minor = [&](std::size_t r, std::size_t c) {
    const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  const double det = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  const double size = m[0][0] + m[1][1] + m[2][2];
  if (!(std::abs(det) > 1e-12 * size * size * size)) return false;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) out[r][c] = minor(c, r) / det;
  return true;
}

struct Patch {
  Vec3 centre, normal;
  double area;
};

/// Triangles as patches about their common centre, in units of their spread.
std::vector<Patch> patches_of(const TriangleMesh& mesh) {
  std::vector<Patch> out;
  out.reserve(mesh.triangles.size());
  Vec3 mean;
  double total = 0.0;
  for (const auto& t : mesh.triangles) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& q = mesh.positions[t[k]];
      p[k] = {q[0], q[1], q[2]};
    }
    const Vec3 n = cross(p[1] - p[0], p[2] - p[0]);
    const double twice = length(n);
    if (!(twice > 0.0)) continue;
    out.push_back({(p[0] + p[1] + p[2]) * (1.0 / 3.0), n * (1.0 / twice), twice});
    mean += out.back().centre * twice;
    total += twice;
  }
  if (out.empty()) return out;
  mean = mean * (1.0 / total);
  double spread = 0.0;
  for (Patch& p : out) {
    p.centre = p.centre - mean;
    spread += p.area * dot(p.centre, p.centre);
  }
  const double scale = spread > 0.0 ? 1.0 / std::sqrt(spread / total) : 1.0;
  for (Patch& p : out) {
    p.centre = p.centre * scale;
    p.area /= total;
  }
  return out;
}

/// The line (d, m = o x d) that the normals' lines meet best: n . m + (p x n) . d = 0 for each
/// (Pottmann and Randrup 1998). Normals that miss it by far, as a handle's do, lose their weight.
bool axis_of_normals(const std::vector<Patch>& patches, Vec3& direction) {
  Vec3 d, m;
  for (int pass = 0; pass < 4; ++pass) {
    Matrix3 a{}, b{}, c{};
    for (const Patch& p : patches) {
      const Vec3 moment = cross(p.centre, p.normal);
      double weight = p.area;
      if (pass > 0) {
        const double miss = (dot(p.normal, m) + dot(moment, d)) / 0.1;
        weight /= (1.0 + miss * miss) * (1.0 + miss * miss);
      }
      add_outer(a, moment, moment, weight);
      add_outer(b, moment, p.normal, weight);
      add_outer(c, p.normal, p.normal, weight);
    }
    Matrix3 c_inverse;
    if (!inverse(c, c_inverse)) return false;
    // With m = -C^-1 B^T d put in, what is left is a form in d alone.
    Matrix3 back{};  // C^-1 B^T
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 3; ++i) back[r][k] += c_inverse[r][i] * b[k][i];
    Matrix3 form = a;
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 3; ++i) form[r][k] -= b[r][i] * back[i][k];
    d = eigenvectors(form)[0];
    m = {-(back[0][0] * d.x + back[0][1] * d.y + back[0][2] * d.z),
         -(back[1][0] * d.x + back[1][1] * d.y + back[1][2] * d.z),
         -(back[2][0] * d.x + back[2][1] * d.y + back[2][2] * d.z)};
  }
  direction = d;
  return std::isfinite(d.x + d.y + d.z);
}

}  // namespace

std::vector<Vec3> axis_candidates(const TriangleMesh& mesh) {
  std::vector<Vec3> out;
  const auto add = [&](Vec3 d) {
    constexpr double kSame = 0.99995;  // cosine of 0.6 degrees
    if (std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) > kSame) return;
    for (const Vec3& other : out)
      if (std::abs(dot(d, other)) > kSame) return;
    out.push_back(d);
  };
  const std::vector<Patch> patches = patches_of(mesh);
  Vec3 normals;
  if (axis_of_normals(patches, normals)) add(normals);
  Matrix3 covariance{};
  for (const Patch& p : patches) add_outer(covariance, p.centre, p.centre, p.area);
  for (const Vec3& d : eigenvectors(covariance)) add(d);
  return out;
}

}  // namespace onggi::extraction
