#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/focus.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// One screen of the visit. Lays itself out anew for every frame from what the desk knows.
class Screen {
 public:
  explicit Screen(Desk& d) : desk(d) {}
  virtual ~Screen() = default;
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  virtual ScreenId id() const = 0;
  virtual void lay_out(Page& page) = 0;
  virtual std::optional<view::PotView> pot(const Page&) { return std::nullopt; }
  /// It is dark, with words alone, and what is on it is told by sound too.
  virtual bool dark() const { return false; }
  /// A control of its own was pressed.
  virtual void press(const std::string& control) = 0;
  /// A finger went down on a control; press() follows when it is lifted there.
  virtual void hold(const std::string& /*control*/) {}
  virtual void back() = 0;
  /// Attract: a touch on `control` (none: "") begins a visit.
  virtual bool begins_with(const std::string& /*control*/) const { return true; }
  /// Where the keyboard begins.
  virtual std::string first_focus() const = 0;

  virtual void update(double /*dt*/) {}
  /// A pointer that is on no control, or was grabbed by grab().
  virtual void pointer(const view::InputEvent&, const Page&) {}
  /// Any pointer event before the controls get it; true when it belongs to a finger that drags, and
  /// what it went down on is then not pressed.
  virtual bool drag(const view::InputEvent&, const Page&) { return false; }
  /// Where an arrow leads from the control `from`, if the screen knows better than that it is the
  /// nearest that way: a control that the next page will have. Empty: it does not.
  virtual std::string step(const std::string& /*from*/, Direction) { return {}; }
  /// Before focus and buttons get it; true when used up.
  virtual bool key(view::Key, bool /*repeat*/) { return false; }
  /// The keys are another visitor's than the pointer, which takes nothing from them.
  virtual bool keys_are_anothers() const { return false; }
  /// The screen is left, or something lies over it: hands off the clay.
  virtual void let_go() {}
  /// The visitor has chosen otherwise on the Comfort page: what was told to the wheel is told anew.
  virtual void comforted() {}
  /// Of a screen with a pot to be worked.
  virtual std::optional<Sight> sight() const { return std::nullopt; }
  /// Of a screen with a pot to be worked: Reading has it.
  struct PotTold {
    bool working = false;
    int asked = 0;
    std::vector<std::string> differences;
  };
  virtual std::optional<PotTold> told() const { return std::nullopt; }
  /// Of "help.NAME" in the languages.
  std::string help_key() const { return "help." + std::string(name_of(id())); }
  /// What Help says of it, but for its keys: a paragraph each.
  virtual std::vector<std::string> help() const { return {desk.say(help_key())}; }

 protected:
  Desk& desk;
};

}  // namespace onggi::screens
