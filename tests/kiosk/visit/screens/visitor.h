#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "kiosk/visit/screens/measuring.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::screens {

/// Stands in for a font: half an em a Latin letter, a whole one for anything wider, breaks at
/// spaces.
class PlainMeasure final : public view::TextMeasure {
 public:
  Size measure(const std::string& text, const view::TextStyle& style, float width) const override;
};

/// Measures with another, and counts the bytes of words that it was asked for.
class CountingMeasure final : public view::TextMeasure {
 public:
  explicit CountingMeasure(const view::TextMeasure& other) : other_(other) {}
  Size measure(const std::string& text, const view::TextStyle& style, float width) const override {
    asked += text.size() + Measuring::kEach;
    return other_.measure(text, style, width);
  }
  mutable std::size_t asked = 0;  ///< In this frame.

 private:
  const view::TextMeasure& other_;
};

/// Remembers what the screens asked of the wheel.
class RecordedCommands final : public loop::WheelCommands {
 public:
  void start(std::unique_ptr<Scene>) override {}
  void play(std::unique_ptr<Script> script) override { ended += script == nullptr; }
  void hand(int, const HandInput& target) override { hands.push_back(target); }
  void take(int, std::uint8_t tool) override { tools.push_back(tool); }
  void hold(loop::InHand what) override {
    coil = what == loop::InHand::coil;
    paddle = what == loop::InHand::paddle;
  }
  void swing(const script::Swings& now) override { swings.push_back(now); }
  void wheel(double rad_per_s) override { wheels.push_back(rad_per_s); }
  void water(bool held) override { waters.push_back(held); }
  void fire(bool hangs) override { fires.push_back(hangs); }
  void renew() override { ++renewed; }
  void restore() override { ++restored; }
  void pause(bool on) override { pauses.push_back(on); }
  void harden(std::unique_ptr<force::LeatherOutline> made) override { wall = std::move(made); }
  void decorate(const force::DecoratingTool& tool, const force::LeatherTurn& turn) override {
    decorating = tool;
    turned = turn;
  }
  void clear_faults(std::uint32_t which) override { cleared |= which; }
  bool refresh_every_row() override { return ++settled > 0 && answers; }

  std::vector<HandInput> hands;
  std::vector<script::Swings> swings;
  std::vector<double> wheels;
  std::vector<bool> waters, fires;
  std::vector<bool> pauses;
  std::vector<std::uint8_t> tools;
  bool coil = false, paddle = false;
  int renewed = 0, restored = 0, settled = 0, ended = 0;  ///< `ended`: scripts.
  std::uint32_t cleared = 0;
  bool answers = true;
  std::unique_ptr<force::LeatherOutline> wall;  ///< Null: the clay is soft.
  force::DecoratingTool decorating;
  force::LeatherTurn turned;
};

/// A vessel that is `belly` wide (radius, metres) half-way up, 0.2 m high.
Profile jar(double belly, double mouth = 0.04, double foot = 0.04);

/// A whole exhibit without window, loop or files, and someone who visits it.
class Visitor {
 public:
  /// `kiln`: with the exhibit's glazes, and stoneware's shrinkage. `keeps_clay`: as Wheel's.
  explicit Visitor(int vessels = 9, const view::TextMeasure* measure = nullptr, bool kiln = false,
                   bool keeps_clay = false);

  void frames(double seconds);  ///< Time passes, thirty frames a second.
  void show() { frames(1.0 / 30); }
  void down(float x, float y);
  void move(float x, float y);
  void up(float x, float y);
  /// The tools of the exhibit's first scene lie to hand, at every vessel that is there.
  void put_tools_to_hand();
  /// So many pots were kept today, of the shelf's vessels one after the other.
  void keep_today(int pots);
  /// A mission that is on, the next of those that stand before the shelf; a description has a
  /// jar of its own, else it is the vessel `card` of the shelf.
  void put_on(const settings::Mission& mission, int card = 0);
  /// "A jar that holds a litre", or another.
  static settings::Mission described(double litres);
  /// Down and up in the middle of a control, in the drawer too. As visitors do: before "Done" a
  /// hand is on the clay, and after a page was closed they wait until it is gone.
  void touch(const std::string& control);
  void touch_clay();  ///< A hand meets the clay, and leaves it.
  /// By the globe.
  void speak(const std::string& code);
  /// At the wheel: opens or closes the drawer where `control` is only seen so.
  void reach(const std::string& control);
  void key(view::Key key);
  /// Arrows until `control` is focused, then Enter: false when no arrow leads there.
  bool key_to(const std::string& control);
  void press_clay();   ///< In attract: a finger goes down on the pot's wall.
  void begin();        ///< From attract to the shelf, by touch.
  void throw_a_pot();  ///< From attract to the throw screen, by touch.
  void make_result();
  /// A ring of the lump tears, whose wall is 33 mm, in a scene where walls tear below `limit` (0:
  /// only where they are opened too far).
  void tear(double limit);
  void mend();
  void glaze_and_fire();  ///< From the result to the fired pot, by touch.
  /// Pots are decorated in this way of the exhibit's from now on; "": not at all, as it comes.
  void offer(const std::string& way_id);
  std::vector<Request> requests();

  std::vector<content::Language> languages;
  settings::Exhibit exhibit;
  std::vector<content::Vessel> vessels;
  std::vector<ShelfCard> shelf;
  std::vector<content::Glaze> glazes;
  std::unique_ptr<decoration::Way> way;  // none as it comes
  std::vector<content::LessonStep> build_lesson;
  std::vector<content::LessonStep> lesson;  // likewise
  std::vector<TodaysPot> todays;            // likewise
  std::deque<settings::Mission> on;         // likewise
  std::vector<MissionCard> missions;        // of them
  content::Vessel jar_of_mission;
  SceneForVisitor wheel;  // of every card
  PlainMeasure plain;
  std::unique_ptr<CountingMeasure> counting;
  std::size_t most_measured = 0;  ///< Bytes of words, in any frame so far.
  RecordedCommands wheel_commands;
  DeviceNews news;
  loop::WheelView view;
  ClayView& clay = view.clay;
  loop::LoopStatus& status = view.status;
  std::unique_ptr<Visit> visit;
  view::Frame frame;
  int width = 1280, height = 720;
  double now = 100;

 private:
  std::vector<Request> seen_;
};

/// Goes through everything a visitor can see, as it stands once cross-fades are over: every screen,
/// the label, help, the warning, the fault, a kept and a failed postcard. `look` gets its name.
void walk(Visitor& visitor, const std::function<void(const std::string&)>& look);

/// On the screen where a pot is decorated: takes each tool, and touches the pot with the first
/// `marks` of them.
void walk_decorating(Visitor& visitor, const std::function<void(const std::string&)>& look,
                     std::size_t marks);

/// All words of a frame, one after the other.
std::string words_in(const view::Frame& frame);

}  // namespace onggi::screens
