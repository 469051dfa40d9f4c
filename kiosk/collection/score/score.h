#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/profile/measures.h"
#include "kiosk/collection/settings/rubric.h"

namespace onggi::score {

/// A remark in a language's words: a key of content/languages with its places.
///
/// What is alike, no places unless said:
///   alike.outline {percent}   the whole outline; {percent} of its area is shared, whole number
///   alike.belly   alike.mouth   alike.foot   alike.neck   alike.height   alike.wall
///   alike.start               nothing is near yet: a first pot on the way
/// What to try, largest difference first. {mm} is a whole number of millimetres on the true vessel:
///   remark.belly_wide {mm}    remark.belly_narrow {mm}   widest diameter against the vessel's
///   remark.belly_high {mm}    remark.belly_low {mm}      height of the widest place
///   remark.neck_wide {mm}     remark.neck_narrow {mm}    narrowest diameter above the belly
///   remark.mouth_wide {mm}    remark.mouth_narrow {mm}   diameter at the rim
///   remark.foot_wide {mm}     remark.foot_narrow {mm}    diameter at the foot
///   remark.wide {mm} {percent}, remark.narrow {mm} {percent}   diameter at {percent} of the height
///                             from the foot, 1 to 99, where no part of those above is out as much
///   remark.tall {mm}          remark.short {mm}          height; when scale-free only by_line
///   remark.opening_narrow {percent}   the way in, where it is narrowest, lacks so much
///   remark.opening_shut       it is closed over, or as good as
///   remark.not_round          the wall does not run true
///   remark.rippled            ring upon ring, which the vessel has not
///   remark.wall_uneven {percent}   wall thickness varies by {percent} of its mean, whole number
/// The largest difference, said as it is and not as advice, with the same endings and places:
///   difference.belly_wide ... difference.narrow, difference.tall, difference.short,
///   difference.opening_narrow, difference.opening_shut
/// Where the true size is not known, {part} in place of {mm}, in percent of the same length (of the
/// height for tall, short, high and low): remark_part.belly_wide ... difference_part.short.
/// Without figures, for in_words(): plain.much_wider {place} ... ; {place} is an ending of
/// "place.".
struct Remark {
  std::string key;                            ///< "remark.neck_wide"
  std::map<std::string, std::string> places;  ///< {"mm", "8"}
  /// Where the pot differs, and where it should be, as shares of the vessel's height from the foot:
  /// one height for a width, two for a widest place that is too high or too low. Absent: nowhere.
  struct Seen {
    double made = 0, wanted = 0;
    double share = 0;  ///< The difference, as a share of the vessel's own length there; above 0.
  };
  std::optional<Seen> seen{};
};

/// Every key that judge() can return, so that each language can be checked for all of them.
std::vector<std::string> remark_keys();

/// The score of a pot as an answer to a vessel.
struct Score {
  double points = 0;  ///< 0..100
  int stars = 0;      ///< 1..5
  Measures measures;
  std::vector<Remark> alike;      ///< What is alike, best first; one to three.
  std::optional<Remark> largest;  ///< The largest difference; absent if all are under 1 mm.
  std::vector<Remark> try_next;  ///< What to try, largest difference first; none to three, and none
                                 ///< with five stars.
  /// For a pot that answers a description (described.h), each figure beside the wanted one:
  /// mission.holds {litres} {wanted}, in hundredths of a litre; mission.height and mission.mouth
  /// {mm} {least} {most}. `alike` is then empty.
  std::vector<Remark> asked{};
};

/// One to five stars, by the steps of `rubric`.
int stars_of(double points, const settings::Rubric& rubric);

/// Scores the measures by `rubric`; `scale_free` replaces its size_counts. Both profiles must be
/// valid, metres. `true_scale` is true metres for one metre of `target` (1 / the workspace scale),
/// so that remarks speak of the real vessel; 0 if its true size is not known: then they give parts.
/// `by_line`: the pot was thrown along the line of `target` at its own size, so try_next blames a
/// pot's height where its widths fit the line. The same bits on every machine. Allocates.
Score judge(const Profile& target, const Profile& made, bool scale_free = true,
            double true_scale = 1.0, const settings::Rubric& rubric = {}, bool by_line = false);

}  // namespace onggi::score
