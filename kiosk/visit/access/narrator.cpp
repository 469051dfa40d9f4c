#include "kiosk/visit/access/narrator.h"

#include <algorithm>
#include <utility>

namespace onggi::access {

using screens::Control;
using screens::ScreenId;
using screens::ScreenText;

namespace {

constexpr int kNewsWeight = 1, kDoneWeight = 2, kWarningWeight = 3;
constexpr double kALetter = 0.08, kAWideLetter = 0.25, kAtLeast = 1.5;  // s of speech

/// Removes numbers, so that a countdown counts as one sentence.
std::string without_numbers(const std::string& sentence) {
  std::string out;
  for (const char c : sentence)
    if (c < '0' || c > '9') out += c;
  return out;
}

double length_of(const std::string& text) {
  double s = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) s += kALetter;
    if (byte >= 0xC0) s += byte >= 0xE0 ? kAWideLetter : kALetter;
  }
  return std::max(s, kAtLeast);
}

const Control* find(const ScreenText& reading, const std::string& id) {
  for (const Control& control : reading.controls)
    if (control.id == id) return &control;
  return nullptr;
}

/// True for controls of every screen: they do not tell which screen it is.
bool on_every_screen(const std::string& id) {
  return id == "back" || id == "help" || id == "comfort" || id.starts_with("language");
}

}  // namespace

bool Narrator::another_page(const ScreenText& reading) const {
  const bool any = std::any_of(
      reading.controls.begin(), reading.controls.end(),
      [&](const Control& c) { return !on_every_screen(c.id) && controls_.count(c.id) > 0; });
  const bool own = std::any_of(reading.controls.begin(), reading.controls.end(),
                               [](const Control& c) { return !on_every_screen(c.id); });
  return own && !any;
}

std::string Narrator::page(const ScreenText& reading) const { return joined(reading.words); }

std::string Narrator::focus(const ScreenText& reading,
                            const std::vector<std::string>& shown) const {
  if (reading.one_switch) {
    std::string all;
    for (const std::string& id : shown)
      if (const Control* c = find(reading, id); c != nullptr)
        all += (all.empty() ? "" : ", ") +
               (shown.size() == 1 ? spoken(*c, *reading.language) : c->words);
    return all;
  }
  const Control* on = find(reading, reading.focus);
  return on != nullptr ? spoken(*on, *reading.language) : std::string();
}

/// The part of a control whose change is announced: its name and whether it is on.
std::string Narrator::state_of(const ScreenText& reading,
                               const std::vector<std::string>& shown) const {
  if (reading.one_switch) {
    std::string all;
    for (const std::string& id : shown) all += id + ' ';
    return all;
  }
  const Control* on = find(reading, reading.focus);
  return on == nullptr ? std::string() : on->id + on->words + (on->on ? *on->on ? "+" : "-" : "");
}

std::string Narrator::news(const ScreenText& reading, double now) {
  std::vector<std::string> fresh;
  std::set<std::string> seen;
  for (const std::string& sentence : reading.words) {
    const std::string bare = without_numbers(sentence);
    seen.insert(bare);
    if (sentences_.count(bare) == 0)
      fresh.push_back(sentence);
    else if (reading.over == "idle" && bare != sentence && now - counted_at_ > kCount)
      fresh.push_back(sentence);
  }
  if (fresh.empty()) return {};
  if (reading.over == "idle") counted_at_ = now;
  sentences_ = std::move(seen);
  return joined(fresh);
}

Narrator::Wish Narrator::wish(const ScreenText& reading, const std::vector<std::string>& shown,
                              double now) {
  const std::string place =
      std::string(name_of(reading.screen)) + ' ' + reading.over + ' ' + reading.language->code();
  const std::string on = focus(reading, shown);
  const bool turned = place != place_ || another_page(reading);
  const bool stopped = std::exchange(working_, reading.working) && !reading.working;
  const bool asked = std::exchange(asked_, reading.asked) != reading.asked && !turned;
  const std::string first =
      std::exchange(hold_on_, false) ? reading.language->say("access.hold_on") : "";
  if (turned || std::exchange(again_, false)) {
    place_ = place;
    again_ = false;
    under_way_ = 0;  // the page of that utterance is gone
    controls_.clear();
    for (const Control& c : reading.controls) controls_.insert(c.id);
    sentences_.clear();
    for (const std::string& sentence : reading.words) sentences_.insert(without_numbers(sentence));
    focus_ = state_of(reading, shown);
    news_at_ = counted_at_ = now;
    waiting_.clear();
    std::string text = page(reading);
    if (!begun_ && !reading.unasked) text = joined({reading.language->say("access.begun"), text});
    begun_ = true;
    return {joined({first, text, on}), reading.over == "idle" ? kWarningWeight : kDoneWeight};
  }
  for (const Control& c : reading.controls) controls_.insert(c.id);
  if (!first.empty()) return {first, kDoneWeight};
  if (asked || (stopped && !reading.differences.empty())) {
    news(reading, now);  // this utterance includes it
    news_at_ = now;
    return {joined(reading.differences), kDoneWeight};
  }
  if (const std::string state = state_of(reading, shown); state != focus_) {
    focus_ = state;
    // The switch moves on by itself. Its rows do not interrupt an answer to the visitor, and are
    // not spoken while hands work.
    const bool passing = reading.one_switch && shown.size() != 1;
    const bool heavier = under_way_ != 0 && now < until_ && weight_ > kNewsWeight;
    if (passing && (reading.working || heavier)) return {};
    if (!on.empty()) return {on, passing ? kNewsWeight : kDoneWeight};
  }
  if (now - news_at_ < kNews) return {};
  if (std::string fresh = news(reading, now); !fresh.empty()) {
    news_at_ = now;
    return {fresh, kNewsWeight};
  }
  return {};
}

std::optional<Utterance> Narrator::look(const ScreenText& reading,
                                        const std::vector<std::string>& shown, double now) {
  if (!reading.spoken || reading.language == nullptr || reading.screen == ScreenId::attract) {
    if (!begun_) return std::nullopt;
    forget();
    return Utterance{"", "", kWarningWeight, ++said_};
  }
  Wish next = wish(reading, shown, now);
  const bool speaks = under_way_ != 0 && now < until_;
  if (next.weight == kNewsWeight && speaks && weight_ > kNewsWeight) {
    waiting_ = std::exchange(next.text, {});
  } else if (next.text.empty() && !speaks && !waiting_.empty()) {
    next = {std::exchange(waiting_, {}), kNewsWeight};
  }
  if (next.text.empty() || (speaks && next.weight < weight_)) return std::nullopt;
  under_way_ = ++said_;
  weight_ = next.weight;
  until_ = now + length_of(next.text);
  return Utterance{reading.language->code(), std::move(next.text), next.weight, said_};
}

void Narrator::ended(std::uint64_t id) {
  if (id == under_way_) under_way_ = 0;
}

}  // namespace onggi::access
