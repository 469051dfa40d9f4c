#include "kiosk/exhibit/visit_counter.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <utility>

namespace fs = std::filesystem;

namespace onggi::exhibit {

namespace {

std::string in_hex(std::uint64_t value) {
  char text[24];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
  return text;
}

}  // namespace

VisitCounter::VisitCounter(const fs::path& file, const settings::Exhibit& exhibit)
    : scene_(exhibit.scene.stem().string()),
      keepsake_days_(exhibit.keepsake.days),
      store_(file, exhibit.store.months) {
  for (const auto& [vessel, scene] : exhibit.vessel_scenes)
    vessel_scenes_[vessel] = scene.stem().string();
}

VisitCounter::~VisitCounter() {
  for (auto& [ticket, visit] : waiting_) store_.visit(std::move(visit));
}

std::string VisitCounter::scene_of(const std::string& vessel) const {
  if (vessel.empty()) return {};
  const auto own = vessel_scenes_.find(vessel);
  return own == vessel_scenes_.end() ? scene_ : own->second;
}

void VisitCounter::visit_over(const screens::VisitNotes& notes, const std::string& vessel,
                              int ticket) {
  store::VisitRecord visit;
  const std::time_t start = std::time(nullptr) - static_cast<std::time_t>(notes.since_s);
  std::tm local{};
  localtime_r(&start, &local);
  char day[16];
  visit.day = {day, std::strftime(day, sizeof day, "%Y-%m-%d", &local)};
  visit.hour = local.tm_hour;
  visit.start = start;
  visit.vessel = vessel;
  visit.scene = scene_of(vessel);
  visit.language = notes.language;
  visit.way = notes.way;
  visit.reached = screens::name_of(notes.reached);
  visit.left = screens::name_of(notes.left);
  visit.ended = screens::name_of(notes.end);
  // To the tenth: finer is nobody's figure.
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

void VisitCounter::saved(const Keepsakes::Finished& save, std::uint64_t state_hash) {
  const bool kept = save.outcome.has_value();
  if (kept) {
    store::KeepsakeRecord keepsake;
    keepsake.name = save.outcome->folder.filename().string();
    keepsake.kept_at = std::time(nullptr);
    if (keepsake_days_ > 0)
      keepsake.expires_at = keepsake.kept_at + std::int64_t{86400} * keepsake_days_;
    if (!save.outcome->replay.empty()) keepsake.replay_hash = in_hex(state_hash);
    store_.keepsake(std::move(keepsake));
  }
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
