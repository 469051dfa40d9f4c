#pragma once

#include <string>
#include <vector>

#include "kiosk/visit/screens/desk.h"

namespace onggi::screens {

/// What the pot on the wheel measures, while it is to answer a description: looked at twice a
/// second, so that its figures can be read. They are the desk's; there where nothing is described,
/// nothing happens.
class MeasuredPot {
 public:
  static constexpr double kLook = 0.5;  ///< s

  /// Once a frame; `made` may be empty.
  void update(Desk& desk, const Profile& made);
  /// "It holds 0.62 l of 1 l." and the bounds that are asked for; nothing where nothing is known.
  static std::vector<std::string> sentences(const Desk& desk);
  /// As a key of the languages what would bring it nearer; "": nothing is described.
  static std::string hint(const Desk& desk);
  /// Every key that hint() can give.
  static const std::vector<std::string>& hints();

 private:
  double looked_ = -kLook;
};

}  // namespace onggi::screens
