#pragma once

#include "engine/profile/profile.h"

namespace onggi {

/// Lengths that a potter measures with callipers. Metres.
struct Dimensions {
  double height = 0.0;
  double belly = 0.0;         ///< Largest outer diameter.
  double belly_height = 0.0;  ///< Height of it.
  double mouth = 0.0;         ///< Outer diameter at the rim.
  double neck = 0.0;          ///< Smallest outer diameter above the belly.
  double neck_height = 0.0;   ///< Height of it.
  double foot = 0.0;          ///< Outer diameter at the standing surface.
  /// How open the way in is: inner / outer radius where that is least, from the widest place, or
  /// half of the height, or three quarters of it, whichever is in the middle, up to the rim. 0..1;
  /// 0 where it is shut, and where the inner wall was not measured.
  double opening = 0.0;
  double wall_mean = 0.0;  ///< Mean wall thickness above the floor.
  double wall_evenness =
      0.0;  ///< 1 - (standard deviation / mean) of that thickness, clamped to 0..1.
};

Dimensions dimensions(const Profile& p);

/// The similarity of two profiles as pure figures; the kiosk turns them into points
/// (kiosk/collection/score).
struct Measures {
  double scale = 1.0;  ///< The factor put on `made` before comparing (1 when not scale-free).
  double outline_overlap = 0.0;     ///< Area inside both half outlines / area inside either. 0..1.
  double outline_rms = 0.0;         ///< RMS radial distance of the outer outlines / target height.
  double outline_worst = 0.0;       ///< Largest such distance / target height.
  double outline_worst_at = 0.0;    ///< Height of it / target height, 0..1.
  double outline_worst_sign = 0.0;  ///< +1 made is too wide there, -1 too narrow, 0 equal.
  /// The largest distance that a shift of 0.6 % of the height up or down does not explain: if a
  /// shelf or a flange begins slightly higher, the radial distance jumps and this one does not.
  double outline_worst_firm = 0.0;
  /// That largest distance among the heights that both reach, with its height and sign as above:
  /// the place to speak of. Smaller than above only where sizes count.
  double common_firm = 0.0, common_firm_at = 0.0, common_firm_sign = 0.0;
  double volume_overlap = 0.0;  ///< Volume inside both outlines turned / inside either. 0..1.
  /// RMS difference of how far the outlines turn from one twelfth of their length to the next,
  /// radians: 0 where they bend alike, whatever their width.
  double turning_rms = 0.0;
  double out_of_round = 0.0;  ///< Profile::out_of_round of the pot, after `scale`, metres.
  Dimensions target;          ///< Of the target, its own size.
  Dimensions made;  ///< Of the pot, after `scale`; its opening is that over the target's heights.
  /// How much of the target's opening the pot lacks, 0..1: 0 where it is as open or more so, 1
  /// where it is shut; 0 also where either's is not known, and where the target's own is shut or
  /// nearly: it has a lid.
  double opening_lacking = 0.0;
};

/// Compares `made` with `target`. Overlaps, distances and turning are the same with the two
/// exchanged where sizes do not count, since both then have one height. With `scale_free`, `made`
/// is first scaled about the axis' foot by the factor that equals the two heights. Allocates
/// nothing. Both must be valid.
Measures compare(const Profile& target, const Profile& made, bool scale_free);

}  // namespace onggi
