#include "kiosk/visit/screens/desk.h"

#include <utility>

#include "kiosk/collection/settings/text_in.h"
#include "kiosk/visit/screens/decorate_controls.h"
#include "kiosk/visit/screens/label.h"

namespace onggi::screens {

void Desk::forget() {
  std::optional<VisitNotes> counted =
      notes.finish(now, std::exchange(leaves, VisitNotes::End::back));
  if (counted) {
    counted->language = words().code();
    counted->card = card;
    counted->built = built;
    if (const settings::Mission* mission_chosen = on()) counted->mission = mission_chosen->id;
  }
  language = 0;
  card = mission = -1;
  built = false;
  offered.reset();
  figures.reset();
  touched = false;
  made = {};
  score = {};
  exactly = false;
  glaze = -1;
  decorated.reset();
  lesson_steps = {};
  force = {};
  comfort = {};
  kept = Kept::not_asked;
  kept_as.clear();
  kept_at.clear();
  kept_in.clear();
  postcard = 0;
  requests.emplace_back(VisitEnded{std::move(counted)});
}

std::string Desk::title() const {
  const auto& titles = world.exhibit->title;
  return titles.empty() ? say("attract.title") : settings::text_in(titles, words().code());
}

const ShelfCard* Desk::shelf_card(int index) const {
  if (const int own = mission_of_own(index); own >= 0 && own < missions())
    return &mission_card(own).own;
  if (index < 0 || index >= cards()) return nullptr;
  return &(*world.shelf)[static_cast<std::size_t>(index)];
}

content::Label Desk::label(int index) const {
  const ShelfCard* shelf = shelf_card(index);
  return shelf != nullptr && shelf->vessel != nullptr ? shelf->vessel->label(words().code())
                                                      : content::Label{};
}

const SceneForVisitor& Desk::wheel() const {
  static const SceneForVisitor kNone;
  const ShelfCard* shelf = shelf_card(card != -1 ? card : attract_card);
  if (shelf == nullptr) return kNone;
  return (card != -1 ? built : attract_builds) && shelf->built ? *shelf->built : shelf->wheel;
}

int Desk::missions() const {
  return world.missions != nullptr ? static_cast<int>(world.missions->size()) : 0;
}

const MissionCard& Desk::mission_card(int index) const {
  return (*world.missions)[static_cast<std::size_t>(index)];
}

const settings::Mission* Desk::on() const {
  return mission >= 0 && mission < missions() ? mission_card(mission).mission : nullptr;
}

const settings::Mission::Described* Desk::described() const {
  const settings::Mission* what = on();
  return what != nullptr && what->kind == settings::Mission::Kind::describe ? &what->wanted
                                                                            : nullptr;
}

std::string Desk::heading() const {
  const settings::Mission* what = on();
  return what == nullptr || what->kind == settings::Mission::Kind::today
             ? label(card).title
             : what->title_in(words().code());
}

std::string Desk::answer() const {
  const settings::Mission* what = on();
  if (what == nullptr) return say("result.answer", {{"vessel", label(card).title}});
  const std::string& title = what->title_in(words().code());
  return described() != nullptr
             ? title
             : say("mission.answer", {{"mission", title}, {"vessel", label(card).title}});
}

std::string Desk::said(const score::Remark& remark) const {
  auto places = remark.places;
  for (const char* litre : {"litres", "wanted"})
    if (const auto at = places.find(litre); at != places.end())
      at->second = hundredths(std::stol(at->second), words());
  if (const auto at = places.find("place"); at != places.end())
    at->second = say("place." + at->second);
  // Who beat the wall made no turn with the hands.
  const bool beaten = remark.key == "remark.not_round" && built && wheel().beating;
  return say(beaten ? "remark.not_round_beaten" : remark.key, places);
}

score::Score Desk::judged(const ShelfCard& answered, const Profile& pot) const {
  const settings::Rubric& rubric = world.exhibit->rubric;
  const bool known = answered.vessel == nullptr || content::is_known(answered.vessel->size_from);
  const double true_scale = !known ? 0 : answered.scale > 0 ? 1 / answered.scale : 1;
  return score::judge(answered.target, pot, !rubric.size_counts, true_scale, rubric, true);
}

void Desk::judge(const ShelfCard& answered, bool lacks_rings) {
  made = world.wheel->clay.profile();
  const settings::Rubric& rubric = world.exhibit->rubric;
  kept = Kept::not_asked;
  glaze = -1;
  if (world.wheel->clay.change() != clay_decorated_) decorated.reset();
  if (decorated) decorated->fire(false);
  if (!world.wheel->prints.empty()) pot_to_decorate();  // they are seen from now on
  postcard = 0;
  if (const auto* wanted = described()) {
    figures = score::figures_of(made, world.wheel->clay.capacity());
    score = score::judge_described(*wanted, *figures, made, rubric);
    notes.judged(score.points);
    return;
  }
  score = judged(answered, made);
  // Of a wall that is not there, no part is too wide.
  if (lacks_rings) score.try_next = {{"remark.more_rings", {}}};
  notes.judged(score.points);
}

void Desk::touch_pot() {
  touched = true;
  kept = Kept::not_asked;
}

void Desk::fresh_clay() {
  touched = false;
  if (lesson() != nullptr && lesson_step() < lesson()->size()) lesson_step() = 0;
}

decorating::DecoratedPot* Desk::pot_to_decorate() {
  if (!decorated && wheel().way != nullptr) {
    auto begun = wheel().prints ? decorating::DecoratedPot::begin(
                                      made, *wheel().way, world.wheel->prints, *wheel().prints)
                                : decorating::DecoratedPot::begin(made, *wheel().way);
    if (begun) decorated = std::move(*begun);
    if (decorated && curated) decorated->keep_work();
    clay_decorated_ = world.wheel->clay.change();
  }
  return decorated.get();
}

std::uint64_t Desk::decoration_hash() const {
  return decorated && !decorated->plain() ? decorated->surface().hash() : 0;
}

void Desk::keep_pot() {
  const std::uint64_t decoration = decoration_hash();
  if (kept != Kept::not_asked && kept_glaze_ == glaze && kept_decoration_ == decoration) return;
  MakeKeepsake wish{card, score, made, glaze};
  wish.built = built;
  if (decorated && !decorated->plain()) {
    decorated->lift();
    decorated->end_work();
    wish.decorated = decorated;
    wish.decorated_how = did_in_words(*this, *decorated);
  }
  requests.emplace_back(std::move(wish));
  kept = Kept::asked;
  kept_glaze_ = glaze;
  kept_decoration_ = decoration;
  kept_as.clear();
  kept_at.clear();
  kept_in.clear();
  postcard = 0;
}

void Desk::start_pot(int index, bool scripted, const std::string& script) {
  requests.emplace_back(StartPot{index, scripted, script, scripted ? attract_builds : built});
  if (!scripted) notes.pot();
  figures.reset();
  fresh_clay();
  awaited_ = status.scene_serial;
}

const std::string& Desk::note() const {
  const std::string& fault = fault_note.key();
  return fault.empty() && world.devices != nullptr ? world.devices->key() : fault;
}

void Desk::look() {
  status = world.wheel->status;
  fault_note.update(status, now, *world.wheel_commands);
  if (awaited_ && *awaited_ != status.scene_serial) awaited_.reset();
}

}  // namespace onggi::screens
