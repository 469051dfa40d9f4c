#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "kiosk/exhibit/composition/kiosk.h"
#include "tests/pages/every_screen.h"

namespace onggi::pages {

/// One combination of size, language and comfort for all screens.
struct Sight {
  int width = 1280, height = 720;
  std::string language = "en";
  std::string comfort;  ///< A name from settings::Exhibit::Screen; "all" of them; "": none.
  friend bool operator==(const Sight&, const Sight&) = default;
  /// "1280x720_en_larger_text"
  std::string name() const;
};

/// Sights side by side on a sheet.
struct SheetPlan {
  std::string name;  ///< Its file name without an ending.
  std::vector<Sight> sights;
  bool kept = true;  ///< Make a sheet of them; otherwise only check them.
};

/// The sheets of kiosk/docs: every language on a landscape and a portrait screen, every comfort
/// setting on both, and two further sizes; then the other sizes in every language, without a sheet.
std::vector<SheetPlan> plans(const std::vector<std::string>& languages);

/// A walk through screens that reports each: look_at_every_screen(), or another.
using ScreenWalk = std::function<Result<void>(const LookAtScreen&)>;

/// Draws every screen of `walk` in every sight of `plans`, and a sheet of each plan as
/// `folder`/NAME.jpg, a row for each state. With `full` also each screen at full size as
/// `folder`/SIGHT/NN_STATE.jpg; otherwise it draws only what is on a sheet. Files are written
/// durably. Reports states to `told`. The kiosk must be stepped and have all languages of `plans`.
/// Problem: a missing control, words that do not fit their box, a full disk.
Result<void> draw_contact_sheets(exhibit::Kiosk& kiosk, const ScreenWalk& walk,
                                 const std::vector<SheetPlan>& plans,
                                 const std::filesystem::path& folder, bool full,
                                 const std::function<void(const std::string&)>& told);

}  // namespace onggi::pages
