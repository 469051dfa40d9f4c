#pragma once

#include <string>
#include <vector>

#include "kiosk/visit/screens/desk.h"

namespace onggi::screens {

/// Measures the pot on the wheel, if it should answer a description: twice a second, slowly enough
/// to read. The desk keeps the figures. Does nothing without a description.
class MeasuredPot {
 public:
  static constexpr double kLook = 0.5;  ///< s

  /// Call once a frame; `made` may be empty.
  void update(Desk& desk, const Profile& made);
  /// "It holds 0.62 l of 1 l." and the wanted bounds; empty if nothing is known.
  static std::vector<std::string> sentences(const Desk& desk);
  /// Language key of the next advice; "": there is no description.
  static std::string hint(const Desk& desk);
  /// Every possible result of hint().
  static const std::vector<std::string>& hints();

 private:
  double looked_ = -kLook;
};

}  // namespace onggi::screens
