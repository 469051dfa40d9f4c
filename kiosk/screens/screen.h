#pragma once

#include <memory>
#include <string>

#include "kiosk/screens/desk.h"
#include "kiosk/screens/page.h"

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
  /// A control of its own was pressed.
  virtual void press(const std::string& control) = 0;
  /// A finger went down on a control; press() follows when it is lifted there.
  virtual void hold(const std::string& /*control*/) {}
  virtual void back() = 0;
  /// Where the keyboard begins.
  virtual std::string first_focus() const = 0;

  virtual void update(double /*dt*/) {}
  /// A pointer that is on no control, or was grabbed by grab().
  virtual void pointer(const view::InputEvent&, const Page&) {}
  /// Before focus and buttons get it; true when used up.
  virtual bool key(view::Key, bool /*repeat*/) { return false; }
  /// The screen is left, or something lies over it: hands off the clay.
  virtual void let_go() {}
  /// Of "help.NAME" in the languages.
  std::string help_key() const { return "help." + std::string(name_of(id())); }

 protected:
  Desk& desk;
};

std::unique_ptr<Screen> make_attract(Desk& desk);
std::unique_ptr<Screen> make_choose(Desk& desk);
std::unique_ptr<Screen> make_throwing(Desk& desk);
std::unique_ptr<Screen> make_result(Desk& desk);
std::unique_ptr<Screen> make_kiln(Desk& desk);
std::unique_ptr<Screen> make_keepsake(Desk& desk);
std::unique_ptr<Screen> make_fault(Desk& desk);

/// Back, Help and the other languages, at the foot of every screen.
std::vector<Button> standing_buttons(const Desk& desk, bool with_back);
/// "language" for the language after the present one, "language.CODE" for any others.
std::vector<Button> language_buttons(const Desk& desk);
/// The language that a control named by language_buttons() stands for.
std::optional<std::size_t> language_of(const Desk& desk, const std::string& control);

/// What lies over a screen instead of its words.
void lay_out_help(Page& page, const Desk& desk, const std::string& help_key);
void lay_out_idle(Page& page, const Desk& desk, double seconds_left, double countdown);

}  // namespace onggi::screens
