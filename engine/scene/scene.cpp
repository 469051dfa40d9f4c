#include "engine/scene/scene.h"

#include "engine/effects/built.h"
#include "engine/math/hash.h"
#include "engine/scene/scene_state.h"

namespace onggi {

Result<Scene> Scene::create(const SceneDef& def, Vectors vectors) {
  if (auto good = validate(def); !good) return tl::unexpected<Problem>(good.error());
  Result<Clay> clay = Clay::create(def.clay, vectors, scene::RowEffects::spare_rows(def));
  if (!clay) return tl::unexpected<Problem>(clay.error());
  return Scene(std::make_unique<State>(def, std::move(*clay)));
}

Scene::Scene(std::unique_ptr<State> state) : state_(std::move(state)) {}
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

// The numbered pipeline: engine/docs/pipeline.md.
Feedback Scene::step(const Hands& hands, double dt) noexcept {
  State& s = *state_;
  State::Tick tick;
  s.take_input(tick, hands, dt);                                                // 1
  s.turn_wheel(tick);                                                           // 2
  if constexpr (effects::kBuilt) s.soak_or_dry(tick, hands.water, hands.fire);  // 3
  s.work_on_lump(hands);                                                        // 4
  if (s.printed) {
    s.press_as_printed(tick);  // 5, 7
  } else {
    s.press_and_work(tick);  // 5, 6
    s.feel(tick);            // 7
  }
  s.keep_history(tick);
  return s.guard_and_report(tick);  // 8, 9
}

const SceneDef& Scene::def() const { return state_->def; }
const Clay& Scene::clay() const { return state_->clay; }
bool Scene::fallen() const { return state_->fallen(); }
bool Scene::torn(int row) const {
  return state_->clay.areas() != nullptr && state_->clay.areas()->torn(row);
}
double Scene::wetness_of(int row) const {
  return state_->moisture ? state_->moisture->of_row(state_->clay.stored(row)) : 0.0;
}
CoilView Scene::coil() const {
  const effects::Building* building = state_->building();
  if (building == nullptr) return {};
  const effects::LaidCoil& laid = building->laid();
  const BuildingDef& def = *state_->def.building;
  CoilView view{{}, def.coil, building->laid_height(def, state_->clay), laid.added()};
  if (laid.any()) view.centre = laid.centres();
  return view;
}
std::vector<Print> Scene::prints() const {
  return state_->row_effects ? state_->row_effects->prints(state_->clay) : std::vector<Print>();
}
bool Scene::laying() const { return !state_->lump.playing(); }
bool Scene::can_restore() const { return state_->history && state_->history->can_step_back(); }
int Scene::take_dirty_row(int from) noexcept { return state_->clay.take_dirty(from); }
int Scene::take_moved_row(int from) noexcept { return state_->clay.take_moved(from); }
void Scene::mark_all_dirty() noexcept { state_->clay.mark_all_dirty(); }
HandView Scene::hand(int n) const noexcept {
  const scene::HandState& h = state_->hand[static_cast<std::size_t>(n)];
  return scene::seen(h, state_->tools[h.tool],
                     state_->def.beating ? &*state_->def.beating : nullptr);
}
void Scene::clear_faults(std::uint32_t which) noexcept { state_->faults &= ~which; }
const SceneCounters& Scene::counters() const { return state_->counters; }
double Scene::time() const { return state_->time; }

std::uint64_t Scene::state_hash() const {
  const State& s = *state_;
  StateHash hash;
  for (double v :
       {s.time, s.wheel_angle, s.wheel_speed, s.wheel_asked, s.moisture ? s.moisture->mean() : 0.0})
    hash.add(v);
  for (const scene::HandState& h : s.hand) h.add_to(hash, s.tools);
  if (s.def.friction)
    for (const scene::HandState& h : s.hand) h.velocity.add_to(hash);
  s.slit.add_to(hash);
  if (s.slit.free()) hash.add(s.clay_angle);
  hash.add(s.lump.bits() | std::uint64_t{s.faulted} << 8);
  if (s.printed)
    for (const PaperFilter& filter : s.printed->filter)
      for (double v : filter.memory()) hash.add(v);
  if (s.moisture) s.moisture->add_to(hash, s.clay);
  if (s.row_effects) {
    s.row_effects->add_to(hash, state_->clay);
    hash.add(s.lump.stood_at());
  }
  hash.add(s.clay.hash());
  if (s.history) s.history->add_to(hash);
  return hash.value();
}

}  // namespace onggi
