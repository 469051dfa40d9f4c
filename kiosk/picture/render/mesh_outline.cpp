#include "kiosk/picture/render/mesh_outline.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "kiosk/picture/render/silhouette.h"

namespace onggi::render {
namespace {

constexpr float kBeforeEye = 0.01f;  // m: what is nearer has no place in the picture
constexpr float kShortest = 2.5f;    // texels of an outline within
constexpr float kBack = 1.0f;        // pixels that an outline goes back without a turn
constexpr float kSame = 0.75f;       // texels from the outermost: the same outline

/// Numbers the places that triangles have, each once; fills `corners`.
std::vector<std::array<std::uint32_t, 3>> with_own_corners(const TriangleMesh& mesh, float size,
                                                           std::vector<glm::vec3>& corners) {
  std::vector<std::uint32_t> used, number(mesh.positions.size(), 0);
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t c : t)
      if (std::exchange(number[c], 1u) == 0) used.push_back(c);
  const auto& at = mesh.positions;
  std::sort(used.begin(), used.end(),
            [&](std::uint32_t a, std::uint32_t b) { return at[a] < at[b]; });
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (i == 0 || at[used[i]] != at[used[i - 1]])
      corners.push_back(size * glm::vec3(at[used[i]][0], at[used[i]][1], at[used[i]][2]));
    number[used[i]] = static_cast<std::uint32_t>(corners.size() - 1);
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    const auto& [a, b, c] = triangles.back();
    if (a == b || b == c || c == a) triangles.pop_back();
  }
  return triangles;
}

/// By triangle: its part of the mesh is inside out. Parts that hang together are one: a handle may
/// be mirrored.
std::vector<bool> inside_out(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                             const std::vector<glm::vec3>& corners) {
  std::vector<std::uint32_t> part(corners.size());
  std::iota(part.begin(), part.end(), 0u);
  const auto part_of = [&](std::uint32_t c) {
    while (part[c] != c) c = part[c] = part[part[c]];
    return c;
  };
  for (const auto& t : triangles)
    for (const std::uint32_t c : {t[1], t[2]}) part[part_of(c)] = part_of(t[0]);
  struct Part {
    glm::dvec3 middle{0.0};
    double corners = 0.0, volume = 0.0;
  };
  std::vector<Part> parts(corners.size());
  for (std::uint32_t c = 0; c < corners.size(); ++c) {
    Part& of = parts[part_of(c)];
    of.middle += glm::dvec3(corners[c]);
    of.corners += 1.0;
  }
  for (const auto& [a, b, c] : triangles) {
    Part& of = parts[part_of(a)];
    const glm::dvec3 middle = of.middle / of.corners;
    of.volume +=
        glm::dot(glm::dvec3(corners[a]) - middle,
                 glm::cross(glm::dvec3(corners[b]) - middle, glm::dvec3(corners[c]) - middle));
  }
  std::vector<bool> out;
  for (const auto& t : triangles) out.push_back(parts[part_of(t[0])].volume < 0.0);
  return out;
}

/// An edge of the picture's outlines; the mesh lies left of the way.
struct Directed {
  std::uint32_t from = 0, to = 0;
};

class MeshTracer {
 public:
  MeshTracer(const MeshEdges& edges, const view::VesselView& vessel, float texel)
      : edges_(edges),
        texel_(texel),
        frame_(vessel.camera.width, vessel.camera.height),
        lines_(Silhouette::By::lines, frame_),
        columns_(Silhouette::By::columns, frame_) {
    project(vessel);
  }
  void trace(Ribbons& ribbons) {
    find();
    outermost(ribbons);
    within(ribbons);
  }

 private:
  using By = Silhouette::By;
  void project(const view::VesselView& vessel);
  void find();
  bool is_hidden(const MeshEdges::Edge& edge) const;
  void outermost(Ribbons& ribbons);
  void within(Ribbons& ribbons);
  void add_within(Ribbons& ribbons, const std::vector<std::uint32_t>& chain, By by);
  void add_line(Ribbons& ribbons, std::vector<EdgePoint> line) const;
  void add_run(Ribbons& ribbons, const std::vector<std::uint32_t>& chain, std::size_t from,
               std::size_t to, By by, bool forwards);
  glm::vec2 at(std::uint32_t corner) const { return corners_[corner].point.at; }

  const MeshEdges& edges_;
  const float texel_;
  const glm::vec2 frame_;
  std::vector<MeshCorner> corners_;
  std::vector<float> metres_;  // from the eye; 0: not before it
  std::vector<Directed> found_;
  Silhouette lines_, columns_;
};

void MeshTracer::project(const view::VesselView& vessel) {
  const view::Camera& camera = vessel.camera;
  glm::mat4 view, projection;
  camera.matrices(&view[0][0], &projection[0][0]);
  const auto c = static_cast<float>(std::cos(vessel.angle)),
             s = static_cast<float>(std::sin(vessel.angle));
  const glm::mat4 clip =
      projection * view * glm::mat4(c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1);
  const auto depth_of = [&](float metres) {
    return 0.5f + 0.5f * (projection[3][2] / metres - projection[2][2]);
  };
  // What the ribbon covers of a round wall is that much nearer than its side.
  const float wide =
      1.5f * texel_ * static_cast<float>(camera.distance) / (0.5f * projection[1][1] * frame_.y);
  corners_.resize(edges_.corners.size());
  metres_.assign(corners_.size(), 0.0f);
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const glm::vec3 p = edges_.corners[i];
    const glm::vec4 in = clip * glm::vec4(p, 1.0f);
    if (!(in.w > kBeforeEye)) continue;
    metres_[i] = in.w;
    const float nearer = kHides + std::sqrt(2.0f * std::hypot(p.x, p.z) * wide);
    corners_[i].point = {
        (0.5f + 0.5f * glm::vec2(in) / in.w) * frame_,
        {depth_of(std::max(in.w - nearer, kBeforeEye)), depth_of(in.w + kBehind), kElsewhere}};
  }
}

// Of the two triangles on one side of an edge the nearer one is seen. If that is the inside of the
// material, the edge is the bottom of a fold.
bool MeshTracer::is_hidden(const MeshEdges::Edge& edge) const {
  if (edge.turned == MeshEdges::Turned::border || edge.turned == MeshEdges::Turned::unsure)
    return false;
  const glm::vec2 from = at(edge.a), way = at(edge.b) - from;
  const float length = std::max(glm::dot(way, way), 1e-12f);
  // How much farther it gets with each pixel from the edge.
  const auto recedes = [&](std::uint32_t corner) {
    const glm::vec2 to = at(corner) - from;
    const float along = glm::dot(to, way) / length;
    const float aside = std::abs(way.x * to.y - way.y * to.x) / std::sqrt(length);
    return (metres_[corner] - std::lerp(metres_[edge.a], metres_[edge.b], along)) /
           std::max(aside, 1e-6f);
  };
  const glm::vec2 to = at(edge.one) - from;
  const bool left = way.x * to.y - way.y * to.x > 0.0f;
  const bool first_faces = left == (edge.turned == MeshEdges::Turned::along);
  const bool first_nearer = recedes(edge.one) < recedes(edge.other);
  return first_faces != first_nearer;
}

// Where both triangles of an edge lie on one side of it, the mesh turns away.
void MeshTracer::find() {
  for (const MeshEdges::Edge& edge : edges_.edges) {
    if (!(metres_[edge.a] > 0.0f && metres_[edge.b] > 0.0f && metres_[edge.one] > 0.0f &&
          metres_[edge.other] > 0.0f))
      continue;
    const glm::vec2 from = at(edge.a), way = at(edge.b) - from, to = at(edge.one) - from,
                    back = at(edge.other) - from;
    const float side = way.x * to.y - way.y * to.x;
    if (side * (way.x * back.y - way.y * back.x) < 0.0f) continue;
    lines_.take(corners_[edge.a], corners_[edge.b]);
    columns_.take(corners_[edge.a], corners_[edge.b]);
    if (is_hidden(edge)) continue;
    found_.push_back(side > 0.0f ? Directed{edge.a, edge.b} : Directed{edge.b, edge.a});
  }
}

void MeshTracer::outermost(Ribbons& ribbons) {
  for (const By by : {By::lines, By::columns})
    for (const std::size_t side : {0u, 1u}) {
      std::vector<std::optional<EdgePoint>> edge;
      for (const auto& most : (by == By::lines ? lines_ : columns_).most()[side])
        edge.push_back(most.any ? std::optional(most.point) : std::nullopt);
      for (const auto& line : lines_through(edge, by, side == 1, AtLeap::ended))
        add_line(ribbons, line);
    }
}

// Where another outline begins, the texels beside an end are that one's.
void MeshTracer::add_line(Ribbons& ribbons, std::vector<EdgePoint> line) const {
  const auto close = [&](const EdgePoint& one, const EdgePoint& end) {
    return end.most_out <= kAtLeapsEnd && glm::length(one.at - end.at) < texel_;
  };
  std::vector<EdgePoint> piece;
  bool narrow = false;
  const auto draw = [&] {
    for (EdgePoint& p : piece) p.most_out = narrow ? kAtLeapsEnd : EdgePoint{}.most_out;
    add_ribbon(ribbons.corners, ribbons.outlines, piece, texel_);
  };
  const EdgePoint first = line.front(), last = line.back();
  for (const EdgePoint& p : line) {
    piece.push_back(p);
    const bool now = close(p, first) || close(p, last);
    if (now != narrow && piece.size() > 1) {
      draw();
      piece = {p};
    }
    narrow = now;
  }
  draw();
}

// Edges that follow each other are one outline. Where more than two meet, the straightest goes on.
void MeshTracer::within(Ribbons& ribbons) {
  std::vector<std::uint32_t> first(corners_.size() + 1, 0), order(found_.size());
  std::vector<std::uint32_t> coming(corners_.size(), 0);
  for (const Directed& edge : found_) ++first[edge.from + 1], ++coming[edge.to];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t i = 0; i < found_.size(); ++i) order[next[found_[i].from]++] = i;
  std::vector<bool> used(found_.size(), false);
  const auto follow = [&](std::uint32_t begin) {
    std::vector<std::uint32_t> chain{found_[begin].from};
    for (std::optional<std::uint32_t> edge = begin; edge;) {
      used[*edge] = true;
      const auto [from, to] = found_[*edge];
      chain.push_back(to);
      edge.reset();
      float best = -2.0f;
      const glm::vec2 way = at(to) - at(from);
      for (std::uint32_t k = first[to]; k < first[to + 1]; ++k) {
        if (used[order[k]]) continue;
        const glm::vec2 on = at(found_[order[k]].to) - at(to);
        const float straight =
            glm::dot(way, on) / std::max(glm::length(way) * glm::length(on), 1e-9f);
        if (straight > best) best = straight, edge = order[k];
      }
    }
    for (const By by : {By::lines, By::columns}) add_within(ribbons, chain, by);
  };
  // Those that begin somewhere, then rings.
  for (const bool ring : {false, true})
    for (std::uint32_t i = 0; i < found_.size(); ++i)
      if (!used[i] && (ring || coming[found_[i].from] == 0)) follow(i);
}

// By lines the pieces that go up or down, by columns those to the left or the right.
void MeshTracer::add_within(Ribbons& ribbons, const std::vector<std::uint32_t>& chain, By by) {
  const int along = by == By::lines ? 1 : 0;
  std::size_t start = 0, farthest = 0;
  float way = 0.0f;  // 1: up or to the right, -1: down or to the left
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const float gone = at(chain[i])[along] - at(chain[farthest])[along];
    if (gone * way > 0.0f || (way == 0.0f && std::abs(gone) > kBack)) {
      way = gone > 0.0f ? 1.0f : -1.0f;
      farthest = i;
    } else if (way != 0.0f && std::abs(gone) > kBack) {
      add_run(ribbons, chain, start, farthest, by, way > 0.0f);
      start = farthest;
      farthest = i;
      way = -way;
    }
  }
  if (way != 0.0f) add_run(ribbons, chain, start, farthest, by, way > 0.0f);
}

void MeshTracer::add_run(Ribbons& ribbons, const std::vector<std::uint32_t>& chain,
                         std::size_t from, std::size_t to, By by, bool forwards) {
  const int along = by == By::lines ? 1 : 0;
  const float one = at(chain[from])[along], other = at(chain[to])[along];
  Silhouette run(by, frame_, std::min(one, other), std::max(one, other));
  for (std::size_t i = from; i < to; ++i) run.take(corners_[chain[i]], corners_[chain[i + 1]]);
  // The mesh lies left: of the way up, to the lesser x; of the way to the right, to the greater y.
  const bool greatest = forwards == (by == By::lines);
  const auto& whole = (by == By::lines ? lines_ : columns_).most()[greatest ? 1 : 0];
  std::vector<std::optional<EdgePoint>> edge;
  for (std::size_t i = 0; i < run.most()[0].size(); ++i) {
    const Silhouette::Most &most = run.most()[greatest ? 1 : 0][i],
                           &outermost = whole[run.first() + i];
    const bool drawn = !most.any || std::abs(most.point.at[1 - along] -
                                             outermost.point.at[1 - along]) < kSame * texel_;
    edge.push_back(drawn ? std::nullopt : std::optional(most.point));
  }
  for (const auto& line : lines_through(edge, by, greatest, AtLeap::ended))
    if (glm::length(line.back().at - line.front().at) > kShortest * texel_) add_line(ribbons, line);
}

}  // namespace

MeshEdges edges_of(const TriangleMesh& mesh, float size) {
  MeshEdges out;
  const auto triangles = with_own_corners(mesh, size, out.corners);
  const std::vector<bool> inverted = inside_out(triangles, out.corners);
  // The edges from each corner to higher ones lie together: an edge's second triangle finds it
  // among few.
  std::vector<std::size_t> first(out.corners.size() + 1, 0);
  const auto each = [&](const auto& what) {
    for (std::size_t n = 0; n < triangles.size(); ++n)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& t = triangles[n];
        const std::uint32_t from = t[k], to = t[(k + 1) % 3];
        what(inverted[n] ? to : from, inverted[n] ? from : to, t[(k + 2) % 3]);
      }
  };
  each([&](std::uint32_t a, std::uint32_t b, std::uint32_t) { ++first[std::min(a, b) + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  struct Found {
    MeshEdges::Edge edge;
    bool along = false;  // the first triangle's way
  };
  std::vector<Found> found(first.back());
  std::vector<std::size_t> past(first.begin(), first.end() - 1);
  each([&](std::uint32_t from, std::uint32_t to, std::uint32_t opposite) {
    const std::uint32_t low = std::min(from, to), high = std::max(from, to);
    const bool along = from == low;
    for (std::size_t i = first[low]; i < past[low]; ++i) {
      MeshEdges::Edge& edge = found[i].edge;
      if (edge.b != high || edge.turned != MeshEdges::Turned::border) continue;
      edge.other = opposite;
      edge.turned = found[i].along == along ? MeshEdges::Turned::unsure
                    : found[i].along        ? MeshEdges::Turned::along
                                            : MeshEdges::Turned::against;
      return;
    }
    found[past[low]++] = {{low, high, opposite, opposite, MeshEdges::Turned::border}, along};
  });
  for (std::size_t c = 0; c < out.corners.size(); ++c)
    for (std::size_t i = first[c]; i < past[c]; ++i) out.edges.push_back(found[i].edge);
  return out;
}

void add_mesh_outline(Ribbons& ribbons, const MeshEdges& edges, const view::VesselView& vessel,
                      float texel) {
  MeshTracer(edges, vessel, texel).trace(ribbons);
}

}  // namespace onggi::render
