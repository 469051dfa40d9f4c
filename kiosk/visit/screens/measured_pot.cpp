#include "kiosk/visit/screens/measured_pot.h"

namespace onggi::screens {

void MeasuredPot::update(Desk& desk, const Profile& made) {
  if (desk.described() == nullptr || made.points.empty() || !desk.pot_ready()) return;
  if (desk.figures && desk.now - looked_ < kLook) return;
  looked_ = desk.now;
  desk.figures = score::figures_of(made, desk.world.wheel->clay.capacity());
}

std::vector<std::string> MeasuredPot::sentences(const Desk& desk) {
  std::vector<std::string> out;
  if (desk.described() == nullptr || !desk.figures) return out;
  for (const score::Remark& one : score::asked_of(*desk.described(), *desk.figures))
    out.push_back(desk.said(one));
  return out;
}

std::string MeasuredPot::hint(const Desk& desk) {
  if (desk.described() == nullptr || !desk.figures) return {};
  return score::most_off(*desk.described(), *desk.figures);
}

const std::vector<std::string>& MeasuredPot::hints() {
  static const std::vector<std::string> all{"mission.more",   "mission.less",   "mission.wider",
                                            "mission.closer", "mission.taller", "mission.lower",
                                            "mission.close"};
  return all;
}

}  // namespace onggi::screens
