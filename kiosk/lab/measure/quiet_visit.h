#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/composition/missions.h"
#include "kiosk/exhibit/composition/scenes.h"
#include "kiosk/exhibit/composition/shelf.h"
#include "kiosk/exhibit/rehearsal/aided_visitor.h"
#include "kiosk/exhibit/rehearsal/handsome.h"
#include "kiosk/exhibit/rehearsal/naive_hands.h"
#include "kiosk/visit/access/utterance.h"

namespace onggi::measure {

/// What a pot came to at one moment of a visit.
struct PotLook {
  double seconds = 0;  ///< Since the first look at the wheel.
  double points = 0;   ///< As the result screen would say, 0 to 100.
  int stars = 0;
  rehearsal::Smoothness smooth;  ///< Of the outline.
  double out_of_round = 0;       ///< RMS of the outer face about its rows' own means, m.
  double way_in = 1;  ///< The opening at its narrowest / the vessel's own, 0 (shut) to 1.
  double wall = 0;    ///< Mean thickness, of the vessel as it is on the wheel, m.
};

/// What came of a visit.
struct QuietOutcome {
  std::string vessel;
  std::uint64_t seed = 0;
  std::vector<PotLook> looks;         ///< One for each moment asked for, in order.
  std::optional<double> handsome_at;  ///< s: handsome(), and 4 mm off the lump it came from.
  int mishaps = 0;                    ///< Falls and tears that were taken back.
};

/// What came of a visit without eyes, or with one switch.
struct AidedOutcome {
  double points = 0;                 ///< As the result screen would say, 0 to 100.
  int strokes = 0;                   ///< That were asked for.
  int presses = 0;                   ///< Of keys, or of the switch.
  double seconds = 0;                ///< From the first touch to attract again.
  bool kept = false;                 ///< A keepsake was asked for and made.
  std::string of;                    ///< The id of the vessel or the description that it answers.
  std::vector<score::Remark> asked;  ///< Of a description: Score::asked.
  std::vector<access::Utterance> said;
};

/// Visits that nobody watches: the real screens (screens::Visit), clay and hands, stepped as fast
/// as the machine can and never drawn, so that two hundred are made in the time of ten drawn ones.
/// Words are measured roughly: nothing of them but the tray's room is used. One exhibit, read once;
/// the visits are const and may be made on several threads at once.
class QuietVisits {
 public:
  /// `language`: instead of the exhibit's first. `scene`: instead of the exhibit's own scenes, for
  /// every vessel; empty for those. Problem where exhibit, scene or languages cannot be read, or
  /// the shelf is empty.
  static Result<std::unique_ptr<QuietVisits>> open(const std::string& exhibit_file,
                                                   const std::string& scene = {},
                                                   const std::string& language = {});

  const std::vector<screens::ShelfCard>& cards() const { return shelf_->cards(); }
  /// The card of `vessel`. Problem with what there is, where it is not on the shelf.
  Result<int> card_of(const std::string& vessel) const;
  /// Naive hands at the wheel; `moments`: s, rising, at which the pot is looked at; they throw on
  /// until the last. Problem where the screens lack a control that visitors need.
  Result<QuietOutcome> naive(int card, std::uint64_t seed, rehearsal::NaiveHands::Pointer pointer,
                             const std::vector<double>& moments) const;
  /// A whole visit, from attract to attract, in the language that the visits were opened in.
  /// Without eyes: speech is heard and keys are pressed, until `strokes` were made or the pot is
  /// close everywhere. Problem where the visitor finds no way on, or it takes over an hour.
  Result<AidedOutcome> blind(int card, int strokes) const;
  /// With one switch and `pace` s from one item to the next, 0.5 to 5.
  Result<AidedOutcome> one_switch(int card, int strokes, double pace) const;
  /// Both again, with the mission of this id instead of a vessel, on or off, on 4 May 2026 (UTC).
  /// Problem, too, where it cannot be played.
  Result<AidedOutcome> blind(const std::string& mission, int strokes) const;
  Result<AidedOutcome> one_switch(const std::string& mission, int strokes, double pace) const;
  /// The script `follow`, a potter who knows the vessel, to its end: one look, 0 mishaps.
  Result<QuietOutcome> careful(int card, std::uint64_t seed) const;

 private:
  QuietVisits() = default;
  /// What somebody makes a visit for: a card of the shelf, or a mission.
  struct Aim {
    const screens::ShelfCard* card = nullptr;
    const exhibit::Missions* missions = nullptr;
    const settings::Mission* mission = nullptr;
  };
  template <class Make>
  Result<AidedOutcome> with_mission(const std::string& id, Make&& make) const;
  rehearsal::VisitPlan plan(const Aim& aim, int strokes) const;
  template <class Act>
  Result<AidedOutcome> aided(const Aim& aim, double pace, Act&& act) const;
  Result<AidedOutcome> blind(const Aim& aim, int strokes) const;
  Result<AidedOutcome> one_switch(const Aim& aim, int strokes, double pace) const;

  settings::Exhibit exhibit_;
  std::unique_ptr<exhibit::Scenes> scenes_;
  std::unique_ptr<exhibit::Shelf> shelf_;
  std::vector<content::Language> languages_;
};

}  // namespace onggi::measure
