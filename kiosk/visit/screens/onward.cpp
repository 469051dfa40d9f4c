#include "kiosk/visit/screens/onward.h"

#include <vector>

#include "kiosk/collection/score/hardness.h"

namespace onggi::screens {

namespace {

constexpr int kGood = 4, kPoor = 2;  // stars

std::optional<Onward> by_hardness(const Desk& desk, bool harder) {
  const ShelfCard* own = desk.shelf_card(desk.card);
  if (own == nullptr || own->target.points.empty()) return std::nullopt;
  std::vector<const Profile*> shelf;
  for (int card = 0; card < desk.cards(); ++card) shelf.push_back(&desk.shelf_card(card)->target);
  const auto next = score::next_in_hardness(own->target, harder, shelf);
  if (!next) return std::nullopt;
  return Onward{{static_cast<int>(*next), -1}, harder ? "result.harder" : "result.easier"};
}

std::optional<Onward> mission_after(const Desk& desk, int mission) {
  if (mission + 1 >= desk.missions()) return std::nullopt;
  return Onward{{desk.mission_card(mission + 1).card, mission + 1}, "result.mission"};
}

}  // namespace

std::string Onward::words(const Desk& desk) const {
  const std::string what =
      of.mission >= 0 ? desk.mission_card(of.mission).mission->title_in(desk.words().code())
                      : desk.label(of.card).title;
  return desk.say(key, {{"what", what}});
}

std::optional<Onward> onward_from(const Desk& desk) {
  if (desk.score.stars <= kPoor)
    return desk.on() == nullptr ? by_hardness(desk, false) : std::nullopt;
  if (desk.score.stars < kGood) return std::nullopt;
  if (desk.on() != nullptr) return mission_after(desk, desk.mission);
  const auto harder = by_hardness(desk, true);
  return harder ? harder : mission_after(desk, -1);
}

}  // namespace onggi::screens
