#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/effects/beating.h"
#include "engine/effects/moisture.h"
#include "engine/effects/prints.h"
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
#include "kiosk/visit/decorating/decorated_pot.h"
#include "kiosk/visit/screens/advice.h"
#include "kiosk/visit/screens/device_news.h"
#include "kiosk/visit/screens/screen_text.h"
#include "kiosk/visit/screens/todays_pot.h"
#include "kiosk/visit/screens/visit_notes.h"
#include "kiosk/wheel/loop/wheel_commands.h"
#include "kiosk/wheel/loop/wheel_view.h"

namespace onggi::screens {

/// The end of a pot, if its scene has a kiln.
struct Kiln {
  double dried_size = 1.0;  ///< Size after drying, as a share of the thrown length, 0..1.
  double fired_size = 1.0;  ///< Size after firing, as a share of the thrown length.
  double coat = 1.0;        ///< Thickness of the glass, as a share of 0.5 mm.
  const std::vector<content::Glaze>* glazes = nullptr;  ///< The choices; at least one.
  std::vector<int> order;  ///< All their indices, as they are offered: the vessel's own first.
};

/// The part of a vessel's scene that the screens need.
struct SceneForVisitor {
  double max_speed = 31.4;     ///< rad/s
  double tool_radius = 0.008;  ///< m, of the ball: tool 0.
  std::uint8_t palm = 0;       ///< The tool of an outside hand,
  double palm_radius = 0.008;  ///< and its radius, m.
  struct Rib {
    std::uint8_t tool = 0;                    ///< HandInput::tool.
    double length = 0.09, thickness = 0.003;  ///< m
  };
  std::optional<Rib> rib;  ///< The flat rib, if the scene has it.
  struct Trimmer {
    std::uint8_t tool = 0;
    double radius = 0.008;  ///< m
  };
  std::optional<Trimmer> trimmer;    ///< The loop trimmer, if the scene has it,
  std::optional<std::uint8_t> wire;  ///< and the wire.
  /// Diameter of the coil that the pot is built of, m; none: it is not built. The coil is then the
  /// first of `tools`.
  std::optional<double> coil;
  double pace = 0.5;    ///< m/s: a rim that passes faster takes no coil.
  double floor = 0.01;  ///< m: height of the floor on which it is built.
  /// The paddle that beats the wall; none: nobody beats it. It is then the first of `tools`, or the
  /// first after the coil.
  std::optional<BeatingDef> beating;
  std::optional<MoistureDef> moisture;  ///< Of a built pot; none: the clay is always as it was.
  std::optional<PrintsDef> prints;  ///< What paddle and anvil leave; none: nothing is kept of it.
  struct Tool {
    std::uint8_t tool = 0;  ///< HandInput::tool.
    std::string name;       ///< Its shape's name, "coil" or "paddle"; language keys
                            ///< "tool.flat_rib" and "tool.flat_rib_is".
    double reach = 0;       ///< m from the middle of its working part to the working face,
    double below = 0;       ///< and to its lowest point.
  };
  std::vector<Tool> tools;  ///< All of the scene's tools, in the tray's order.
  std::optional<Kiln> kiln;
  /// How visitors may decorate the pot; null: not at all. Outlives the visit.
  const decoration::Way* way = nullptr;
  std::vector<std::string> shown{"follow"};  ///< Scripts of attract mode, pot by pot; at least one.
  bool keeps_clay = false;                   ///< Clay keeps its volume, so pressing raises the pot.
  double tear_thickness = 0;                 ///< Metres: a thinner wall tears; 0: no wall tears.
};

/// A vessel for the screens.
struct ShelfCard {
  const content::Vessel* vessel = nullptr;
  view::PictureId picture = 0;  ///< 0 until it has been rendered.
  Profile target;               ///< At workspace scale, foot at 0.
  double scale = 1.0;           ///< Workspace size / true size.
  SceneForVisitor wheel;
  std::optional<SceneForVisitor> built{};  ///< Where it may also be built of coils.
};

/// A mission that is offered today, before the shelf.
struct MissionCard {
  const settings::Mission* mission = nullptr;
  int card = -1;  ///< The card to throw: on the shelf, or own_card() of this one.
  ShelfCard own;  ///< For a description: a pot that answers it, not a vessel.
};

/// The card number of the `mission`th MissionCard's own card, below -1.
constexpr int own_card(int mission) { return -2 - mission; }
/// The inverse of own_card(); negative for cards of the shelf, and for none.
constexpr int mission_of_own(int card) { return -2 - card; }

/// Requests of the visit, which the program carries out between frames. StartPot: a fresh lump for
/// this vessel. Scripted: attract throws it, or its screen does if `script` is "".
struct StartPot {
  int card = 0;  ///< As Visit's card; may be own_card().
  bool scripted = false;
  std::string script = "follow";
  bool built = false;  ///< In the scene of ShelfCard::built.
};
struct MakeKeepsake {
  int card = 0;
  score::Score score;
  Profile made;    ///< As thrown.
  int glaze = -1;  ///< Index in Kiln::glazes; -1: not fired.
  /// Null: not decorated. It may not be settled() yet. Its words are of the visitor's language.
  std::shared_ptr<decorating::DecoratedPot> decorated{};
  std::string decorated_how{};
  bool built = false;  ///< In the scene of ShelfCard::built.
};
/// The visit is over: discard postcard and replay. `notes` is empty if nobody used the screen.
struct VisitEnded {
  std::optional<VisitNotes> notes;
};
using Request = std::variant<StartPot, MakeKeepsake, VisitEnded>;

/// The visit's inputs. All must outlive it.
struct VisitInputs {
  const settings::Exhibit* exhibit = nullptr;
  /// In the exhibit's order, at least one.
  const std::vector<content::Language>* languages = nullptr;
  const std::vector<ShelfCard>* shelf = nullptr;  ///< May grow at its end.
  const view::TextMeasure* measure = nullptr;
  const loop::WheelView* wheel = nullptr;
  loop::WheelCommands* wheel_commands = nullptr;
  /// For the first minute at the wheel; may be absent.
  const std::vector<content::LessonStep>* lesson = nullptr;
  const std::vector<content::LessonStep>* build_lesson = nullptr;  ///< Of a pot that is built.
  const DeviceNews* devices = nullptr;  ///< May be absent: no device news then.
  /// For the gallery, newest first; may be absent.
  const std::vector<TodaysPot>* todays = nullptr;
  /// In their order; may be absent. Changes only while nobody is there.
  const std::vector<MissionCard>* missions = nullptr;
};

/// The throwing screen as a visitor sees it: the pot's place on the screen, the target line, the
/// clay's outline, and the hint. Pointers are valid until the next frame.
struct WheelSnapshot {
  view::Camera camera;
  const Profile* target = nullptr;  ///< The vessel, or a pot that answers the description.
  const Profile* made = nullptr;
  Hint hint;
  std::string tool{};  ///< The control in the tray of what the hint asks to take; empty: nothing.
};

/// The visit as a state machine: attract -> (clay ->) choose -> throw -> result -> decorate (if the
/// vessel has a way) -> kiln (if there is one) -> keepsake -> attract, with the idle warning over
/// any of them but attract. Knows no clock, window or file: time and input come in; frames,
/// commands and requests go out. Main thread.
class Visit {
 public:
  explicit Visit(const VisitInputs& world);
  ~Visit();

  void input(const view::InputEvent& event, double now);
  /// Once a frame. `now` is seconds on a clock that never goes back.
  void update(double now);
  view::Frame frame(int width, int height);
  std::optional<Request> take_request();

  /// From now on, still pictures move slowly (screens::drift), for a screen that is on for months.
  void wander();

  void show_postcard(view::PictureId id);
  /// The postcard is saved. `name` is for the visitor to remember. `page`: its address for a phone;
  /// "": none. `folder`: as TodaysPot::visit.
  void keepsake_kept(const std::string& name, const std::string& page = "",
                     const std::string& folder = "");
  void keepsake_failed(const Problem& why);
  /// Shows the fault screen and logs `why` for staff. A touch goes back to attract.
  void fail(const Problem& why);
  /// For a curator, before the first update(): nothing but the screen Decorate, with `pot` (m, foot
  /// at 0), the outline of `card`'s vessel. Nobody's absence ends it, and decorated_pot() keeps its
  /// work. It does not begin where the vessel has no way, or `pot` is no outline:
  /// decorated_pot() is then null.
  void decorate(int card, const Profile& pot, double now);
  /// True once the curator has pressed the button onward, or gone back.
  bool has_decorated() const;
  /// The program ends: ends the visit, which sends VisitEnded as usual.
  void close(double now);

  ScreenId screen() const;
  bool idle_warning() const;
  const std::string& language() const;  ///< Code in use.
  /// Switches to the language of this code, if the exhibit has it, without a visitor's request.
  void speak(const std::string& code);
  /// The pot that the visitor decorates; null before it was begun.
  const decorating::DecoratedPot* decorated_pot() const;
  /// The decoration of the pot that is shown; null: none.
  const decoration::CoatPicture* decoration() const;
  /// The visitor's share of the force, 0 (off) .. 1.
  double force_share() const;
  /// The visitor's volume, 0 (silent) .. 1 of the exhibit's.
  double volume_share() const;
  /// The exhibit's screen with the visitor's choices on the Accessibility page.
  settings::Exhibit::Screen shown_on() const;
  /// True if the screen is read aloud, by the visitor's choice or because it is dark.
  bool spoken() const;
  /// The score of the last pot that was called done, as on the result screen.
  const score::Score& score() const;

  /// The place of a control in the last frame, for tests and the scripted visitor:
  ///   attract   "attract.begin" (any touch begins), "attract.gallery" (if pots were kept today)
  ///   clay      "clay.on", "clay.press" (for visitors who make strokes by buttons)
  ///   choose    "choose.mission.N" (missions offered today, before the shelf),
  ///             "choose.card.N" (N counts the whole shelf; present only for this page's cards),
  ///             "choose.next", "choose.previous"; a card opens its label: "choose.build"
  ///             (if the vessel may be built of coils), "choose.throw",
  ///             "choose.more" (rest of a long label), "choose.alike" (label of the most similar
  ///             vessel, if any), "back" to the shelf
  ///   throw     "throw.both", "throw.outside", "throw.inside", "throw.slower", "throw.faster",
  ///             "throw.water", "throw.cut", "throw.renew", "throw.restore" (if a stroke can be
  ///             undone), "throw.done", "throw.tool.N" (0 the hands, then the scene's; the wire
  ///             ends the throwing), "throw.show", "throw.skip" (during the lesson); with a
  ///             force device "throw.softer", "throw.stronger"
  ///   result    "result.keep", "result.onward" (a vessel or mission by name, if one is offered),
  ///             "result.again", "result.other", "result.figures" (if there is a vessel),
  ///             "result.turn" (the pots, for keys and the switch)
  ///   kiln      "kiln.glaze.N", "kiln.keep" (once a glaze is chosen)
  ///   keepsake  "keepsake.done", "keepsake.gallery"
  ///   fault     "fault.on"
  ///   gallery   "gallery.next", "gallery.previous" (in attract and keepsake)
  ///   over any  "help", "help.close", "comfort", "comfort.close", "comfort.CHOICE" (Comfort),
  ///             "language" (the globe), "language.CODE", "language.close", "idle.stay", "back",
  ///             "leaving.close", "leaving.go" (the question before an unkept pot is given up)
  /// Nothing if it is not on the screen. A control acts when the pointer lifts on it.
  std::optional<view::Rect> control(const std::string& id) const;
  /// True if this finger or key would press the clay.
  bool works(const view::InputEvent& event) const;
  /// What the throwing screen shows, for scripted visitors. Empty on other screens.
  std::optional<WheelSnapshot> sight() const;
  /// All controls, in reading order.
  std::vector<std::pair<std::string, view::Rect>> controls() const;
  /// The content of the screen after the last frame().
  ScreenText reading() const;
  /// Activates `control` as the keyboard does, even if it is off-screen; unknown ids are ignored.
  /// An empty id only resets the idle timer.
  void activate(const std::string& control, double now);
  /// Moves the keyboard to `control`, which must be on the screen.
  void focus_on(const std::string& control, double now);
  /// The control that has the keyboard; empty while a pointer is used or the keys move the hand.
  const std::string& focus() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace onggi::screens
