#include "kiosk/screens/throwing_controls.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace onggi::screens {

using device::Grip;

void lay_out_controls(Page& page, Column& column, const Desk& desk, const ThrowingControls& now) {
  const TypeScale& t = page.type();
  const auto rpm = [&](double speed) {
    const auto turns = static_cast<int>(std::lround(speed * 60.0 / (2 * 3.14159265358979)));
    return desk.say("throw.rpm", {{"rpm", std::to_string(turns)}});
  };
  const std::string hand = desk.say("throw.hand"), wheel = desk.say("throw.wheel"),
                    clay = desk.say("throw.clay"), force = desk.say("throw.force");
  const std::vector<Button> feels = desk.force.buttons(desk);
  float captions = 0;
  for (const std::string& words : {hand, wheel, clay, feels.empty() ? clay : force})
    captions = std::max(captions, page.size(words, page.style(Face::sans, t.body), -1).width + 4);

  // What comes and goes stands last, so that nothing else moves under a finger.
  std::vector<Button> onward{{"throw.done", desk.say("throw.done"), Look::solid}, now.show};
  if (now.skip) onward.push_back({"throw.skip", desk.say("throw.skip"), Look::quiet});
  if (now.restore) onward.push_back({"throw.restore", desk.say("throw.restore"), Look::outline});
  column.foot_buttons(onward);
  column.foot_space(t.gap);
  column.foot_buttons(
      {{"throw.water", desk.say("throw.water"), now.water ? Look::solid : Look::outline},
       {"throw.cut", desk.say("throw.cut"), now.cut ? Look::solid : Look::outline},
       {"throw.renew", desk.say("throw.renew"), Look::outline}},
      clay, captions);
  column.foot_space(t.gap);
  column.foot_buttons({{"throw.slower", desk.say("throw.slower"), Look::outline},
                       {"", rpm(now.speed), Look::plain, rpm(desk.wheel().max_speed)},
                       {"throw.faster", desk.say("throw.faster"), Look::outline}},
                      wheel, captions);
  column.foot_space(t.gap);
  if (!feels.empty()) {
    column.foot_buttons(feels, force, captions);
    column.foot_space(t.gap);
  }
  const auto grip = [&](const char* id, Grip which) {
    return Button{id, desk.say(id), now.grip == which ? Look::solid : Look::outline};
  };
  column.foot_buttons({grip("throw.both", Grip::both), grip("throw.outside", Grip::outside),
                       grip("throw.inside", Grip::inside)},
                      hand, captions);
}

void lay_out_mishap(Column& column, const TypeScale& t, const Desk& desk, Mishap what) {
  const bool fell = what == Mishap::fell;
  column.text(desk.say(fell ? "throw.fallen" : "throw.torn"), t.lead);
  column.space(t.gap);
  if (!fell) {
    const bool thin = what == Mishap::tore_thin;
    column.text(desk.say(thin ? "throw.torn_thin" : "throw.torn_wide"), t.body);
    column.space(t.gap);
  }
  const std::string back = desk.say(fell ? "throw.before_fall" : "throw.before_tear");
  if (desk.status.can_restore) column.buttons({{"throw.restore", back, Look::solid}});
}

}  // namespace onggi::screens
