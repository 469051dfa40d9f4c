#include "kiosk/exhibit/rehearsal/scripted_visitor.h"

#include <algorithm>
#include <utility>

#include "engine/script/script.h"
#include "kiosk/exhibit/rehearsal/touch_at.h"

namespace onggi::rehearsal {

using screens::ScreenId;

namespace {
constexpr double kInTheFire = 3.6, kOutOfIt = 5.0;  // s: the glowing pot, then the glazed one
constexpr double kSurprise = 1.5;     // s of surprise before touching the offered button
constexpr double kWorked = 0.004;     // m off the lump: the lump is smooth too, but it is no pot
constexpr double kStuck = 60.0;       // s without any progress of the script
constexpr double kKeepTimeout = 5.0;  // s of visit within which a save must begin
}  // namespace

ScriptedVisitor::ScriptedVisitor(exhibit::Kiosk& kiosk, Plan plan,
                                 std::function<void(const std::string&)> passed)
    : kiosk_(kiosk), plan_(std::move(plan)), passed_(std::move(passed)) {}

Result<void> ScriptedVisitor::touch(const std::string& control) {
  auto rect = way_to(kiosk_.visit(), control);
  if (rect)
    then_ = control;  // the next frame touches it
  else
    rect = kiosk_.visit().control(control);
  if (!rect)
    return problem("screen " + std::string(screens::name_of(screen_)),
                   "The scripted visitor does not find the control " + control + ".",
                   "This is a fault of the program: please report it.", 1);
  touch_at(kiosk_.visit(), rect->x + rect->w / 2, rect->y + rect->h / 2, now_);
  return {};
}

void ScriptedVisitor::enter(ScreenId screen, double now) {
  screen_ = screen;
  entered_ = now;
  touched_ = label_open_ = playing_ = half_shown_ = false;
}

Result<void> ScriptedVisitor::step(double now) {
  now_ = now;
  if (!then_.empty()) return touch(std::exchange(then_, {}));
  const ScreenId screen = kiosk_.visit().screen();
  if (entered_ < 0 || screen != screen_) {
    const bool came_back = entered_ >= 0 && screen == ScreenId::attract;
    enter(screen, now);
    if (came_back && !kept_seen_)
      return problem("the visit", "It went back to the start before the keepsake was made.",
                     "This is a fault of the program: please report it.", 1);
  }
  if (done_ || now - entered_ < plan_.linger) return {};

  switch (screen) {
    case ScreenId::attract:
      if (touched_) return {};
      if (kept_seen_) {
        pass("attract_again");
        done_ = true;
        return {};
      }
      touched_ = true;
      pass("attract");
      return touch(kiosk_.visit().reading().first);
    case ScreenId::clay:
      // Where strokes are made by buttons, its keyboard begins with a stroke.
      if (std::exchange(touched_, true)) return {};
      return touch("clay.on");
    case ScreenId::choose:
      return on_choose();
    case ScreenId::throwing:
      return on_throw(now);
    case ScreenId::decorate:
      return on_decorate();
    case ScreenId::kiln:
      return on_kiln();
    case ScreenId::keepsake:
      return on_keepsake();
    case ScreenId::fault:
      pass("fault");
      return problem("the visit", "The kiosk shows its fault screen.", "Its log says why.", 1);
    default:
      break;
  }
  // A screen that asks for nothing but to go on: where its keyboard begins.
  if (std::exchange(touched_, true)) return {};
  pass(std::string(name_of(screen)));
  return touch(kiosk_.visit().reading().first);
}

Result<void> ScriptedVisitor::on_choose() {
  const std::string card = plan_.mission >= 0 ? "choose.mission." + std::to_string(plan_.mission)
                                              : "choose.card." + std::to_string(plan_.card);
  if (!label_open_) {
    if (!kiosk_.visit().control(card)) {
      entered_ = now_;  // the next page fades in
      return touch("choose.next");
    }
    pass("choose");
    label_open_ = true;
    entered_ = now_;  // look at the label like at a screen
    return touch(card);
  }
  if (touched_) return {};
  touched_ = true;
  pass("label");
  const ScriptInfo* script = find_script(plan_.script);
  const bool builds = plan_.naive || (script != nullptr && script->shows == BuildingDef::kName);
  return touch(builds && kiosk_.visit().control("choose.build") ? "choose.build" : "choose.throw");
}

Result<void> ScriptedVisitor::on_naive(double now) {
  if (!hands_) {
    pass("throw_begin");
    hands_.emplace(plan_.seed, plan_.naive->seconds, plan_.naive->pointer);
    playing_ = true;
    entered_ = looked_at_ = now;
    looks_.emplace();
    return {};
  }
  const auto sight = kiosk_.visit().sight();
  if (!sight) {
    // The pot fell or tore: the visitor is surprised, then takes the offered way back.
    if (troubled_at_ < 0) troubled_at_ = now;
    if (now - troubled_at_ < kSurprise) return {};
    troubled_at_ = -1;
    return touch(kiosk_.visit().control("throw.restore") ? "throw.restore" : "throw.done");
  }
  troubled_at_ = -1;
  if (now - looked_at_ >= 0.5) {
    looked_at_ = now;
    looks_->end = smoothness(*sight->made);
    if (lump_.points.empty()) lump_ = *sight->made;
    if (!looks_->handsome_at && looks_smooth(looks_->end) &&
        outline_distance(*sight->made, lump_) > kWorked)
      looks_->handsome_at = now - entered_;
  }
  if (!half_shown_ && progress() > 0.5) {
    half_shown_ = true;
    pass("throw");
  }
  const NaiveHands::Move move = hands_->step(now - entered_, *sight, kiosk_.renderer().width());
  for (const view::InputEvent& event : move.events) kiosk_.visit().input(event, now);
  if (hands_->done()) {
    looks_->end = smoothness(*sight->made);
    pass("throw_done");
  }
  if (!move.control.empty()) return touch(move.control);
  return {};
}

Result<void> ScriptedVisitor::on_two(double now) {
  if (!two_) {
    pass("throw_begin");
    two_.emplace();
    playing_ = true;
    entered_ = now;
    return {};
  }
  if (touched_) return {};
  const auto sight = kiosk_.visit().sight();
  if (!sight) return touch("throw.restore");
  if (!half_shown_ && progress() > 0.5) {
    half_shown_ = true;
    pass("throw");
  }
  for (const view::InputEvent& event : two_->step(now - entered_, *sight))
    kiosk_.visit().input(event, now);
  if (!two_->done(now - entered_)) return {};
  touched_ = true;
  pass("throw_done");
  return touch("throw.done");
}

Result<void> ScriptedVisitor::on_throw(double now) {
  if (plan_.two) return on_two(now);
  if (plan_.naive) return on_naive(now);
  if (!playing_) return begin_throwing(now);
  if (hand_ && !hand_->step(now - std::exchange(moved_at_, now), kiosk_.wheel_host()))
    return problem("the wheel", "It did not answer the scripted visitor within a second.",
                   "Look for a stuck 1 kHz loop.", 1);
  if (progress() > furthest_) {
    furthest_ = progress();
    furthest_at_ = now;
  } else if (progress() < 1.0 && now - furthest_at_ > kStuck) {
    return problem("the script " + plan_.script,
                   "It got no further for a minute: the wheel turns too slowly for it.",
                   "Set max_speed in the scene's [wheel] to 1 or more.");
  }
  if (touched_ && now - furthest_at_ > kStuck)
    return problem("the script " + plan_.script,
                   "Its hands never touched the clay, and only a touched pot can be called done.",
                   "Choose a script that works in the scene of this vessel.");
  if (!half_shown_ && progress() > 0.5) {
    half_shown_ = true;
    pass("throw");
  }
  // The hands are real input, so a throwing visitor is not idle.
  view::InputEvent moved;
  moved.kind = view::InputEvent::Kind::pointer_move;
  kiosk_.visit().input(moved, now);
  if (progress() < 1.0 || touched_) return {};
  touched_ = true;
  pass("throw_done");
  return touch("throw.done");
}

Result<void> ScriptedVisitor::begin_throwing(double now) {
  const auto& target = kiosk_.card(kiosk_.doing().card)->target;
  auto script = make_script(plan_.script, {kiosk_.doing().pot, &target, plan_.seed, plan_.pace});
  if (!script) return tl::unexpected(script.error());
  pass("throw_begin");
  if (plan_.hand == Plan::Hand::script)
    kiosk_.wheel_host().play(std::move(*script));
  else if (plan_.hand != Plan::Hand::device_alone)
    hand_ = std::make_unique<VisitorsHand>(std::move(*script), plan_.hand == Plan::Hand::pointer
                                                                   ? VisitorsHand::By::pointer
                                                                   : VisitorsHand::By::device);
  playing_ = true;
  furthest_ = -1.0;
  entered_ = moved_at_ = furthest_at_ = now;
  return {};
}

double ScriptedVisitor::progress() const {
  if (hands_) return std::min(1.0, (now_ - entered_) / plan_.naive->seconds);
  if (two_) return std::min(1.0, (now_ - entered_) / TwoPlayerScript::kSeconds);
  if (plan_.hand == Plan::Hand::device_alone) return (now_ - entered_) / plan_.watch;
  if (hand_) return hand_->done() ? 1.0 : hand_->progress();
  const loop::LoopStatus status = kiosk_.wheel_host().status();
  return status.script_done ? 1.0 : std::min(0.999, status.script_progress);
}

Result<void> ScriptedVisitor::on_decorate() {
  if (touched_) return {};
  const auto* pot = kiosk_.visit().decorated_pot();
  if (plan_.decorate && pot != nullptr && kiosk_.shown().pot) {
    if (!decorating_ && !clumsy_) {
      pass("decorate_begin");
      if (plan_.clumsy)
        clumsy_.emplace(plan_.seed, *plan_.clumsy);
      else
        decorating_.emplace(*pot);
    }
    if (!decorated(*pot)) return decorate(*pot);
  }
  touched_ = true;
  pass("decorate");
  return touch("decorate.on");
}

bool ScriptedVisitor::decorated(const decorating::DecoratedPot& pot) const {
  return (clumsy_ ? clumsy_->done() : decorating_->done()) && !pot.busy();
}

Result<void> ScriptedVisitor::decorate(const decorating::DecoratedPot& pot) {
  const view::Camera& camera = kiosk_.shown().pot->camera;
  const DecoratingHand::Act act =
      clumsy_ ? clumsy_->step(now_, pot, camera) : decorating_->step(now_, pot, camera);
  if (!act.control.empty()) return touch(act.control);
  view::InputEvent e;
  e.kind = !act.finger ? view::InputEvent::Kind::pointer_up
           : finger_   ? view::InputEvent::Kind::pointer_move
                       : view::InputEvent::Kind::pointer_down;
  const auto at = act.finger ? act.finger : finger_;
  finger_ = act.finger;
  if (!at) return {};
  e.x = at->first, e.y = at->second;
  kiosk_.visit().input(e, now_);
  return {};
}

/// Chooses a glaze, waits while the pot is in the fire, and again when it is out.
Result<void> ScriptedVisitor::on_kiln() {
  if (touched_) return {};
  if (!half_shown_) {
    half_shown_ = true;
    pass("kiln");
    entered_ = now_ - plan_.linger + kInTheFire;
    const std::string glaze = "kiln.glaze." + std::to_string(plan_.glaze);
    if (!kiosk_.visit().control(glaze))
      return problem("--glaze", "The pot has glaze of its own, so the kiln does not offer none.",
                     "Name another glaze, or leave --decorate out.");
    return touch(glaze);
  }
  if (!label_open_) {
    label_open_ = true;
    pass("kiln_fire");
    entered_ = now_ - plan_.linger + kOutOfIt;
    return {};
  }
  touched_ = true;
  pass("kiln_fired");
  return touch("kiln.keep");
}

Result<void> ScriptedVisitor::on_keepsake() {
  if (touched_) return {};
  const exhibit::KeptVisit* const kept = kiosk_.doing().kept;
  if (!kept || !kept->saved) {
    // A running save always ends, however slow the machine is.
    if (!kiosk_.doing().saving && now_ - entered_ > kKeepTimeout)
      return problem("the keepsake", "The kiosk is not saving it.",
                     "This is a fault of the program: please report it.", 1);
    return {};
  }
  // A visitor who takes everything waits for the turning picture too.
  if (kiosk_.doing().turning) return {};
  if (!kept_seen_) {
    kept_seen_ = true;  // stay once more, so that its words are on the screen
    entered_ = now_;
    return {};
  }
  touched_ = true;
  pass("keepsake");
  if (!*kept->saved) return tl::unexpected(kept->saved->error());
  return touch("keepsake.done");
}

}  // namespace onggi::rehearsal
