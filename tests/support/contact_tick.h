#pragma once

#include "engine/contact/paper_model.h"
#include "engine/contact/tool_contact.h"
#include "tests/support/tick_scripts.h"

namespace onggi {

/// The contact stage of a tick alone, corrected and as printed, on the first hand of a script: all
/// that finds the window, the side and the press, and nothing else of Scene::step. Both begin with
/// the same surface at the same place.

class CorrectedContact {
 public:
  CorrectedContact(const TickScript& script, int rows, int sectors);
  void tick(int n) noexcept;  ///< Tick `n` of a pass. No allocation.
  /// The press of tick `n` alone, with the side known.
  void press_alone(int n) noexcept;
  const Press& press() const { return pressed_; }
  Clay& clay() { return clay_; }
  /// Fresh clay where any was pressed, and the hand lifted: tick 0 may follow.
  void freshen();

 private:
  const TickScript& script_;
  Clay clay_;
  ToolContact contact_;
  Press pressed_;
  Yielding yielding_;
  double radius_;
};

class PrintedContact {
 public:
  PrintedContact(const TickScript& script, int rows, int sectors);
  void tick(int n) noexcept;
  const PaperTouch& touch() const { return touch_; }
  void freshen();

 private:
  const TickScript& script_;
  Clay clay_;
  PaperModel model_;
  PaperCoefficients coefficients_;
  PaperTouch touch_;
  double radius_;
};

/// The script's scene on the printed model: its one surface lies where the script's tool works.
SceneDef printed_scene(const TickScript& script, int rows, int sectors);

/// Where the script's first hand is as tick `n` begins, or ends, in the clay's turning frame, m.
Vec3 place_before(const TickScript& script, int n);
Vec3 place_after(const TickScript& script, int n);

}  // namespace onggi
