#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/focus.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// One screen of the visit. It lays itself out for every frame from the desk's state.
class Screen {
 public:
  explicit Screen(Desk& d) : desk(d) {}
  virtual ~Screen() = default;
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  virtual ScreenId id() const = 0;
  virtual void lay_out(Page& page) = 0;
  virtual std::optional<view::PotView> pot(const Page&) { return std::nullopt; }
  /// True if the screen is dark: only words, and sound also tells its content.
  virtual bool dark() const { return false; }
  /// One of its own controls was pressed.
  virtual void press(const std::string& control) = 0;
  /// A finger went down on a control; press() follows if it lifts there.
  virtual void hold(const std::string& /*control*/) {}
  virtual void back() = 0;
  /// True if this control, or "back", gives up the pot on the wheel for good.
  virtual bool leaves_pot(const std::string& /*control*/) const { return false; }
  /// Attract: a touch on `control` (or nowhere: "") begins a visit.
  virtual bool begins_with(const std::string& /*control*/) const { return true; }
  /// Attract: the touch or key that begins the visit; goes to its first screen.
  virtual void begin(const view::InputEvent&) {}
  /// True if this finger or key would press the clay.
  virtual bool works(const view::InputEvent&) const { return false; }
  /// The control where the keyboard starts.
  virtual std::string first_focus() const = 0;

  virtual void update(double /*dt*/) {}
  /// A pointer event, unless a control is pressed.
  virtual void pointer(const view::InputEvent&, const Page&) {}
  /// True if pointer() takes a touch screen's further fingers, too.
  virtual bool more_fingers() const { return false; }
  /// Sees every pointer event before the controls do. True if it belongs to a dragging finger; the
  /// control under its start is then not pressed.
  virtual bool drag(const view::InputEvent&, const Page&) { return false; }
  /// The control that an arrow reaches from `from`, if it is not the nearest one but a control of
  /// the next page. Empty: the nearest.
  virtual std::string step(const std::string& /*from*/, Direction) { return {}; }
  /// Sees a key before focus and buttons; true if it was used.
  virtual bool key(view::Key, bool /*repeat*/) { return false; }
  /// Keyboard and pointer belong to two visitors; pointer input does not clear keyboard focus.
  virtual bool keys_are_anothers() const { return false; }
  /// The screen is left or covered: takes the hands off the clay.
  virtual void let_go() {}
  /// The visitor changed something on the Accessibility page: sends the wheel its settings again.
  virtual void comforted() {}
  /// For a screen with a pot to work on.
  virtual std::optional<WheelSnapshot> sight() const { return std::nullopt; }
  /// State of the pot for ScreenText; only the throwing screen has one.
  struct PotTold {
    bool working = false;
    int asked = 0;
    std::vector<std::string> differences;
  };
  virtual std::optional<PotTold> told() const { return std::nullopt; }
  std::string help_key() const { return "help." + std::string(name_of(id())); }
  /// Its Help text without its keys, in paragraphs.
  virtual std::vector<std::string> help() const { return {desk.say(help_key())}; }

 protected:
  Desk& desk;
};

}  // namespace onggi::screens
