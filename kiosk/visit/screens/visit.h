#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kiosk/collection/content/glaze.h"
#include "kiosk/collection/content/language.h"
#include "kiosk/collection/content/lesson.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/collection/score/score.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/collection/settings/mission_file.h"
#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/input.h"
#include "kiosk/picture/view/measure.h"
#include "kiosk/visit/screens/advice.h"
#include "kiosk/visit/screens/device_news.h"
#include "kiosk/visit/screens/reading.h"
#include "kiosk/visit/screens/todays_pot.h"
#include "kiosk/visit/screens/visit_notes.h"
#include "kiosk/wheel/loop/potter.h"
#include "kiosk/wheel/loop/wheel_view.h"

namespace onggi::screens {

/// What happens to a pot at the end, where its scene has a kiln.
struct Kiln {
  double dried_size = 1.0;  ///< What drying leaves of every length, 0..1.
  double fired_size = 1.0;  ///< And the kiln, of the thrown length.
  double coat = 1.0;        ///< The glass, as a share of 0.5 mm.
  const std::vector<content::Glaze>* glazes = nullptr;  ///< To choose from; at least one.
};

/// What a visitor meets of the scene in which a vessel is thrown.
struct Wheel {
  double max_speed = 31.4;     ///< rad/s
  double tool_radius = 0.008;  ///< m, of the ball: tool 0.
  std::uint8_t palm = 0;       ///< The tool that a hand outside works with,
  double palm_radius = 0.008;  ///< and its radius, m.
  struct Rib {
    std::uint8_t tool = 0;                    ///< HandInput::tool.
    double length = 0.09, thickness = 0.003;  ///< m
  };
  std::optional<Rib> rib;  ///< The flat rib, where the scene has it to hand.
  struct Trimmer {
    std::uint8_t tool = 0;
    double radius = 0.008;  ///< m
  };
  std::optional<Trimmer> trimmer;    ///< Likewise the loop trimmer,
  std::optional<std::uint8_t> wire;  ///< and the wire.
  /// A tool that lies to hand, as a hand works with it.
  struct Tool {
    std::uint8_t tool = 0;  ///< HandInput::tool.
    std::string name;       ///< Of its shape: "flat_rib"; "tool.flat_rib" in the languages.
    double reach = 0;       ///< m from the middle of its working part to the face it works,
    double below = 0;       ///< and down to its lowest point.
  };
  std::vector<Tool> tools;  ///< All of the scene's, in the order of the tray.
  std::optional<Kiln> kiln;
  std::vector<std::string> shown{"follow"};  ///< Scripts of attract mode, pot by pot; at least one.
  bool keeps_clay = false;  ///< What is pressed away goes elsewhere, and the pot gets higher by it.
  double tear_thickness = 0;  ///< Metres: a wall that gets thinner tears; 0 where none does.
};

/// A vessel as the screens know it.
struct ShelfCard {
  const content::Vessel* vessel = nullptr;
  view::PictureId picture = 0;  ///< 0 until the app has had it rendered.
  Profile target;               ///< At workspace scale, foot at 0.
  double scale = 1.0;           ///< Workspace size / true size.
  Wheel wheel;
};

/// Something to do at the wheel that is on today, and stands before the shelf.
struct MissionCard {
  const settings::Mission* mission = nullptr;
  int card = -1;  ///< What is to be thrown: of the shelf, or own_card() of this one.
  ShelfCard own;  ///< Of a description: one pot that answers it, which is nobody's vessel.
};

/// Cards that are of no shelf: the own one of the `mission`th MissionCard, below -1.
constexpr int own_card(int mission) { return -2 - mission; }
/// And back; below 0 for those of the shelf, and for none.
constexpr int mission_of_own(int card) { return -2 - card; }

/// What the visit asks of the program, carried out by app between frames.
struct StartPot {
  int card = 0;  ///< As Visit's; also own_card().
  bool scripted = false;
  std::string script = "follow";
};  ///< A fresh lump for this vessel; scripted: thrown so (attract), by the screen where that is
    ///< "".
struct MakeKeepsake {
  int card = 0;
  score::Score score;
  Profile made;    ///< As thrown.
  int glaze = -1;  ///< Of Kiln::glazes; -1: not fired.
};
struct ForgetVisitor {
  std::optional<VisitNotes> notes;
};  ///< Idle or done: drop postcard, replay, everything of the visitor. What may be counted is
    ///< left; nothing, where a fault was shown to nobody.
using Request = std::variant<StartPot, MakeKeepsake, ForgetVisitor>;

/// What the visit may look at. All outlive it.
struct VisitWorld {
  const settings::Exhibit* exhibit = nullptr;
  const std::vector<content::Language>* languages =
      nullptr;                                    ///< In the exhibit's order, at least one.
  const std::vector<ShelfCard>* shelf = nullptr;  ///< May grow, at its end.
  const view::TextMeasure* measure = nullptr;
  const loop::WheelView* wheel = nullptr;
  loop::PotterCommands* potter = nullptr;
  const std::vector<content::LessonStep>* lesson =
      nullptr;                          ///< Of the first minute at the wheel; may be absent.
  const DeviceNews* devices = nullptr;  ///< May be absent: nothing is told of devices then.
  const std::vector<TodaysPot>* todays =
      nullptr;  ///< For the gallery, newest first; may be absent.
  const std::vector<MissionCard>* missions =
      nullptr;  ///< In their order; may be absent. Changes only while nobody is here.
};

/// The throwing screen as a visitor sees it: where the pot is on the screen, the line to meet, the
/// outline of the clay, and what the hint says. Pointers live until the next frame.
struct Sight {
  view::Camera camera;
  const Profile* target = nullptr;  ///< Or one pot that answers the description.
  const Profile* made = nullptr;
  Hint hint;
};

/// The visit as a state machine: attract -> choose -> throw -> result -> kiln (where there is one)
/// -> keepsake -> attract, with
/// the idle warning over any of them but attract. Knows no clock, window or file: time and input
/// come in, frames, commands and requests go out. Main thread.
class Visit {
 public:
  explicit Visit(const VisitWorld& world);
  ~Visit();

  void input(const view::InputEvent& event, double now);
  /// Once a frame. `now` is seconds on a clock that never goes back.
  void update(double now);
  view::Frame frame(int width, int height);
  std::optional<Request> take_request();

  /// From here on still things wander (screens::drift), as a screen that is on for months wants it.
  void wander();

  void show_postcard(view::PictureId id);
  /// The postcard is safe on disk (`file` as the visitor may be told), or could not be kept.
  /// `page`: the address at which a phone finds it; "": none does.
  void keepsake_kept(const std::string& file, const std::string& page = "");
  void keepsake_failed(const Problem& why);
  /// Something the visitor should know and staff should mend; `why` in the log. Touch goes back to
  /// attract.
  void fail(const Problem& why);
  /// The program ends: so does the visit under way, and asks to be forgotten as any other.
  void close(double now);

  ScreenId screen() const;
  bool idle_warning() const;
  const std::string& language() const;  ///< Code in use.
  /// In the language of this code from here on, where the exhibit has it, though nobody asked.
  void speak(const std::string& code);
  /// How much of the force the visitor would feel, 0 (off) .. 1.
  double force_share() const;
  /// How loud this visitor would have it, 0 (silent) .. 1 of what the exhibit allows.
  double volume_share() const;
  /// The exhibit's screen as this visitor has chosen to have it on the Comfort page.
  settings::Exhibit::Screen shown_on() const;
  /// What is on the screen is said aloud: this visitor has chosen so, or the screen is dark.
  bool spoken() const;
  /// Of the pot that was last called done, as the result screen tells it.
  const score::Score& score() const;

  /// Where a control stands in the frame last made, for tests and the scripted visitor:
  ///   attract   "attract.begin" (any touch begins), "attract.gallery" (where pots were kept today)
  ///   choose    "choose.mission.N" (of those that are on, before the shelf),
  ///             "choose.card.N" (N counts the whole shelf; only this page's are there),
  ///             "choose.next", "choose.previous"; a card opens its label: "choose.throw",
  ///             "choose.more" (a long label read on), "choose.alike" (the label of the vessel
  ///             most like it, where one is), "back" to the shelf
  ///   throw     "throw.both", "throw.outside", "throw.inside", "throw.slower", "throw.faster",
  ///             "throw.water", "throw.cut", "throw.renew", "throw.restore" (while there is a
  ///             stroke to take back), "throw.done", "throw.tool.N" (0 the hands, then the
  ///             scene's; the wire ends the throwing), "throw.show", "throw.skip" (while the lesson
  ///             lasts); with a device that pushes "throw.softer", "throw.stronger"
  ///   result    "result.keep", "result.again", "result.other", "result.turn" (what stands there,
  ///             for keys and the switch)
  ///   kiln      "kiln.glaze.N", "kiln.keep" (once a glaze is chosen)
  ///   keepsake  "keepsake.done", "keepsake.gallery"        fault  "fault.on"
  ///   the gallery in both  "gallery.next", "gallery.previous"
  ///   over any  "help", "help.close", "comfort", "comfort.close", "comfort.CHOICE" (Comfort),
  ///             "idle.stay", "language", "back"
  /// Nothing when it is not on the screen. A control acts when the pointer is lifted on it.
  std::optional<view::Rect> control(const std::string& id) const;
  /// What somebody at the wheel has before their eyes, for scripted visitors; nothing on other
  /// screens.
  std::optional<Sight> sight() const;
  /// All of them, in reading order.
  std::vector<std::pair<std::string, view::Rect>> controls() const;
  /// What stands on the screen since the last frame().
  Reading reading() const;
  /// As a key does it that is pressed on `control`, on the screen or not; nothing where it means
  /// nothing there. Empty: somebody is there, and that is all.
  void activate(const std::string& control, double now);
  /// The keyboard is on `control`, which is on the screen.
  void focus_on(const std::string& control, double now);
  /// The control that the keyboard is on; empty while a pointer is used or the keys move the hand.
  const std::string& focus() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace onggi::screens
