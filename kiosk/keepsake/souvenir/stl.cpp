#include "kiosk/keepsake/souvenir/stl.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kiosk/ground/files/byte_writer.h"

namespace onggi::souvenir {
namespace {

using Point = std::array<float, 3>;

/// Metres with y up to millimetres with z up: a quarter turn about x, which keeps the outside
/// outside.
Point to_printer(const Point& p) {
  // Adding 0 turns -0 into 0, so that equal positions have equal bytes.
  return {p[0] * 1000.0f + 0.0f, -p[2] * 1000.0f + 0.0f, p[1] * 1000.0f + 0.0f};
}

Point unit_normal(const Point& a, const Point& b, const Point& c) {
  const auto edge = [](const Point& from, const Point& to, std::size_t k) {
    return static_cast<double>(to[k]) - static_cast<double>(from[k]);
  };
  std::array<double, 3> n{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    n[k] = edge(a, b, i) * edge(a, c, j) - edge(a, b, j) * edge(a, c, i);
  }
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0.0)) return {0, 0, 0};  // a sliver: slicers compute it themselves
  return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
          static_cast<float>(n[2] / length)};
}

constexpr std::size_t kHeader = 80, kTriangle = 50;

}  // namespace

std::vector<std::byte> write_stl(const TriangleMesh& mesh, const std::string& title) {
  std::vector<std::array<Point, 3>> faces;
  faces.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    if (std::any_of(triangle.begin(), triangle.end(),
                    [&](std::uint32_t i) { return i >= mesh.positions.size(); })) {
      continue;
    }
    const std::array<Point, 3> face{to_printer(mesh.positions[triangle[0]]),
                                    to_printer(mesh.positions[triangle[1]]),
                                    to_printer(mesh.positions[triangle[2]])};
    // Where a wall closes on the axis, two corners are one point: no area, and slicers complain.
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
    faces.push_back(face);
  }

  files::ByteWriter out(kHeader + 4 + kTriangle * faces.size());
  // The header must not begin with "solid": readers would take it for the text form of STL.
  std::string header = "Onggi, mm, z up: " + title;
  std::size_t end = std::min(header.size(), kHeader);
  while (end < header.size() && (static_cast<unsigned char>(header[end]) & 0xC0) == 0x80) --end;
  out.text(header.substr(0, end));
  out.pad(kHeader, ' ');
  out.u32(static_cast<std::uint32_t>(faces.size()));
  for (const auto& face : faces) {
    out.f32s(unit_normal(face[0], face[1], face[2]));
    for (const Point& corner : face) out.f32s(corner);
    out.u16(0);
  }
  return out.take();
}

}  // namespace onggi::souvenir
