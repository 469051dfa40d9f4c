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
#include "kiosk/exhibit/rehearsal/looks_smooth.h"
#include "kiosk/exhibit/rehearsal/naive_hands.h"
#include "kiosk/visit/access/utterance.h"

namespace onggi::measure {

/// The pot at one moment of a visit.
struct PotLook {
  double seconds = 0;  ///< Since the wheel's first frame.
  double points = 0;   ///< As on the result screen, 0 to 100.
  int stars = 0;
  rehearsal::Smoothness smooth;  ///< Of the outline.
  double out_of_round = 0;       ///< RMS of the outer face around its rows' means, m.
  double way_in = 1;  ///< The opening at its narrowest / the vessel's own, 0 (closed) to 1.
  double wall = 0;    ///< Mean thickness, at the wheel's scale, m.
};

/// The result of a visit.
struct HeadlessOutcome {
  std::string vessel;
  std::uint64_t seed = 0;
  std::vector<PotLook> looks;  ///< One for each requested moment, in order.
  std::optional<double>
      handsome_at;  ///< s; it must be looks_smooth() and 4 mm off the original lump.
  int mishaps = 0;  ///< Falls and tears that were undone.
};

/// The result of a visit without sight, or with one switch.
struct AidedOutcome {
  double points = 0;                 ///< As on the result screen, 0 to 100.
  int strokes = 0;                   ///< Number of requested strokes.
  int presses = 0;                   ///< Of keys, or of the switch.
  double seconds = 0;                ///< From the first touch to the next attract.
  bool kept = false;                 ///< A keepsake was requested and made.
  std::string of;                    ///< Id of the vessel or description that it answers.
  std::vector<score::Remark> asked;  ///< For a description: Score::asked.
  std::vector<access::Utterance> said;
};

/// Visits without a display: the real screens (screens::Visit), clay and hands, stepped as fast as
/// the machine can and never drawn, so that two hundred take the time of ten drawn ones. Text is
/// measured roughly, because only its space in the tray matters. The exhibit is read once; visits
/// are const and may run on several threads.
class HeadlessVisits {
 public:
  /// `language`: instead of the exhibit's first. `scene`: instead of the exhibit's own scenes, for
  /// every vessel; empty: those. Problem if exhibit, scene or languages cannot be read, or if the
  /// shelf is empty.
  static Result<std::unique_ptr<HeadlessVisits>> open(const std::string& exhibit_file,
                                                      const std::string& scene = {},
                                                      const std::string& language = {});

  const std::vector<screens::ShelfCard>& cards() const { return shelf_->cards(); }
  /// The card of `vessel`. Problem, with the existing ones, if it is not on the shelf.
  Result<int> card_of(const std::string& vessel) const;
  /// Naive hands at the wheel, until the last of `moments` (s, rising), at which the pot is
  /// measured. Problem if a needed control is missing on the screens.
  Result<HeadlessOutcome> naive(int card, std::uint64_t seed,
                                rehearsal::NaiveHands::Pointer pointer,
                                const std::vector<double>& moments) const;
  /// A whole visit, from attract to attract, in the language of the visits, without sight: it hears
  /// speech and presses keys, until `strokes` were made or the pot is close everywhere. Problem if
  /// the visitor is stuck, or if it takes over an hour.
  Result<AidedOutcome> blind(int card, int strokes) const;
  /// With one switch and `pace` s for each item, 0.5 to 5.
  Result<AidedOutcome> one_switch(int card, int strokes, double pace) const;
  /// Both again, with the mission of this id instead of a vessel, on or off, on 4 May 2026 (UTC).
  /// Problem also if it cannot be played.
  Result<AidedOutcome> blind(const std::string& mission, int strokes) const;
  Result<AidedOutcome> one_switch(const std::string& mission, int strokes, double pace) const;
  /// The script `follow`, a potter who knows the vessel, to its end: one look, no mishaps.
  Result<HeadlessOutcome> careful(int card, std::uint64_t seed) const;

 private:
  HeadlessVisits() = default;
  /// The goal of a visit: a card of the shelf, or a mission.
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
