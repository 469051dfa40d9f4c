#include "kiosk/exhibit/composition/visit_counter.h"

#include <cmath>
#include <ctime>
#include <utility>

#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/wall_clock.h"

namespace fs = std::filesystem;

namespace onggi::exhibit {

VisitCounter::VisitCounter(const fs::path& file, const settings::Exhibit& exhibit,
                           const fs::path& fetched)
    : scene_(exhibit.scene.stem().string()),
      store_(file, exhibit.store.months, store::StoreThread::kDaily, fetched) {
  for (const auto& [vessel, scene] : exhibit.vessel_scenes)
    vessel_scenes_[vessel] = scene.stem().string();
  if (exhibit.built_scene) built_scene_ = exhibit.built_scene->stem().string();
}

void VisitCounter::finish() {
  for (auto& [ticket, visit] : waiting_) store_.visit(std::move(visit));
  waiting_.clear();
  store_.end();
}

std::string VisitCounter::scene_of(const std::string& vessel, bool built) const {
  if (vessel.empty()) return {};
  if (built) return built_scene_;
  const auto own = vessel_scenes_.find(vessel);
  return own == vessel_scenes_.end() ? scene_ : own->second;
}

void VisitCounter::visit_over(const screens::VisitNotes& notes, const std::string& vessel,
                              int ticket) {
  store::VisitRecord visit;
  const std::time_t start = files::wall_now() - static_cast<std::time_t>(notes.since_s);
  visit.day = files::local_time(start, files::kDay);
  visit.hour = std::stoi(files::local_time(start, "%H"));
  visit.start = start;
  visit.vessel = vessel;
  visit.mission = notes.mission;
  visit.scene = scene_of(vessel, notes.built);
  visit.language = notes.language;
  visit.way = notes.way;
  visit.reached = screens::name_of(notes.reached);
  visit.left = screens::name_of(notes.left);
  visit.ended = screens::name_of(notes.end);
  // To the tenth; nobody needs it finer.
  visit.active_s = std::round(10.0 * notes.active_s) / 10.0;
  visit.throwing_s = std::round(10.0 * notes.throwing_s) / 10.0;
  visit.pots = notes.pots;
  visit.likeness = notes.likeness;
  const auto kept = saved_.find(ticket);
  if (ticket == 0 || kept != saved_.end()) {
    visit.kept = kept != saved_.end() && kept->second;
    saved_.clear();
    store_.visit(std::move(visit));
  } else {
    waiting_[ticket] = std::move(visit);
  }
}

void VisitCounter::saved(const Keepsakes::Finished& save) {
  const bool kept = save.outcome.has_value();
  const auto waits = waiting_.find(save.ticket);
  if (waits == waiting_.end()) {
    saved_[save.ticket] = kept;
    return;
  }
  waits->second.kept = kept;
  store_.visit(std::move(waits->second));
  waiting_.erase(waits);
}

}  // namespace onggi::exhibit
