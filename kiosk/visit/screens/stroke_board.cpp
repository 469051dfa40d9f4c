#include "kiosk/visit/screens/stroke_board.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kiosk/visit/screens/measured_pot.h"
#include "kiosk/visit/screens/target_line.h"

namespace onggi::screens {

using device::Ask;
using device::WallPart;

namespace {

constexpr std::array<const char*, device::kWallParts> kPartNames{"foot", "low", "middle",
                                                                 "high", "rim", "all"};
constexpr std::array<const char*, device::kAsks> kAskNames{"open", "widen", "narrow", "pull",
                                                           "even"};
constexpr const char *kPartControl = "throw.part.", *kAskControl = "throw.ask.";

std::string part_name(const Desk& desk, WallPart part) {
  return desk.say(std::string("stroke.") + kPartNames[static_cast<std::size_t>(part)]);
}
std::string ask_name(const Desk& desk, Ask ask) {
  return desk.say(std::string("stroke.") + kAskNames[static_cast<std::size_t>(ask)]);
}

/// "8 mm too narrow", at the real vessel's size; in percent of its width if that size is only a
/// guess.
std::string off_in_words(const Desk& desk, const PartOff& off) {
  if (off.near) return desk.say("stroke.near");
  const ShelfCard* card = desk.shelf_card(desk.card);
  const bool known =
      card == nullptr || card->vessel == nullptr || content::is_known(card->vessel->size_from);
  const std::string key = std::string("off.") + (off.off > 0 ? "wide" : "narrow");
  const auto whole = [](double x) { return std::to_string(std::max(1L, std::lround(x))); };
  if (known) {
    const double scale = card != nullptr && card->scale > 0 ? 1 / card->scale : 1;
    return desk.say(key, {{"mm", whole(1000 * std::abs(off.off) * scale)}});
  }
  const double share = std::abs(off.off) / (2 * card->target.max_radius());
  return desk.say(key + "_part", {{"percent", whole(100 * share)}});
}

}  // namespace

std::vector<PartOff> parts_off(const ShelfCard* card, const Profile& made) {
  constexpr int kSteps = 100;
  std::vector<PartOff> out;
  if (card == nullptr) return out;
  const Profile& target = card->target;
  const double near_enough = tolerance(target);
  for (int n = 0; n + 1 < device::kWallParts; ++n) {
    PartOff one{static_cast<WallPart>(n)};
    double sum = 0, weights = 0;
    for (int i = 0; i <= kSteps && !made.points.empty(); ++i) {
      const double share = static_cast<double>(i) / kSteps;
      const double weight = device::weight_of(one.part, share);
      sum += weight *
             (made.outer_at(share * made.height()) - target.outer_at(share * target.height()));
      weights += weight;
    }
    const double mean = weights > 0 ? sum / weights : 0;
    one.off = 2 * mean;
    one.near = std::abs(mean) <= near_enough;
    out.push_back(one);
  }
  return out;
}

bool StrokeBoard::wanted(const Desk& desk) {
  const auto screen = desk.screen();
  return screen.spoken || screen.one_switch;
}

std::optional<Ask> StrokeBoard::press(const std::string& control) {
  for (int n = 0; n < device::kWallParts; ++n)
    if (control == kPartControl + std::to_string(n)) part_ = static_cast<WallPart>(n);
  if (control == "throw.tell") telling_ = ++asked_ > 0;
  for (int n = 0; n < device::kAsks; ++n) {
    if (control != kAskControl + std::to_string(n)) continue;
    telling_ = false;
    begun_ = true;
    return last_ = static_cast<Ask>(n);
  }
  return std::nullopt;
}

std::string StrokeBoard::advice(const Desk& desk) {
  struct Nearer {
    const char* hint;
    Ask ask;
    WallPart part;
  };
  static constexpr std::array<Nearer, 5> kNearer{{{"mission.more", Ask::widen, WallPart::all},
                                                  {"mission.less", Ask::narrow, WallPart::all},
                                                  {"mission.wider", Ask::widen, WallPart::rim},
                                                  {"mission.closer", Ask::narrow, WallPart::rim},
                                                  {"mission.taller", Ask::pull, WallPart::all}}};
  const std::string hint = MeasuredPot::hint(desk);
  for (const Nearer& one : kNearer)
    if (hint == one.hint)
      return desk.say("stroke.try",
                      {{"what", ask_name(desk, one.ask)}, {"where", part_name(desk, one.part)}});
  return hint.empty() ? hint : desk.say(hint);  // near, or too high: no stroke lowers a pot
}

std::vector<std::string> StrokeBoard::told(const Desk& desk, const std::vector<PartOff>& parts,
                                           std::size_t most) {
  if (std::vector<std::string> figures = MeasuredPot::sentences(desk); !figures.empty()) {
    figures.push_back(advice(desk));
    return figures;
  }
  std::vector<PartOff> worst;
  for (const PartOff& part : parts)
    if (!part.near) worst.push_back(part);
  std::stable_sort(worst.begin(), worst.end(), [](const PartOff& a, const PartOff& b) {
    return std::abs(a.off) > std::abs(b.off);
  });
  std::vector<std::string> out;
  for (std::size_t n = 0; n < std::min(most, worst.size()); ++n)
    out.push_back(desk.say("stroke.differs", {{"where", part_name(desk, worst[n].part)},
                                              {"how", off_in_words(desk, worst[n])}}));
  if (out.empty()) out.push_back(desk.say("stroke.all_near"));
  return out;
}

void StrokeBoard::lay_out(Column& column, const Desk& desk, const std::vector<Button>& ways,
                          const std::vector<PartOff>& parts, bool working,
                          const std::string& hint) const {
  const TypeScale& t = column.page().type();
  const bool mirrored = column.page().where().mirrored;
  const auto grid = [&](const std::vector<Button>& cells) {
    column.foot_grid(cells, t.target, mirrored);
    column.foot_space(t.gap * 1.2f);
  };
  std::vector<Button> beside = ways, what, where;
  for (int n = 0; n < device::kAsks; ++n) {
    const Ask ask = static_cast<Ask>(n);
    const bool made = working && ask == last_;
    what.push_back({kAskControl + std::to_string(n), ask_name(desk, ask),
                    made ? Look::chosen : Look::outline});
  }
  for (int n = 0; n < device::kWallParts; ++n) {
    const WallPart part = static_cast<WallPart>(n);
    where.push_back({kPartControl + std::to_string(n), part_name(desk, part),
                     part == part_ ? Look::chosen : Look::outline});
    where.back().on = part == part_;
    if (static_cast<std::size_t>(n) < parts.size() && desk.described() == nullptr)
      where.back().note = off_in_words(desk, parts[static_cast<std::size_t>(n)]);
  }
  const Button tell{"throw.tell", desk.say("stroke.tell"), telling_ ? Look::chosen : Look::outline};
  beside.push_back(tell);
  for (auto* cells : {&beside, &what, &where})
    for (Button& cell : *cells) cell.tight = true;
  // If a row cannot hold all of its buttons: strokes and questions together are six, which fill two
  // or three rows evenly.
  if (column.abreast(beside) < beside.size() || column.abreast(what) < what.size()) {
    what.push_back(beside.back());
    beside.pop_back();
  }
  grid(beside);
  grid(what);
  grid(where);
  std::string sentence = hint;
  if (working) {
    sentence = desk.say("stroke.works",
                        {{"what", ask_name(desk, last_)}, {"where", part_name(desk, part_)}});
  } else if (telling_) {
    sentence.clear();
    for (const std::string& one : told(desk, parts))
      sentence += (sentence.empty() ? "" : " ") + one;
  }
  column.page().tell(column.rest().y - 1, desk.heading());
  if (const auto figures = MeasuredPot::sentences(desk); !figures.empty() && !telling_)
    column.text(figures.front(), t.body);
  column.text(sentence, t.body);
  column.check();
}

}  // namespace onggi::screens
