#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "kiosk/visit/screens/visit_notes.h"

namespace onggi::screens {

class Desk;
class Screen;

/// Facts about a screen that are known without opening it. A new screen needs its pair of files,
/// its ScreenId, a row in screen_kind.cpp, and its words `help.NAME` and `help.NAME_keys`.
struct ScreenKind {
  ScreenId id;
  std::string_view name;  ///< In counts, logs and language keys: "kiln".
  /// `desk` outlives the screen.
  std::unique_ptr<Screen> (*make)(Desk& desk);
  /// Visitors read here: "are you still there?" waits for `idle.result_after`.
  bool reads_long = false;
  bool fires = false;  ///< The kiln's fire is heard.
};

/// All kinds, in the order of a visit, which is ScreenId's.
std::span<const ScreenKind> screen_kinds() noexcept;
const ScreenKind& kind_of(ScreenId id) noexcept;

}  // namespace onggi::screens
