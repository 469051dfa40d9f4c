#include "kiosk/exhibit/rehearsal/screen_tour.h"

#include <algorithm>
#include <array>

#include "kiosk/exhibit/rehearsal/screen_walk.h"
#include "kiosk/visit/screens/comfort.h"

namespace onggi::rehearsal {

namespace {

using screens::ScreenId;

constexpr std::array<std::string_view, 11> kToured{"attract",  "language", "choose",  "comfort",
                                                   "label",    "throw",    "help",    "result",
                                                   "decorate", "kiln",     "keepsake"};
constexpr double kAttractMoves = 8.0;  // s until the clay of attract is no lump any more
constexpr double kHalfAPot = 0.45;     // of a script: the lesson and the outline say something then
constexpr double kOutOfTheFire = 9.0;  // s

/// Goes through one visit until the screen that is wanted.
class Tour {
 public:
  Tour(exhibit::Kiosk& kiosk, std::string_view wanted, int card)
      : kiosk_(kiosk),
        walk_(kiosk),
        wanted_(wanted),
        card_("choose.card." + std::to_string(card)) {}

  Result<void> go() {
    static_cast<void>(attract() || choose() || wheel() || result() || surface() || keepsake());
    return walk_.result();
  }

 private:
  bool is(std::string_view screen) const { return screen == wanted_ || !walk_.good(); }
  /// The walk stands where it was to go.
  bool arrived() {
    walk_.frames(ScreenWalk::kSettled);
    return true;
  }
  bool over(std::string_view screen, const char* control) {
    if (!is(screen)) return false;
    walk_.touch(control);
    return arrived();
  }
  /// The exhibit is without the wanted screen.
  bool lacks(const std::string& what, const std::string& remedy) {
    walk_.fail(problem("onggi screen " + std::string(wanted_), what, remedy));
    return true;
  }
  bool at(ScreenId screen) const { return kiosk_.visit().screen() == screen; }

  bool attract() {
    walk_.frames(kAttractMoves);
    if (is("attract")) return true;
    if (wanted_ == "language" && !walk_.has("language"))
      return lacks("This exhibit has one language, so nobody chooses one.",
                   "Name another screen, or add a language.");
    if (over("language", "language")) return true;
    walk_.touch("attract.begin");
    walk_.frames(ScreenWalk::kSettled);
    return false;
  }
  bool choose() {
    if (is("choose")) return arrived();
    if (over("comfort", "comfort")) return true;
    walk_.turn_to(card_);
    walk_.touch(card_);
    walk_.frames(ScreenWalk::kSettled);
    if (is("label")) return true;
    walk_.touch("choose.throw");
    walk_.frames(ScreenWalk::kSettled);
    return false;
  }
  bool wheel() {
    if (over("help", "help")) return true;
    if (is("throw")) {
      walk_.throw_pot(kHalfAPot);
      return true;
    }
    walk_.throw_pot(1.0);
    walk_.touch("throw.done");
    return false;
  }
  bool result() {
    walk_.frames(ScreenWalk::kSettled);
    if (is("result")) return arrived();
    walk_.touch("result.keep");
    walk_.frames(ScreenWalk::kSettled);
    return false;
  }
  bool surface() {
    if (wanted_ == "decorate" && walk_.good() && !at(ScreenId::decorate))
      return lacks("Nobody decorates a pot of this vessel.",
                   "Name another screen, or a vessel with a way in its vessel.toml, of an exhibit "
                   "with decorate = true and ways.");
    if (is("decorate")) return arrived();
    if (at(ScreenId::decorate)) {
      walk_.touch("decorate.on");
      walk_.frames(ScreenWalk::kSettled);
    }
    if (wanted_ == "kiln" && walk_.good() && !at(ScreenId::kiln))
      return lacks("The scene of this vessel has no kiln.",
                   "Name another screen or vessel, or put [kiln] into the scene.");
    if (is("kiln")) return arrived();
    if (at(ScreenId::kiln)) {
      walk_.touch("kiln.glaze.0");
      walk_.frames(kOutOfTheFire);
      walk_.touch("kiln.keep");
    }
    return false;
  }
  bool keepsake() {
    walk_.until("the keepsake",
                [this] { return kiosk_.doing().kept && kiosk_.doing().kept->saved; });
    return arrived();
  }

  exhibit::Kiosk& kiosk_;
  ScreenWalk walk_;
  std::string_view wanted_;
  std::string card_;
};

}  // namespace

std::span<const std::string_view> toured_screens() { return kToured; }

std::vector<std::string> comfort_choices() {
  std::vector<std::string> names;
  for (const screens::Comfort::Choice& choice : screens::Comfort::kChoices)
    names.emplace_back(choice.name);
  return names;
}

settings::Exhibit::Screen with_comfort(settings::Exhibit::Screen screen,
                                       const std::vector<std::string>& choices) {
  for (const screens::Comfort::Choice& choice : screens::Comfort::kChoices)
    if (std::ranges::find(choices, choice.name) != choices.end()) screen.*choice.of = true;
  return screen;
}

Result<void> lead_to(exhibit::Kiosk& kiosk, std::string_view screen, int card) {
  return Tour(kiosk, screen, card).go();
}

}  // namespace onggi::rehearsal
