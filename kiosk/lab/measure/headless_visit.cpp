#include "kiosk/lab/measure/headless_visit.h"

#include <algorithm>
#include <cmath>

#include "engine/base/nearest_name.h"
#include "engine/scene/lump.h"
#include "engine/scene/scene.h"
#include "engine/script/script.h"
#include "kiosk/collection/score/score.h"
#include "kiosk/collection/settings/scene_file.h"
#include "kiosk/exhibit/composition/words.h"
#include "kiosk/exhibit/rehearsal/aided_visitor.h"
#include "kiosk/exhibit/rehearsal/touch_at.h"
#include "kiosk/visit/access/access_mode.h"
#include "kiosk/visit/screens/visit.h"
#include "kiosk/wheel/loop/stepped_wheel.h"

namespace onggi::measure {

namespace {

constexpr int kWidth = 1280, kHeight = 720;
constexpr int kFrameTicks = 20;      // of 1 ms: 50 frames a second
constexpr double kMind = 1.5;        // s to read a mishap and find its button
constexpr double kOften = 0.5;       // s between two checks for a good-looking pot
constexpr double kOffLump = 0.004;   // m: it is no longer the lump
constexpr double kGrace = 60.0;      // s that the last look waits while a fall is undone
constexpr double kTooLong = 3600.0;  // s of a visit without sight or with one switch
constexpr double kPxPerMm = 2.4;     // of a screen of 600 mm
constexpr double kLongest = 900.0;   // s of a script
constexpr std::time_t kMissionDay = 1777896000;  // 2026-05-04, noon: an ordinary day

/// Letters of 0.4 em in full lines: only the space of words is needed.
struct RoughMeasure final : view::TextMeasure {
  Size measure(const std::string& text, const view::TextStyle& style, float width) const override {
    const auto letters = static_cast<float>(std::min<std::size_t>(text.size(), 40));
    const float line = style.px * 0.4f * letters, high = style.px * style.line_height;
    if (width <= 0 || line <= width) return {line, high};
    return {width, high * std::ceil(line / width)};
  }
};

/// A visit on its own wheel.
class Walk {
 public:
  Walk(const settings::Exhibit& exhibit, const exhibit::Scenes& scenes,
       const std::vector<screens::ShelfCard>& cards,
       const std::vector<content::Language>& languages, const exhibit::Missions* missions = nullptr)
      : scenes_(scenes), missions_(missions), cards_(cards), visit_([&] {
          screens::VisitInputs world;
          world.exhibit = &exhibit;
          world.languages = &languages;
          world.shelf = &cards_;
          world.measure = &words_;
          world.wheel = &wheel_host.view();
          world.wheel_commands = &wheel_host;
          if (missions != nullptr) world.missions = &missions->cards();
          return world;
        }()) {}

  void frame() {
    wheel_host.advance(kFrameTicks);
    wheel_host.collect();
    visit_.update(now);
    while (auto request = visit_.take_request()) {
      if (const auto* start = std::get_if<screens::StartPot>(&*request)) begin(start->card);
      if (const auto* keep = std::get_if<screens::MakeKeepsake>(&*request)) {
        score = keep->score;
        of = card(keep->card)->vessel->id;
        kept = true;
        visit_.keepsake_kept("kept");
      }
    }
    shown = visit_.frame(kWidth, kHeight);
    now += kFrameTicks * 1e-3;
  }
  void frames(int count) {
    for (int n = 0; n < count; ++n) frame();
  }
  Result<void> touch(const std::string& id) {
    while (const auto way = rehearsal::way_to(visit_, id)) {
      rehearsal::touch_at(visit_, way->x + way->w / 2, way->y + way->h / 2, now);
      frame();
    }
    const auto at = visit_.control(id);
    if (!at) return problem("the visit", "No control " + id + " is on its screen.", "Report it.");
    rehearsal::touch_at(visit_, at->x + at->w / 2, at->y + at->h / 2, now);
    return {};
  }
  /// From attract to the wheel, like a visitor.
  Result<void> go_to_wheel(int card) {
    frames(50);
    if (auto good = touch("attract.begin"); !good) return good;
    frames(60);
    const std::string wanted = "choose.card." + std::to_string(card);
    for (std::size_t page = 0; page < cards_.size() && !visit_.control(wanted); ++page) {
      if (auto good = touch("choose.next"); !good) return good;
      frames(60);
    }
    if (auto good = touch(wanted); !good) return good;
    frames(60);
    if (auto good = touch("choose.throw"); !good) return good;
    frames(80);
    return {};
  }
  screens::Visit& visit() { return visit_; }

  loop::SteppedWheel wheel_host;
  double now = 0;
  view::Frame shown;
  bool kept = false;
  score::Score score;  ///< The score of the keepsake,
  std::string of;      ///< and the id of what it answers.

 private:
  const screens::ShelfCard* card(int index) const {
    return missions_ != nullptr ? missions_->card(index, cards_)
                                : &cards_[static_cast<std::size_t>(index)];
  }
  void begin(int index) {
    const screens::ShelfCard& which = *card(index);
    SceneDef def = scenes_.of(which.vessel->id);
    def.clay = lump_for(which.target, def);
    if (auto scene = Scene::create(def))
      wheel_host.start(std::make_unique<Scene>(std::move(*scene)));
  }

  const exhibit::Scenes& scenes_;
  const exhibit::Missions* missions_;
  const std::vector<screens::ShelfCard> cards_;
  RoughMeasure words_;
  screens::Visit visit_;
};

PotLook look_at(const screens::ShelfCard& card, const Profile& made, const settings::Rubric& rubric,
                double seconds) {
  const auto score = score::judge(card.target, made, !rubric.size_counts,
                                  card.scale > 0 ? 1 / card.scale : 1, rubric);
  return {seconds,
          score.points,
          score.stars,
          rehearsal::smoothness(made),
          made.out_of_round,
          1.0 - score.measures.opening_lacking,
          score.measures.made.wall_mean};
}

}  // namespace

Result<std::unique_ptr<HeadlessVisits>> HeadlessVisits::open(const std::string& exhibit_file,
                                                             const std::string& scene,
                                                             const std::string& language) {
  auto read = settings::read_exhibit(exhibit_file);
  if (!read.problems.empty()) return tl::unexpected(read.problems.front());
  std::unique_ptr<HeadlessVisits> out(new HeadlessVisits);
  out->exhibit_ = std::move(read.exhibit);
  if (!scene.empty()) {
    const settings::SceneRead scene_read = settings::read_scene(scene);
    if (!scene_read.problems.empty()) return tl::unexpected(scene_read.problems.front());
    out->exhibit_.scene = scene;
    out->exhibit_.vessel_scenes.clear();
    out->exhibit_.built_scene.reset();
  }
  auto languages = exhibit::read_languages(out->exhibit_, language);
  if (!languages) return tl::unexpected(languages.error());
  out->languages_ = std::move(*languages);
  out->scenes_ = std::make_unique<exhibit::Scenes>(out->exhibit_);
  out->shelf_ = std::make_unique<exhibit::Shelf>(out->exhibit_.shelf, *out->scenes_, out->exhibit_);
  out->shelf_->wait();
  if (out->cards().empty())
    return problem(out->exhibit_.shelf.string(), "No vessel there could be opened.",
                   "Run onggi check.");
  return out;
}

Result<int> HeadlessVisits::card_of(const std::string& vessel) const {
  std::vector<std::string> ids;
  for (const screens::ShelfCard& card : cards()) {
    if (card.vessel->id == vessel) return static_cast<int>(ids.size());
    ids.push_back(card.vessel->id);
  }
  const std::string nearest = nearest_name(vessel, ids);
  return problem(
      "--vessels " + vessel, "The shelf has no such vessel.",
      nearest.empty() ? "Run onggi check to list its vessels." : "Write " + nearest + ".");
}

Result<HeadlessOutcome> HeadlessVisits::naive(int card, std::uint64_t seed,
                                              rehearsal::NaiveHands::Pointer pointer,
                                              const std::vector<double>& moments) const {
  const screens::ShelfCard& which = cards()[static_cast<std::size_t>(card)];
  Walk walk(exhibit_, *scenes_, cards(), languages_);
  if (auto good = walk.go_to_wheel(card); !good) return tl::unexpected(good.error());
  HeadlessOutcome out{which.vessel->id, seed, {}, std::nullopt, 0};
  rehearsal::NaiveHands hands(seed, moments.back(), pointer);
  const double begun = walk.now;
  double looked = -kOften, trouble = -1;
  Profile lump, made;
  const auto note = [&](double seconds) {
    out.looks.push_back(look_at(which, made, exhibit_.rubric, seconds));
  };
  while (out.looks.size() < moments.size() && walk.now < begun + moments.back() + kGrace) {
    walk.frame();
    const double since = walk.now - begun;
    const auto sight = walk.visit().sight();
    if (!sight) {  // a pot that fell or tore: read the words, and undo
      if (trouble < 0) trouble = walk.now;
      if (walk.now - trouble < kMind) continue;
      trouble = -1;
      ++out.mishaps;
      if (!walk.visit().control("throw.restore")) break;
      if (auto good = walk.touch("throw.restore"); !good) return tl::unexpected(good.error());
      continue;
    }
    trouble = -1;
    made = *sight->made;
    if (lump.points.empty()) lump = made;
    if (since - looked >= kOften) {
      looked = since;
      if (!out.handsome_at && rehearsal::looks_smooth(rehearsal::smoothness(made)) &&
          rehearsal::outline_distance(made, lump) > kOffLump)
        out.handsome_at = since;
    }
    while (out.looks.size() < moments.size() && since >= moments[out.looks.size()])
      note(moments[out.looks.size()]);
    const rehearsal::NaiveHands::Move move = hands.step(since, *sight, kWidth);
    for (const view::InputEvent& event : move.events) walk.visit().input(event, walk.now);
    if (!move.control.empty())
      if (auto good = walk.touch(move.control); !good) return tl::unexpected(good.error());
  }
  while (out.looks.size() < moments.size()) note(moments[out.looks.size()]);
  return out;
}

template <class Act>
Result<AidedOutcome> HeadlessVisits::aided(const Aim& aim, double pace, Act&& act) const {
  settings::Exhibit exhibit = exhibit_;
  exhibit.screen.scan_seconds = pace;
  Walk walk(exhibit, *scenes_, cards(), languages_, aim.missions);
  access::AccessMode assistant(exhibit.access.hold_to_speak);
  walk.frames(50);
  const double begun = walk.now;
  AidedOutcome out;
  bool left_attract = false;
  while (!left_attract || walk.visit().screen() != screens::ScreenId::attract) {
    left_attract = left_attract || walk.visit().screen() != screens::ScreenId::attract;
    walk.frame();
    assistant.look(walk.visit(), walk.shown, walk.now);
    auto said = assistant.take();
    const std::vector<view::InputEvent> events =
        act(walk.visit(), assistant, said ? &*said : nullptr, walk.now, out);
    for (const view::InputEvent& event : events)
      assistant.input(event, walk.visit(), kPxPerMm, walk.now);
    if (said) out.said.push_back(std::move(*said));
    if (walk.now - begun > kTooLong)
      return problem("the visit to " + aim.card->vessel->id, "It did not end within an hour.",
                     "Report it.", 1);
  }
  assistant.look(walk.visit(), walk.shown, walk.now);
  if (auto said = assistant.take()) out.said.push_back(std::move(*said));
  out.points = walk.score.points;
  out.asked = walk.score.asked;
  out.of = walk.of;
  out.kept = walk.kept;
  out.seconds = walk.now - begun;
  return out;
}

rehearsal::VisitPlan HeadlessVisits::plan(const Aim& aim, int strokes) const {
  const content::Language& language = languages_.front();
  rehearsal::VisitPlan::Of of;
  of.vessel = aim.card->vessel->label(language.code()).title;
  if (aim.mission != nullptr) of.mission = aim.mission->title_in(language.code());
  if (aim.card->wheel.kiln)
    of.glaze = aim.card->wheel.kiln->glazes->front().name_in(language.code());
  return {language, of, strokes};
}

template <class Make>
Result<AidedOutcome> HeadlessVisits::with_mission(const std::string& id, Make&& make) const {
  exhibit::Missions missions(
      exhibit_, *scenes_, [] { return kMissionDay; }, id);
  missions.look(cards(), true, true);
  for (const screens::MissionCard& one : missions.cards())
    if (one.mission->id == id)
      return make(Aim{missions.card(one.card, cards()), &missions, one.mission});
  return problem("the mission " + id, "This mission cannot be played.", "Run onggi check.");
}

Result<AidedOutcome> HeadlessVisits::blind(const Aim& aim, int strokes) const {
  rehearsal::BlindVisitor visitor(plan(aim, strokes), exhibit_.access.hold_to_speak);
  std::string lost;
  auto outcome = aided(aim, exhibit_.screen.scan_seconds,
                       [&](screens::Visit&, access::AccessMode& assistant,
                           const access::Utterance* said, double now, AidedOutcome& out) {
                         if (said != nullptr) {
                           visitor.hear(*said, now);
                           assistant.ended(said->id);
                         }
                         out.presses = visitor.presses();
                         out.strokes = visitor.plan().strokes();
                         return visitor.step(now);
                       });
  if (!visitor.lost().empty())
    return problem("the visit", "No spoken text says where \"" + visitor.lost() + "\" is.",
                   "Report it.", 1);
  return outcome;
}

Result<AidedOutcome> HeadlessVisits::one_switch(const Aim& aim, int strokes, double pace) const {
  rehearsal::SwitchVisitor visitor(plan(aim, strokes), exhibit_.access.hold_to_speak);
  return aided(aim, pace,
               [&](screens::Visit& visit, access::AccessMode& assistant, const access::Utterance*,
                   double now, AidedOutcome& out) {
                 out.presses = visitor.presses();
                 out.strokes = visitor.plan().strokes();
                 return visitor.step(visit.reading(), assistant.scan().shown(), now);
               });
}

Result<AidedOutcome> HeadlessVisits::blind(int card, int strokes) const {
  return blind(Aim{&cards()[static_cast<std::size_t>(card)]}, strokes);
}

Result<AidedOutcome> HeadlessVisits::one_switch(int card, int strokes, double pace) const {
  return one_switch(Aim{&cards()[static_cast<std::size_t>(card)]}, strokes, pace);
}

Result<AidedOutcome> HeadlessVisits::blind(const std::string& mission, int strokes) const {
  return with_mission(mission, [&](const Aim& aim) { return blind(aim, strokes); });
}

Result<AidedOutcome> HeadlessVisits::one_switch(const std::string& mission, int strokes,
                                                double pace) const {
  return with_mission(mission, [&](const Aim& aim) { return one_switch(aim, strokes, pace); });
}

Result<HeadlessOutcome> HeadlessVisits::careful(int card, std::uint64_t seed) const {
  const screens::ShelfCard& which = cards()[static_cast<std::size_t>(card)];
  SceneDef def = scenes_->of(which.vessel->id);
  def.clay = lump_for(which.target, def);
  auto scene = Scene::create(def);
  if (!scene) return tl::unexpected(scene.error());
  auto script = make_script("follow", {def, &which.target, seed, 1.0});
  if (!script) return tl::unexpected(script.error());
  loop::SteppedWheel wheel_host;
  wheel_host.start(std::make_unique<Scene>(std::move(*scene)));
  wheel_host.play(std::move(*script));
  wheel_host.advance(kFrameTicks);
  double seconds = kFrameTicks * 1e-3;
  for (; !wheel_host.status().script_done && seconds < kLongest; seconds += kFrameTicks * 1e-3) {
    wheel_host.advance(kFrameTicks);
    wheel_host.collect();
  }
  wheel_host.pause(true);
  while (!wheel_host.refresh_every_row()) wheel_host.advance(1);
  wheel_host.collect();
  const Profile made = wheel_host.view().clay.profile();
  HeadlessOutcome out{which.vessel->id, seed, {}, std::nullopt, 0};
  out.looks.push_back(look_at(which, made, exhibit_.rubric, seconds));
  return out;
}

}  // namespace onggi::measure
