#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/effects/prints.h"
#include "engine/surface/laws.h"
#include "kiosk/collection/decoration/coat_picture.h"
#include "kiosk/collection/decoration/way.h"
#include "kiosk/visit/decorating/firing.h"
#include "kiosk/visit/decorating/hand_work.h"
#include "kiosk/visit/decorating/layers.h"
#include "kiosk/visit/decorating/touched_part.h"
#include "kiosk/visit/decorating/touched_place.h"
#include "kiosk/visit/decorating/wet_slip.h"
#include "kiosk/visit/decorating/zones.h"

namespace onggi::decorating {

/// A visitor's pot while it is decorated: its surface, the tool in the hand, and the pictures for
/// the graphics side. Knows no screen, clock or file. Main thread. Allocates.
class DecoratedPot {
 public:
  /// Problem: `thrown` is no outline (surface::outline_of). `way` has a tool, and outlives it.
  static Result<std::unique_ptr<DecoratedPot>> begin(const Profile& thrown,
                                                     const decoration::Way& way);
  /// The same with what paddle and anvil left on it (beaten_wall.h), drawn at once.
  static Result<std::unique_ptr<DecoratedPot>> begin(const Profile& thrown,
                                                     const decoration::Way& way,
                                                     std::span<const Print> prints,
                                                     const PrintsDef& faces);

  const decoration::Way& way() const { return way_; }
  const surface::Surface& surface() const { return surface_; }
  const decoration::CoatPicture& picture() const { return picture_; }
  /// Length of the outline from the foot to the lip, m.
  double outside() const;
  const Zones& zones() const { return zones_; }
  /// Where a share of the outside's outline lies, from the foot, or of the inside's, from the
  /// middle of the floor: m along the whole outline.
  double along_of(double share, bool inside) const;
  /// True if something was done between two places along the outline, but for what covers all of
  /// the pot or all from a height on.
  bool touched(double from, double to) const;
  /// How far the clay has come by what was done to it: soft clay becomes leather-hard, dries, is
  /// fired once, is glazed. An example brings it no further.
  decoration::WayTool::State state() const;

  /// How slip that was just laid glistens: WetSlip::by_height().
  const std::vector<float>& wetness() const { return wet_.by_height(); }

  // What the visitor has chosen.
  int tool() const { return tool_; }
  const decoration::WayTool& held() const { return tool_at(tool_); }
  /// Ends the stroke of a finger that is on the pot.
  void choose_tool(int tool);
  /// True if this tool needs another one first.
  bool waits(int tool) const;
  /// In WayTool::pigments and WayTool::motifs of the held tool.
  int pigment() const { return choice().pigment; }
  int figure() const { return choice().figure; }
  /// The tool's own number, until the visitor chooses one: that is for all tools.
  int repeats() const { return repeats_.value_or(held().repeats); }
  void choose_pigment(int index) { choice().pigment = index; }
  void choose_figure(int index) { choice().figure = index; }
  void choose_repeats(int repeats) { repeats_ = repeats; }

  // The hand. Nothing happens while busy(), nor where the same coat was just laid. What changes
  // nothing is no step.
  /// A finger comes down, moves, and leaves.
  void press(const Place& at);
  void move(const Place& at);
  void lift();
  /// The finger was not meant: takes back what it did since press().
  void cancel();
  bool pressed() const { return last_.has_value(); }
  /// The pot turns under the finger: a ring is being drawn.
  bool turns() const;
  /// Does the held tool's work without a finger: all over, once round at `at`, from there up, a
  /// figure there, or a short stroke.
  void put(const Place& at);
  /// True while work that was begun goes on by itself.
  bool busy() const { return !waiting_.empty(); }
  /// Once a frame: goes on with such work, ten times faster in a `hurry`, and draws what has
  /// changed into the picture.
  void update(double dt, bool hurry = false);
  /// Does the rest of such work now.
  void end_work();
  /// Of the tool over the clay since the last update, m/s; 0: it touches nothing.
  double tool_speed() const { return speed_; }
  /// Takes the finger off, ends such work, and draws everything.
  void finish();

  /// What the hand does from now on is an example: bare(), did(), waits() and can_undo() know
  /// nothing of it, and end_example() leaves the pot as it was, to the bit and to the last step of
  /// the undo. Copies the surface. A finger that is on the pot is lifted, and its work done.
  void begin_example();
  void end_example();
  bool shows_example() const { return saved_.has_value(); }

  bool bare() const { return own_steps().empty(); }
  /// Paddle or anvil have left something on it.
  bool printed() const { return printed_; }
  /// Nothing of what it is covered with can be seen: it is a plain pot.
  bool plain() const { return bare() && !printed_; }
  /// The visitor laid glaze on it, which melts in the kiln.
  bool glazed() const { return for_the_fire().glazed; }
  bool can_undo() const { return !shows_example() && !busy() && surface_.can_undo(); }
  /// Takes the last touch back; a finger that is still on the pot draws no more.
  void undo();

  /// In the kiln: the glaze begins to melt, a part each update().
  void heat();
  /// Before or after the fire: the slips change their colours, a part a frame, and the glaze is
  /// what it has melted to. `glassy`: the kiln gives a glaze to a pot on which none was laid.
  void fire(bool fired, bool glassy = true);

  /// True once the last update() left nothing to do: no work, no melt, no part of the picture.
  bool settled() const;

  /// What was laid on it at a place, and what the fire has made of it. Allocates.
  Layers layers_at(const Place& at) const;

  /// From now on it notes each touch for work(), some kB each. Call it on a bare pot.
  void keep_work() { keeps_work_ = true; }
  bool keeps_work() const { return keeps_work_; }
  /// What was done since, a touch each, without what was taken back and what an example did.
  std::vector<HandWork> work() const;

  /// What was done, a tool each in the order of its first use.
  struct Did {
    int tool = 0, times = 0;
  };
  std::vector<Did> did() const;

 private:
  struct Choice {
    int pigment = 0, figure = 0;
  };
  struct Step {
    int tool = 0, pigment = 0;
    double from = 0.0;        ///< Of what covers all from a height on: that height, m.
    std::vector<Part> parts;  ///< The cells that it changed.
    HandWork work = {};       ///< Where keeps_work().
  };
  /// A pot before an example.
  struct Saved {
    surface::Surface surface;
    std::vector<Step> steps;
    double laid = 0.0, under = 0.0;
  };
  DecoratedPot(surface::Surface surface, const decoration::Way& way);
  const decoration::WayTool& tool_at(int tool) const {
    return way_.tools[static_cast<std::size_t>(tool)];
  }
  Choice& choice() { return choices_[static_cast<std::size_t>(tool_)]; }
  const Choice& choice() const { return choices_[static_cast<std::size_t>(tool_)]; }
  /// The held tool's law, with the chosen pigment.
  surface::Tool law() const;
  void apply(surface::Stroke stroke, int repeats);
  /// Forgets the last step if it changed nothing.
  void end_step();
  /// True if the held tool laid this coat at `along` just before.
  bool just_coated(double along) const;
  void note(const surface::Stroke& stroke, int repeats);
  void touch(const std::vector<Part>& parts);
  void tell_age(surface::Stroke& stroke);
  void take_back();
  const std::vector<Step>& own_steps() const { return saved_ ? saved_->steps : steps_; }
  const surface::Row& row_at(double along) const;
  void trace();
  void wait_for(std::vector<surface::Stroke> strokes);
  void set_figure(const Place& at);
  double way_of_load() const;
  /// Where a ring is drawn for a finger at `along`: in one zone, and level while the finger wavers.
  double ring_at(double along) const;
  void close_ring();
  void cover_all();
  Firing::Pot for_the_fire() const;
  void show_fire();
  void from_up(const Place& at);
  double end_of_outline() const;

  const decoration::Way& way_;
  surface::Surface surface_;
  decoration::CoatPicture picture_;
  Zones zones_;
  std::vector<Choice> choices_;
  std::optional<int> repeats_;  ///< That the visitor chose.
  int tool_ = 0;
  int working_ = 0;  ///< The tool of the last press.
  bool step_begun_ = false;
  bool keeps_work_ = false;
  bool changed_ = false;     ///< Something, by the step that was begun.
  std::vector<Step> steps_;  ///< As many as the surface can take back, and those before.
  std::deque<surface::Stroke> waiting_;  ///< Each for its frame,
  double due_ = 0.0;                     ///< and how many of them are due.
  std::optional<surface::Tracer> tracer_;
  std::size_t traced_ = 0;  ///< Stations of tracer_ that have been applied.
  std::optional<surface::HandPlace> last_;
  surface::HandPlace began_at_;
  std::optional<surface::HandPlace> traced_to_;
  double gone_ = 0.0, speed_ = 0.0;    ///< Of the tool since the last update, m; before it, m/s.
  double clock_ = 0.0;                 ///< Of update(), s.
  double laid_ = -1e4, under_ = -1e4;  ///< When slip was laid last, and before this step.
  WetSlip wet_;
  bool printed_ = false;
  bool open_ = false;  ///< Wider than high: visitors look into it.
  Firing firing_;
  bool drawn_ = false;          ///< All of the picture, by the last update.
  std::optional<Saved> saved_;  ///< While an example is shown.
};

}  // namespace onggi::decorating
