#include "kiosk/visit/decorating/hand_work.h"

namespace onggi::decorating {

void HandWork::go_on(const std::vector<surface::Station>& stations) {
  if (stations.empty()) return;
  const auto same = [](const surface::Station& a, const surface::Station& b) {
    return a.along == b.along && a.round == b.round;
  };
  const bool joins = !ways.empty() && same(ways.back().back(), stations.front());
  if (!joins) ways.emplace_back();
  auto& way = ways.back();
  way.insert(way.end(), stations.begin() + (joins ? 1 : 0), stations.end());
}

}  // namespace onggi::decorating
