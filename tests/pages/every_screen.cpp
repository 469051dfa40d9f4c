#include "tests/pages/every_screen.h"

#include <algorithm>

#include "kiosk/collection/settings/mission_file.h"
#include "kiosk/exhibit/rehearsal/screen_walk.h"

namespace onggi::pages {

namespace {

constexpr double kHalf = 0.45;  // of a pot

/// A walk that looks at what it passes.
class Looker : public rehearsal::ScreenWalk {
 public:
  Looker(exhibit::Kiosk& kiosk, const LookAtScreen& look)
      : ScreenWalk(kiosk), kiosk_(kiosk), look_(look) {}

  /// Waits until all stands, and looks.
  void look(const std::string& state) {
    frames(kSettled);
    look_now(state);
  }
  void look_now(const std::string& state) {
    if (good()) fail(look_(state));
  }
  void over(const std::string& control, const std::string& state) {
    touch(control);
    look(state);
    touch(control + ".close");
    frames(kSettled);  // for a moment it still takes the touches
  }
  bool says(const std::string& words) const {
    for (const view::Item& item : kiosk_.shown().items)
      if (const auto* text = std::get_if<view::Text>(&item); text && text->text == words)
        return text->color.a >= 1;
    return false;
  }

 private:
  exhibit::Kiosk& kiosk_;
  const LookAtScreen& look_;
};

void look_into_drawers(Looker& looker, const std::string& name) {
  for (const char* drawer : {"tools", "wheel"}) {
    looker.touch(std::string("throw.") + drawer);
    looker.look(name + " " + drawer);
    looker.touch("throw.less");
  }
}

void throw_pot(exhibit::Kiosk& kiosk, Looker& looker) {
  looker.look("throw begin");
  looker.throw_pot(kHalf);
  looker.look_now("throw");
  look_into_drawers(looker, "throw");
  looker.over("help", "throw help");
  looker.until("the end of the script", [&] { return kiosk.wheel_host().status().script_done; });
  looker.touch("throw.done");
}

/// From the result to the gallery of what was kept.
void keep_pot(exhibit::Kiosk& kiosk, Looker& looker, const std::string& name) {
  looker.touch("result.keep");
  if (kiosk.visit().screen() == screens::ScreenId::kiln) {
    looker.touch("kiln.glaze.0");
    looker.frames(12);
    looker.look_now(name + " kiln");
    looker.touch("kiln.keep");
  }
  looker.until("the keepsake", [&] { return kiosk.doing().kept && kiosk.doing().kept->saved; });
  looker.look(name + " keepsake");
  if (!looker.has("keepsake.gallery")) return;
  looker.touch("keepsake.gallery");
  looker.look(name + " gallery");
  looker.touch("back");
  looker.frames(Looker::kSettled);
}

using MissionKind = settings::Mission::Kind;

std::string name_of_kind(MissionKind kind) {
  switch (kind) {
    case MissionKind::today:
      return "today";
    case MissionKind::describe:
      return "described";
    case MissionKind::eyes_closed:
      return "eyes closed";
    case MissionKind::two_hands:
      return "two hands";
  }
  return {};
}

void look_at_mission(exhibit::Kiosk& kiosk, Looker& looker, std::size_t n) {
  const MissionKind kind = kiosk.missions().cards()[n].mission->kind;
  const std::string name = name_of_kind(kind), card = "choose.mission." + std::to_string(n);
  looker.turn_to(card);
  looker.touch(card);
  looker.look(name + " label");
  looker.touch("choose.throw");
  looker.look(name + " begin");
  if (!looker.good()) return;
  looker.throw_pot(kHalf);
  if (kind != MissionKind::today) {
    looker.look_now(name);
    look_into_drawers(looker, name);
  }
  if (kind == MissionKind::eyes_closed) {
    looker.over("help", name + " help");
    looker.over("comfort", name + " comfort");
  }
  // Half a pot, so that there is a difference to tell.
  looker.touch("throw.done");
  looker.look(name + " result");
}

}  // namespace

Result<void> look_at_every_screen(exhibit::Kiosk& kiosk, int card, const LookAtScreen& look) {
  Looker looker(kiosk, look);
  const std::string shown = "choose.card." + std::to_string(card);
  looker.frames(20);
  looker.look_now("attract");
  looker.over("help", "attract help");
  looker.over("language", "languages");
  const auto& label = [&] {
    return kiosk.shelf()
        .cards()[static_cast<std::size_t>(std::max(0, kiosk.doing().card))]
        .vessel->label(kiosk.visit().language())
        .title;
  };
  looker.until("the name of attract's vessel", [&] { return looker.says(label()); });
  looker.look_now("attract name");
  looker.touch_clay();
  looker.look("clay");
  looker.touch("back");
  looker.frames(Looker::kSettled);
  looker.touch("attract.begin");
  looker.look("choose");
  if (looker.has("choose.next")) {
    looker.touch("choose.next");
    looker.look("choose on");
    looker.touch("choose.previous");
    looker.frames(Looker::kSettled);
  }
  looker.over("comfort", "comfort");
  looker.turn_to(shown);
  looker.touch(shown);
  looker.look("label");
  looker.touch("choose.throw");
  throw_pot(kiosk, looker);
  looker.look("result");
  looker.over("help", "result help");
  looker.touch("result.other");
  looker.look("leaving");
  looker.touch("leaving.close");
  looker.frames(Looker::kSettled);
  looker.touch("result.keep");
  if (kiosk.visit().screen() == screens::ScreenId::kiln) {
    looker.look("kiln");
    looker.touch("kiln.glaze.0");
    looker.frames(3.6);
    looker.look_now("kiln firing");
    looker.frames(6);
    looker.look_now("kiln fired");
    looker.touch("kiln.keep");
  }
  looker.frames(0.08);
  looker.look_now("keepsake waiting");
  looker.until("the keepsake", [&] { return kiosk.doing().kept && kiosk.doing().kept->saved; });
  looker.look("keepsake");
  if (looker.has("keepsake.gallery")) {
    looker.touch("keepsake.gallery");
    looker.look("gallery");
    looker.touch("back");
    looker.frames(Looker::kSettled);
  }
  looker.until(
      "the question", [&] { return kiosk.visit().idle_warning(); }, false);
  looker.look("idle");
  looker.touch("idle.stay");
  looker.frames(Looker::kSettled);
  looker.touch("keepsake.done");
  looker.look("thanks");
  looker.touch("keepsake.done");
  looker.look("attract again");
  if (looker.good()) kiosk.visit().fail({"every screen", "It is looked at.", "", 1});
  looker.look("fault");
  return looker.result();
}

Result<void> look_at_every_mission(exhibit::Kiosk& kiosk, const LookAtScreen& look) {
  Looker looker(kiosk, look);
  looker.frames(5);
  const std::size_t missions = kiosk.missions().cards().size();
  if (missions == 0)
    return problem("missions", "None is on.", "This is a fault of the program: please report it.",
                   1);
  looker.touch("attract.begin");
  looker.look("missions");
  // Look at the gallery last: it has all pots of the day.
  for (const bool described : {false, true})
    for (std::size_t n = 0; n < missions; ++n) {
      const MissionKind kind = kiosk.missions().cards()[n].mission->kind;
      if ((kind == MissionKind::describe) != described) continue;
      look_at_mission(kiosk, looker, n);
      if (described) keep_pot(kiosk, looker, name_of_kind(kind));
      looker.touch(described ? "keepsake.again" : "result.other");
      if (!described) looker.touch("leaving.go");
      looker.frames(Looker::kSettled);
    }
  return looker.result();
}

}  // namespace onggi::pages
