#include "kiosk/exhibit/composition/missions.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "engine/profile/mesh.h"
#include "engine/scene/jar.h"
#include "kiosk/exhibit/composition/shelf.h"
#include "kiosk/ground/files/log.h"

namespace onggi::exhibit {

using settings::Mission;

namespace {

constexpr int kRound = 96;  // sectors of a described jar's picture

int number_of(const files::LocalMoment& day) {
  return (day.year * 100 + day.month) * 100 + day.day;
}

/// A vessel for the mission, with the mission's name and no label.
content::Vessel jar_vessel(const Mission& mission, Profile jar) {
  content::Vessel vessel;
  vessel.id = mission.id;
  for (const auto& [code, title] : mission.title) vessel.labels[code].title = title;
  vessel.mesh = revolve(section_of(resampled(jar, 64)), kRound);
  vessel.extracted.profile = std::move(jar);
  return vessel;
}

/// A vessel that it names but that is not on the shelf; "" if all are. The reader did not check
/// missions that are off.
std::string missing_from(const std::vector<std::string>& shelf, const Mission& mission) {
  std::vector<std::string> named = mission.vessels;
  if (!mission.vessel.empty()) named.push_back(mission.vessel);
  for (const std::string& id : named)
    if (std::find(shelf.begin(), shelf.end(), id) == shelf.end()) return id;
  return {};
}

/// 0 for "".
int place_of(const std::string& id, const std::vector<screens::ShelfCard>& shelf) {
  if (id.empty()) return 0;
  const auto found = std::find_if(shelf.begin(), shelf.end(),
                                  [&](const auto& one) { return one.vessel->id == id; });
  return static_cast<int>(found - shelf.begin());
}

}  // namespace

std::string reason_unavailable(const Mission& mission, const Capabilities& able) {
  if (mission.kind == Mission::Kind::eyes_closed && !able.sound)
    return "it needs sound, but there is none. Plug in a sound card, and give [sound] a "
           "volume.";
  if (mission.kind == Mission::Kind::two_hands && mission.second == Mission::Second::finger &&
      !able.two_fingers)
    return "this screen cannot follow two fingers. If there is a keyboard, write "
           "second = \"keys\".";
  return {};
}

std::size_t of_the_day(const files::LocalMoment& day, std::size_t vessels) {
  const std::chrono::sys_days date{std::chrono::year(day.year) /
                                   std::chrono::month(static_cast<unsigned>(day.month)) /
                                   std::chrono::day(static_cast<unsigned>(day.day))};
  const auto count = static_cast<long>(vessels), since = date.time_since_epoch().count();
  return static_cast<std::size_t>((since % count + count) % count);
}

Result<Profile> jar_for(const Mission& mission, const SceneDef& scene) {
  JarWish wish;
  wish.volume = mission.wanted.volume;
  if (const auto& height = mission.wanted.height)
    wish.height_least = height->least, wish.height_most = height->most;
  if (const auto& mouth = mission.wanted.mouth)
    wish.mouth_least = mouth->least, wish.mouth_most = mouth->most;
  return jar_that_holds(wish, scene);
}

Missions::Missions(const settings::Exhibit& exhibit, const Scenes& scenes,
                   std::function<std::time_t()> wall, std::string switched_on)
    : exhibit_(exhibit),
      scenes_(scenes),
      wall_(std::move(wall)),
      switched_on_(std::move(switched_on)) {}

void Missions::look(const std::vector<screens::ShelfCard>& shelf, bool complete,
                    bool nobody_is_here, const Capabilities& able) {
  if (!complete || shelf.empty() || !exhibit_.missions) return;
  const files::LocalMoment now = files::local_moment(wall_());
  // Before the first look nobody has seen the missions, so they may change at any time.
  if (read_ && (!nobody_is_here || (number_of(now) == day_ && able == able_))) return;
  if (!std::exchange(read_, true)) read(shelf);
  day_ = number_of(now);
  able_ = able;
  offer(shelf, able);
}

void Missions::offer(const std::vector<screens::ShelfCard>& shelf, const Capabilities& able) {
  cards_.clear();
  for (const screens::MissionCard& one : every_) {
    if (const std::string why = reason_unavailable(*one.mission, able); !why.empty()) {
      files::log_line("The mission " + one.mission->id + " is not offered: " + why);
      continue;
    }
    cards_.push_back(one);
    screens::MissionCard& card = cards_.back();
    if (card.mission->kind == Mission::Kind::today) card.card = todays(*card.mission, shelf);
    if (card.own.vessel != nullptr)
      card.card = screens::own_card(static_cast<int>(cards_.size()) - 1);
  }
}

int Missions::todays(const Mission& mission, const std::vector<screens::ShelfCard>& shelf) const {
  std::vector<std::string> ids = mission.vessels;
  if (ids.empty()) {
    for (const screens::ShelfCard& one : shelf) ids.push_back(one.vessel->id);
    std::sort(ids.begin(), ids.end());
  }
  return place_of(ids[of_the_day(files::local_moment(wall_()), ids.size())], shelf);
}

void Missions::read(const std::vector<screens::ShelfCard>& shelf) {
  std::vector<std::string> ids;
  for (const screens::ShelfCard& card : shelf) ids.push_back(card.vessel->id);
  auto read =
      settings::read_missions(*exhibit_.missions, exhibit_.languages, ids, exhibit_.translations);
  files::log_problems(read.problems);
  missions_ = std::move(read.missions);
  for (const Mission& mission : missions_) {
    if (!mission.on && mission.id != switched_on_ && switched_on_ != kEvery) continue;
    if (const std::string missing = missing_from(ids, mission); missing.empty())
      add(mission, shelf);
    else
      files::log_problem({exhibit_.missions->string() + ", mission " + mission.id,
                          "There is no vessel \"" + missing + "\" on the shelf.",
                          "Write the name of its folder on the shelf, or remove it."});
  }
}

void Missions::add(const Mission& mission, const std::vector<screens::ShelfCard>& shelf) {
  screens::MissionCard card;
  card.mission = &mission;
  switch (mission.kind) {
    case Mission::Kind::today:
      break;  // it changes every day
    case Mission::Kind::eyes_closed:
    case Mission::Kind::two_hands:
      card.card = place_of(mission.vessel, shelf);
      break;
    case Mission::Kind::describe: {
      auto jar = jar_for(mission, scenes_.of(mission.id));
      if (!jar)
        return files::log_problem({exhibit_.missions->string() + ", mission " + mission.id,
                                   jar.error().what, jar.error().remedy});
      jars_.push_back(jar_vessel(mission, std::move(*jar)));
      card.own.vessel = &jars_.back();
      card.own.target = jars_.back().extracted.profile;
      card.own.wheel = scenes_.wheel_of(jars_.back());
      break;
    }
  }
  every_.push_back(std::move(card));
}

bool Missions::draw_next_picture(render::Renderer& renderer) {
  for (screens::MissionCard& card : every_) {
    if (card.own.vessel == nullptr || card.own.picture != 0) continue;
    card.own.picture = picture_.next(renderer, *card.own.vessel);
    for (screens::MissionCard& offered : cards_)
      if (offered.mission == card.mission) offered.own.picture = card.own.picture;
    return true;
  }
  return false;
}

const screens::ShelfCard* Missions::card(int index,
                                         const std::vector<screens::ShelfCard>& shelf) const {
  if (index >= 0 && index < static_cast<int>(shelf.size()))
    return &shelf[static_cast<std::size_t>(index)];
  const int own = screens::mission_of_own(index);
  if (own < 0 || own >= static_cast<int>(cards_.size())) return nullptr;
  return &cards_[static_cast<std::size_t>(own)].own;
}

}  // namespace onggi::exhibit
