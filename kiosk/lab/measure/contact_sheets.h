#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/lab/measure/every_screen.h"

namespace onggi::measure {

/// One way in which all screens are looked at.
struct Sight {
  int width = 1280, height = 720;
  std::string language = "en";
  std::string comfort;  ///< As settings::Exhibit::Screen's; "all" of them; "": none.
  friend bool operator==(const Sight&, const Sight&) = default;
  /// "1280x720_en_larger_text"
  std::string name() const;
};

/// Sights that stand beside one another on a sheet.
struct SheetPlan {
  std::string name;  ///< Of its file, without an ending.
  std::vector<Sight> sights;
  bool kept = true;  ///< A sheet is made of them; else they are looked at alone.
};

/// Those of kiosk/docs: every language on a landscape and on an upright screen, every comfort on
/// both, and two further sizes; with the rest of the sizes in every language, which has no sheet.
std::vector<SheetPlan> plans(const std::vector<std::string>& languages);

/// A walk through screens that looks at each: look_at_every_screen(), or another.
using ScreenWalk = std::function<Result<void>(const LookAtScreen&)>;

/// Draws every screen of `walk` in every sight of `plans`, and a sheet of each plan
/// as `folder`/NAME.jpg, a row a state. With `full` also each at full size as
/// `folder`/SIGHT/NN_STATE.jpg; without it only what stands on a sheet is drawn. Files are written
/// durably. `told` hears the states as they come. The kiosk is stepped, and shows all the languages
/// of `plans`. Problem: a control that is missing, words that do not fit their box, a disk that is
/// full.
Result<void> draw_contact_sheets(exhibit::Kiosk& kiosk, const ScreenWalk& walk,
                                 const std::vector<SheetPlan>& plans,
                                 const std::filesystem::path& folder, bool full,
                                 const std::function<void(const std::string&)>& told);

}  // namespace onggi::measure
