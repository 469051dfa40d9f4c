#include "kiosk/screens/desk.h"

#include <utility>

namespace onggi::screens {

void Desk::forget() {
  std::optional<VisitNotes> counted =
      notes.finish(now, std::exchange(leaves, VisitNotes::End::back));
  if (counted) {
    counted->language = words().code();
    counted->card = card;
  }
  language = 0;
  card = -1;
  made = {};
  score = {};
  glaze = -1;
  lesson_step = 0;
  force = {};
  comfort = {};
  kept = Kept::not_asked;
  kept_as.clear();
  kept_at.clear();
  postcard = 0;
  requests.emplace_back(ForgetVisitor{std::move(counted)});
}

std::string Desk::title() const {
  const auto& titles = world.exhibit->title;
  if (const auto own = titles.find(words().code()); own != titles.end()) return own->second;
  return titles.empty() ? say("attract.title") : titles.begin()->second;
}

const ShelfCard* Desk::shelf_card(int index) const {
  if (index < 0 || index >= cards()) return nullptr;
  return &(*world.shelf)[static_cast<std::size_t>(index)];
}

content::Label Desk::label(int index) const {
  const ShelfCard* shelf = shelf_card(index);
  return shelf != nullptr && shelf->vessel != nullptr ? shelf->vessel->label(words().code())
                                                      : content::Label{};
}

const Wheel& Desk::wheel() const {
  static const Wheel kNone;
  const ShelfCard* shelf = shelf_card(card >= 0 ? card : attract_card);
  return shelf != nullptr ? shelf->wheel : kNone;
}

void Desk::judge(const ShelfCard& answered) {
  made = world.wheel->clay.profile();
  const settings::Rubric& rubric = world.exhibit->rubric;
  const bool known = answered.vessel == nullptr || content::is_known(answered.vessel->size_from);
  const double true_scale = !known ? 0 : answered.scale > 0 ? 1 / answered.scale : 1;
  score = score::judge(answered.target, made, !rubric.size_counts, true_scale, rubric);
  notes.judged(score.points);
  kept = Kept::not_asked;
  glaze = -1;
  postcard = 0;
}

void Desk::keep_pot() {
  if (kept != Kept::not_asked && kept_glaze_ == glaze) return;
  requests.emplace_back(MakeKeepsake{card, score, made, glaze});
  kept = Kept::asked;
  kept_glaze_ = glaze;
  kept_as.clear();
  kept_at.clear();
  postcard = 0;
}

void Desk::start_pot(int index, bool scripted, const std::string& script) {
  requests.emplace_back(StartPot{index, scripted, script});
  if (!scripted) notes.pot();
  awaited_ = status.scene_serial;
}

const std::string& Desk::note() const {
  const std::string& fault = fault_note.key();
  return fault.empty() && world.devices != nullptr ? world.devices->key() : fault;
}

void Desk::look() {
  status = world.wheel->status;
  fault_note.update(status, now, *world.potter);
  if (awaited_ && *awaited_ != status.scene_serial) {
    awaited_.reset();
    pot_since_ = now;
  }
}

}  // namespace onggi::screens
