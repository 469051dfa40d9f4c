#include "kiosk/exhibit/rehearsal/aided_visitor.h"

#include <algorithm>
#include <array>

#include "kiosk/exhibit/rehearsal/parse_spoken_advice.h"

namespace onggi::rehearsal {

using device::Ask;
using device::WallPart;
using view::InputEvent;
using view::Key;

namespace {

constexpr int kOpenings = 2;              // every pot begins with this many opening strokes
constexpr double kStrokePatience = 30.0;  // s for a stroke to end
constexpr int kMostTabs = 60;
// The spoken texts that mean that strokes can do no more.
constexpr std::array<const char*, 3> kNear{"stroke.all_near", "mission.close", "mission.lower"};

bool begins_with(const std::string& text, const std::string& name) {
  return text.starts_with(name) &&
         (text.size() == name.size() || text[name.size()] == ',' || text[name.size()] == '.');
}

InputEvent event(InputEvent::Kind kind, Key key) {
  InputEvent e;
  e.kind = kind;
  e.key = key;
  e.x = e.y = 2;
  return e;
}

}  // namespace

VisitPlan::VisitPlan(const content::Language& language, Of of, int strokes)
    : language_(&language), of_(std::move(of)), most_(strokes) {}

std::vector<std::string> VisitPlan::wanted() const {
  const content::Language& l = *language_;
  switch (step_) {
    case Step::card:
      return {of_.mission.empty() ? of_.vessel : l.say("mission.card") + ", " + of_.mission};
    case Step::take:
      return {l.say(!of_.mission.empty() ? "mission.begin"
                    : of_.built          ? "choose.throw_it"
                                         : "choose.throw")};
    case Step::pot:
      if (!difference_) return {};
      return {part_set_ ? name_of_ask(difference_->ask, l) : name_of_part(difference_->part, l)};
    case Step::finish:
      return {l.say("throw.done")};
    case Step::result:
      return {l.say("result.decorate"), l.say("result.fire"), l.say("result.keep")};
    case Step::decorate:
      return {l.say("decorate.skip")};
    case Step::glaze:
      return {of_.glaze};
    case Step::keep:
      return {l.say("kiln.keep")};
    case Step::leave:
      return {l.say("keepsake.done")};
    case Step::over:
      break;
  }
  return {};
}

void VisitPlan::chosen(const std::string& name) {
  if (step_ == Step::pot) {
    if (!part_set_) {
      part_set_ = true;
      return;
    }
    evened_ = difference_->ask == Ask::even;
    difference_.reset();
    part_set_ = false;
    ++strokes_;
    return;
  }
  if (step_ == Step::result) {
    step_ = name == language_->say("result.decorate") ? Step::decorate
            : name == language_->say("result.fire")   ? Step::glaze
                                                      : Step::leave;
    return;
  }
  step_ = step_ == Step::decorate && of_.glaze.empty()
              ? Step::leave
              : static_cast<Step>(static_cast<int>(step_) + 1);
}

bool VisitPlan::told(const std::string& text) {
  if (step_ != Step::pot || difference_) return false;
  const auto off = understand(text, *language_);
  const auto advised = stroke_advised(text, *language_);
  const bool close = std::any_of(kNear.begin(), kNear.end(), [&](const char* key) {
    return text.find(language_->say(key)) != std::string::npos;
  });
  if (!off && !advised && !close) return false;
  if (strokes_ < kOpenings) {
    difference_ = Wish{WallPart::all, Ask::open};
  } else if (advised && strokes_ < most_) {
    difference_ = Wish{advised->part, advised->ask};
  } else if (off && strokes_ < most_) {
    const Ask ask = off->wide ? Ask::narrow : Ask::widen;
    difference_ = Wish{off->all_so ? WallPart::all : off->part, ask};
  } else if (!evened_) {
    difference_ = Wish{WallPart::all, Ask::even};
  } else {
    step_ = Step::finish;
  }
  return true;
}

std::vector<InputEvent> BlindVisitor::press(Key key) {
  ++presses_;
  return {event(InputEvent::Kind::key_down, key), event(InputEvent::Kind::key_up, key)};
}

void BlindVisitor::hear(const access::Utterance& said, double now) {
  if (said.text.empty()) return;
  begun_ = true;
  on_ = said.text;
  if (plan_.told(said.text)) waits_since_ = -1;
  pressed_at_ = std::max(pressed_at_, now - 0.5 * kPace);
}

std::vector<InputEvent> BlindVisitor::step(double now) {
  if (began_at_ < 0) {
    began_at_ = pressed_at_ = now;
    return {event(InputEvent::Kind::key_down, Key::enter)};
  }
  if (now - began_at_ < hold_ + 0.3) return {};
  if (presses_ == 0) {
    ++presses_;
    pressed_at_ = now;
    return {event(InputEvent::Kind::key_up, Key::enter)};
  }
  if (!begun_ || plan_.over() || now - pressed_at_ < kPace) return {};
  pressed_at_ = now;
  const std::vector<std::string> wanted = plan_.wanted();
  if (wanted.empty()) {
    // A finished stroke is announced; otherwise ask for one.
    if (waits_since_ < 0) waits_since_ = now;
    if (plan_.strokes() > 0 && now - waits_since_ < kStrokePatience) return {};
    waits_since_ = now;
    return press(Key::tell);
  }
  for (const std::string& name : wanted) {
    // A page is read aloud and ends with its focused control.
    const auto last = on_.rfind(". ");
    if (!begins_with(on_, name) &&
        (last == std::string::npos || !begins_with(on_.substr(last + 2), name)))
      continue;
    plan_.chosen(name);
    tabs_ = 0;
    on_.clear();
    waits_since_ = -1;
    return press(Key::enter);
  }
  if (++tabs_ > kMostTabs) lost_ = wanted.front();
  if (tabs_ > kMostTabs / 3 && begins_with(on_, plan_.instead())) {
    tabs_ = 0;
    return press(Key::enter);
  }
  return press(Key::next);
}

std::vector<InputEvent> SwitchVisitor::step(const screens::ScreenText& reading,
                                            const std::vector<std::string>& shown, double now) {
  if (began_at_ < 0) {
    began_at_ = now;
    return {event(InputEvent::Kind::pointer_down, Key::none)};
  }
  if (!begun_) {
    if (now - began_at_ < 2 * hold_ + 0.3) return {};
    begun_ = true;
    return {event(InputEvent::Kind::pointer_up, Key::none)};
  }
  if (!reading.working && plan_.wonders()) plan_.told(access::joined(reading.differences));
  if (shown != shown_) {
    shown_ = shown;
    shown_since_ = now;
  }
  const bool seen = shown_since_ >= 0 && now - shown_since_ >= kReaction;
  if (!seen || plan_.over() || shown.empty()) return {};
  std::vector<std::string> wanted = plan_.wanted();
  const auto named = [&](const std::string& name) {
    return std::find_if(reading.controls.begin(), reading.controls.end(),
                        [&](const screens::Control& c) { return begins_with(c.words, name); });
  };
  if (!wanted.empty() && std::none_of(wanted.begin(), wanted.end(), [&](const std::string& name) {
        return named(name) != reading.controls.end();
      }))
    wanted = {plan_.instead()};
  for (const std::string& name : wanted) {
    const auto control = named(name);
    if (control == reading.controls.end() ||
        std::find(shown.begin(), shown.end(), control->id) == shown.end())
      continue;
    if (shown.size() == 1 && name != plan_.instead()) plan_.chosen(name);
    shown_since_ = now + 10 * kReaction;  // not again before the screen changes
    shown_ = {"-"};
    ++presses_;
    return {event(InputEvent::Kind::pointer_down, Key::none),
            event(InputEvent::Kind::pointer_up, Key::none)};
  }
  return {};
}

}  // namespace onggi::rehearsal
