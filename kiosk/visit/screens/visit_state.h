#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "kiosk/visit/screens/idle.h"
#include "kiosk/visit/screens/screen.h"
#include "kiosk/visit/screens/screen_kind.h"

namespace onggi::screens {

enum class Over { nothing, help, comfort, languages, leaving, idle };

/// The inside of a visit: the current screen, its overlay, the keyboard's place.
struct Visit::State {
  explicit State(const VisitInputs& world)
      : desk(world), measuring(*world.measure), screen(kind_of(ScreenId::attract).make(desk)) {}

  Desk desk;
  Measuring measuring;
  std::unique_ptr<Screen> screen;
  std::unique_ptr<Page> page;  ///< The last one shown.
  IdleWatch idle;
  Over over = Over::nothing;
  Over under_languages = Over::nothing;  ///< What the page of languages covers.
  std::string leaving;     ///< The control that waits for the answer, whether the pot may go.
  int uncovered = 0;       ///< Frames until what a closed page covered has been seen.
  double calm_until = 0;   ///< A touch before it was meant for the page that closed,
  bool swallowed = false;  ///< as was the finger that is down.
  /// What the page of languages had when it closed. A touch there before that time was meant for
  /// it, unless the same control is there still.
  std::vector<Control> closed;
  double closed_until = 0;
  bool by_keys = false, wanders = false;
  std::string focused, pressed;
  std::uint64_t serial = 1;
  double changed_at = -10, updated_at = -1;
  int tight = 0;  ///< Step of give_way().
  std::string tight_for;
  std::string laid_out_for;  ///< Size and side of the layout under the overlay.
  std::array<Vec3, kMaxHands> device_at{};
  bool hands_taken = false;  ///< LoopStatus::hands_taken at the last look.

  void reworded();
  void changed();
  void apply_pending_screen();
  void cover(Over what);
  void set_language(std::size_t index);
  void open_comfort();
  void open_languages();
  bool press_language(const std::string& control);
  void press(const std::string& control);
  void pointer(const view::InputEvent& e);
  void key(const view::InputEvent& e);
  std::string first_control() const;
  void keep_focus();
  std::string control_at(float x, float y) const;
  bool meant_for_closed(float x, float y) const;
  Page lay_out(int width, int height, const GiveWay& gives);
  void lay_out_fitting(int width, int height);
};

}  // namespace onggi::screens
