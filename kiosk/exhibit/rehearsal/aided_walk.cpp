#include "kiosk/exhibit/rehearsal/aided_walk.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include "kiosk/exhibit/rehearsal/aided_visitor.h"
#include "kiosk/ground/files/monotonic.h"

namespace onggi::rehearsal {

using screens::ScreenId;

namespace {
constexpr int kAidedTicks = 20;         // of 1 ms: 50 frames a second
constexpr double kFadedIn = 1.2;        // s until a screen has faded in
constexpr double kAidedTooLong = 3600;  // s of visit
constexpr double kAttractSeen = 1.0;    // s on the attract screen
}  // namespace

Result<std::vector<access::Utterance>> walk_aided(
    exhibit::Kiosk& kiosk, const AidedWalk& how,
    const std::function<void(const std::string&)>& passed) {
  std::vector<access::Utterance> said, fresh;
  kiosk.access_input().listen([&](const access::Utterance& one) {
    said.push_back(one);
    fresh.push_back(one);
  });
  kiosk.advance(kAidedTicks);
  if (!kiosk.frame(0, how.realtime)) return said;
  const content::Language language = *kiosk.visit().reading().language;
  const screens::MissionCard* mission =
      how.mission < 0 ? nullptr : &kiosk.missions().cards()[static_cast<std::size_t>(how.mission)];
  const screens::ShelfCard& card = *kiosk.card(mission != nullptr ? mission->card : how.card);
  VisitPlan::Of of;
  of.vessel = card.vessel->label(language.code()).title;
  if (mission != nullptr) of.mission = mission->mission->title_in(language.code());
  of.built = mission == nullptr && card.built;
  if (card.wheel.kiln)
    of.glaze = kiosk.glazes()[static_cast<std::size_t>(how.glaze)].name_in(language.code());
  const VisitPlan plan(language, of, how.strokes);
  const double hold = kiosk.exhibit().access.hold_to_speak;
  if (hold <= 0)
    return problem("[access] hold_to_speak", "It is 0, so this visitor cannot begin.",
                   "Write 3, or remove the key.");
  BlindVisitor blind(plan, hold);
  SwitchVisitor one_switch(plan, hold);

  std::set<std::string> seen;
  ScreenId screen = ScreenId::attract;
  bool begun = false;
  double entered = 0;
  const double started = files::monotonic_seconds();
  for (int n = 1;; ++n) {
    const double now = n * kAidedTicks * 1e-3;
    fresh.clear();
    kiosk.advance(kAidedTicks);
    if (!kiosk.frame(now, how.realtime))
      return problem("the window", "It was closed during the visit.", "Leave it open.", 1);
    screens::Visit& visit = kiosk.visit();
    if (visit.screen() == ScreenId::fault)
      return problem("the visit", "The kiosk shows its fault screen.", "Its log says why.", 1);
    if (visit.screen() != screen) {
      screen = visit.screen();
      entered = now;
    }
    begun = begun || screen != ScreenId::attract;
    if (begun && screen == ScreenId::attract) break;
    const screens::ScreenText reading = visit.reading();
    const std::string name = std::string(name_of(screen)) + (reading.working ? "_at_work" : "");
    if (now - entered > kFadedIn && seen.insert(name).second) passed(name);
    for (const access::Utterance& one : fresh) blind.hear(one, now);
    if (!blind.lost().empty())
      return problem("the visit", "No spoken text says where \"" + blind.lost() + "\" is.",
                     "This is a fault of the program: please report it.", 1);
    // The keepsake is being saved, so stay.
    const bool waits =
        screen == ScreenId::keepsake && !(kiosk.doing().kept && kiosk.doing().kept->saved);
    if (now > kAttractSeen && !waits)
      for (const view::InputEvent& event :
           how.blind ? blind.step(now)
                     : one_switch.step(reading, kiosk.access_input().shown(), now))
        kiosk.access_input().input(event, visit, kiosk.renderer().width(),
                                   kiosk.renderer().height(), now);
    if (now > kAidedTooLong)
      return problem("the visit", "It did not end within an hour.",
                     "This is a fault of the program: please report it.", 1);
    if (kiosk.doing().saving) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (how.realtime)
      std::this_thread::sleep_for(
          std::chrono::duration<double>(std::max(0.0, started + now - files::monotonic_seconds())));
  }
  kiosk.access_input().listen({});
  if (!kiosk.doing().kept)
    return problem("the visit", "It went back to the start before the keepsake was made.",
                   "This is a fault of the program: please report it.", 1);
  return said;
}

}  // namespace onggi::rehearsal
