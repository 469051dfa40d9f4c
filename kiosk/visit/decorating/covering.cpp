#include "kiosk/visit/decorating/covering.h"

#include <algorithm>
#include <iterator>

#include "kiosk/collection/decoration/figure.h"
#include "kiosk/visit/decorating/touched_part.h"

namespace onggi::decorating {

namespace {

constexpr int kSlices = 24;               // of a dip that rises
constexpr std::size_t kBroadPiece = 140;  // stations of a broad tool at once
// Of a tool's reach, m: from a turn to the next, and how far the last may reach over the end.
constexpr double kTurnApart = 1.8, kOverTheEnd = 0.8;

std::vector<surface::Stroke> rising(const surface::DipDef& whole, double end) {
  std::vector<surface::Stroke> all;
  for (int n = 0; n < kSlices; ++n) {
    surface::DipDef dip = whole;
    dip.from = kBareFoot + (end - kBareFoot) * n / kSlices;
    dip.to = n + 1 == kSlices ? end : kBareFoot + (end - kBareFoot) * (n + 1) / kSlices;
    if (dip.from < dip.to) all.push_back({dip, {}, false});
  }
  return all;
}

}  // namespace

std::vector<surface::Stroke> in_pieces(const surface::Tool& tool,
                                       const std::vector<surface::Station>& stations,
                                       std::size_t from, std::size_t piece) {
  std::vector<surface::Stroke> all;
  for (std::size_t n = from; n + 1 < stations.size(); n += piece) {
    const std::size_t to = std::min(n + piece + 1, stations.size());
    all.push_back({tool,
                   {stations.begin() + static_cast<std::ptrdiff_t>(n),
                    stations.begin() + static_cast<std::ptrdiff_t>(to)},
                   false});
  }
  return all;
}

std::vector<surface::Stroke> covering(const surface::Surface& surface, const surface::Tool& tool,
                                      double end, double end_of_outline) {
  if (const auto* dip = std::get_if<surface::DipDef>(&tool)) return rising(*dip, end_of_outline);
  std::vector<surface::Stroke> all;
  const double half = std::min(reach_of(tool), 0.5 * end);
  for (double at = half; at < end + kOverTheEnd * half; at += kTurnApart * half) {
    const double along = std::min(at, end - half);
    std::ranges::move(in_pieces(tool,
                                decoration::way_of(surface, {{0.0, 0.0}, {1.0, 0.0}},
                                                   {along, 0.0, 1.0, 1.0}, false),
                                0, kBroadPiece),
                      std::back_inserter(all));
  }
  return all;
}

}  // namespace onggi::decorating
