#include "kiosk/picture/render/silhouette.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace onggi::render {
namespace {

constexpr float kRowsApart = 1.0f;  // pixels between points of a line, at least

}  // namespace

Silhouette::Silhouette(By by, glm::vec2 frame, float from, float to)
    : along_(by == By::lines ? 1 : 0), across_(1 - along_) {
  const float last = std::max(frame[along_], 0.0f);
  first_ = static_cast<std::size_t>(std::clamp(std::floor(from), 0.0f, last));
  const auto past = static_cast<std::size_t>(std::clamp(std::ceil(to), 0.0f, last));
  for (auto& each : most_) each.resize(std::max(past, first_) - first_);
}

void Silhouette::take(const MeshCorner& one, const MeshCorner& other, bool is_side) {
  const bool up = one.point.at[along_] < other.point.at[along_];
  const MeshCorner &a = up ? one : other, &b = up ? other : one;
  const float begin = a.point.at[along_], end = b.point.at[along_];
  // In floats, because a corner may lie farther away than an int reaches.
  const auto line_at = [&](float at) {
    return static_cast<std::size_t>(
        std::clamp(at, static_cast<float>(first_), static_cast<float>(first_ + most_[0].size())));
  };
  const std::size_t past = line_at(std::floor(end - 0.5f) + 1.0f);
  for (std::size_t line = line_at(std::ceil(begin - 0.5f)); line < past; ++line) {
    const float middle = static_cast<float>(line) + 0.5f;
    const float t = (middle - begin) / std::max(end - begin, 1e-6f);
    const float at = std::lerp(a.point.at[across_], b.point.at[across_], t);
    for (const std::size_t side : {0u, 1u}) {
      Most& most = most_[side][line - first_];
      const float now = most.point.at[across_];
      if (most.any && (side == 0 ? at >= now : at <= now)) continue;
      most.point.at[across_] = at;
      most.point.at[along_] = middle;
      most.point.depths = glm::mix(a.point.depths, b.point.depths, t);
      most.own = glm::mix(a.own, b.own, t);
      most.is_side = is_side;
      most.any = true;
    }
  }
}

std::vector<std::vector<EdgePoint>> lines_through(const std::vector<std::optional<EdgePoint>>& edge,
                                                  Silhouette::By by, bool greatest, AtLeap at) {
  const int along = by == Silhouette::By::lines ? 1 : 0;
  std::vector<std::vector<EdgePoint>> out;
  std::vector<EdgePoint> line;
  // What is in front lies left of the way.
  const bool reversed = (along == 1) != greatest;
  const auto end = [&] {
    if (reversed) std::reverse(line.begin(), line.end());
    if (line.size() > 1) out.push_back(std::move(line));
    line.clear();
  };
  const auto across = [&](std::size_t i) {
    const bool both = i + 1 < edge.size() && edge[i] && edge[i + 1];
    return both ? std::abs(edge[i + 1]->at[1 - along] - edge[i]->at[1 - along]) : 0.0f;
  };
  // Where another bulge begins to be the outermost, the edge leaps between two lines.
  const auto leaps = [&](std::size_t i) {
    const float before = i > 0 ? across(i - 1) : 0.0f, after = across(i + 1);
    return across(i) > kLeap && std::max(before, after) < 0.4f * across(i);
  };
  for (std::size_t i = 0; i < edge.size(); ++i) {
    if (!edge[i]) {
      end();
      continue;
    }
    const bool ends =
        i + 1 == edge.size() || !edge[i + 1] || (at == AtLeap::ended && across(i) > kLeap);
    const bool begins = line.empty();
    if (begins || ends || glm::length(edge[i]->at - line.back().at) >= kRowsApart)
      line.push_back(*edge[i]);
    if (begins && at == AtLeap::ended && i > 0 && across(i - 1) > kLeap)
      line.back().most_out = kAtLeapsEnd;
    if (ends) {
      if (across(i) > kLeap) line.back().most_out = kAtLeapsEnd;
      end();
    } else if (at == AtLeap::joined && leaps(i)) {
      for (const std::size_t k : {i, i + 1}) {
        line.push_back(*edge[k]);
        line.back().at.y = edge[i]->at.y + 0.5f;
      }
    }
  }
  return out;
}

}  // namespace onggi::render
