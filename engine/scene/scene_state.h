#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "engine/clay/history.h"
#include "engine/contact/paper_model.h"
#include "engine/effects/built.h"
#include "engine/scene/hand_state.h"
#include "engine/scene/lump_work.h"
#include "engine/scene/row_effects.h"
#include "engine/scene/scene.h"

namespace onggi {

namespace scene {

/// State of the paper's scene.
struct Printed {
  PaperModel model;
  PaperCoefficients coefficients;
  std::array<PaperFilter, kMaxHands> filter{};
};

}  // namespace scene

/// The parts of a Scene, and the stages of its tick.
struct Scene::State {
  SceneDef def;
  std::vector<scene::Tool> tools;
  Clay clay;
  std::optional<clay::History> history;
  WireCut slit;
  std::array<scene::HandState, kMaxHands> hand{};
  std::optional<scene::Printed> printed;
  double time = 0.0;
  double wheel_angle = 0.0;
  double clay_angle = 0.0;
  double wheel_speed = 0.0;
  double wheel_asked = 0.0;
  std::optional<effects::Moisture> moisture;
  std::unique_ptr<scene::RowEffects> row_effects;  // null if the scene has none
  scene::LumpWork lump;
  std::uint32_t faults = 0;   // faults since they were last cleared,
  std::uint32_t faulted = 0;  // and since create(); a replay compares these
  SceneCounters counters;

  // Values that the stages of one tick pass on.
  struct Tick {
    double dt = 0.0;
    double angle_from = 0.0;
    double turn = 0.0;
    std::array<ToolSweep, kMaxHands> sweep{};
    std::array<bool, kMaxHands> held{};
    std::array<Vec3, kMaxHands> wanted{};
    std::array<Press, kMaxHands> press{};
    std::array<force::Touch, kMaxHands> touch{};
    std::array<WallSide, kMaxHands> side{};
    std::array<Place, kMaxHands> place{};
    std::array<double, kMaxHands> along{};
  };

  State(const SceneDef& d, Clay&& c)
      : def(d), tools(scene::tools_of(d)), clay(std::move(c)), slit(d.clay.sectors) {
    row_effects = scene::RowEffects::make(def, clay);
    if (def.moisture) moisture.emplace(*def.moisture, def.clay.rows, clay.room());
    if (def.clay.keep_undo) history.emplace(clay);
    if (!def.paper) return;
    const PaperDef& paper = *def.paper;
    printed = scene::Printed{PaperModel(clay), {paper.c_eta, paper.c_v, paper.c_r}};
  }

  void take_input(Tick& tick, const Hands& hands, double dt) noexcept;
  void take_hand(Tick& tick, std::size_t n, const HandInput& in) noexcept;
  void turn_wheel(Tick& tick) noexcept;
  void soak_or_dry(const Tick& tick, bool water, bool fire) noexcept;
  void work_on_lump(const Hands& hands) noexcept;
  scene::LumpWork::Parts lump_parts() {
    return {def, clay, history ? &*history : nullptr, row_effects.get(),
            moisture ? &*moisture : nullptr};
  }
  double wetness_at(double height) const;
  Yielding yielding_at(double height) const;
  void keep_history(const Tick& tick) noexcept;
  bool presses(const scene::HandState& h) const {
    return h.present && !h.coil && !h.paddle && !tools[h.tool].shape->severs();
  }
  const effects::Building* building() const {
    return effects::kBuilt && row_effects ? row_effects->building() : nullptr;
  }
  std::uint64_t steps_taken() const { return history ? history->depth() : 0; }
  bool fallen() const { return row_effects && row_effects->fallen(); }
  void draw_wire(Tick& tick, std::size_t n) noexcept;
  void lay_coil(const Tick& tick, std::size_t n) noexcept;
  void press_clay(Tick& tick) noexcept;
  void press_and_work(Tick& tick) noexcept;
  void work_on_rows(const Tick& tick) noexcept;
  effects::Blow blow_of(const Tick& tick, std::size_t n) const noexcept;
  void take_struck(const Tick& tick) noexcept;
  using Faces =
      std::array<contact::FacePush, kMaxHands>;  // each hand's press on a face of the wall
  void balance(const Tick& tick, Faces& face) const noexcept;
  void bend_walls(const Tick& tick, Faces& face) const noexcept;
  void feel(Tick& tick) noexcept;
  void feel_stop(Tick& tick, std::size_t n, double depth, double radius, Vec3 out) noexcept;
  void feel_coil(Tick& tick, std::size_t n) noexcept;
  void feel_wall(Tick& tick, std::size_t n) noexcept;
  void press_as_printed(Tick& tick) noexcept;
  Feedback guard_and_report(const Tick& tick) noexcept;
};

}  // namespace onggi
