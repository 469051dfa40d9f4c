#include "kiosk/exhibit/composition/pot_on_wheel.h"

#include <chrono>
#include <utility>

#include "engine/scene/lump.h"
#include "kiosk/exhibit/composition/vessel_model.h"
#include "kiosk/ground/files/log.h"

namespace onggi::exhibit {

PotOnWheel::PotOnWheel(const Scenes& scenes, loop::WheelHost& wheel_host,
                       render::Renderer& renderer, std::uint64_t seed, bool at_once)
    : scenes_(scenes),
      wheel_host_(wheel_host),
      renderer_(renderer),
      at_once_(at_once),
      seed_(seed) {}

PotOnWheel::Made PotOnWheel::make(Order order) {
  Made made{order.def, {}, {}};
  auto scene = Scene::create(order.def);
  if (scene)
    made.scene = std::make_unique<Scene>(std::move(*scene));
  else
    made.scene = tl::unexpected(scene.error());
  if (!order.script.empty())
    made.script = make_script(order.script, {order.def, &order.target, order.seed});
  return made;
}

void PotOnWheel::begin(Order order) {
  making_ =
      std::async(at_once_ ? std::launch::deferred : std::launch::async, make, std::move(order));
}

void PotOnWheel::start(const screens::StartPot& wish, const screens::ShelfCard& card) {
  Order order;
  const SceneDef* built = wish.built ? scenes_.built(*card.vessel) : nullptr;
  order.def = built != nullptr ? *built : scenes_.of(card.vessel->id);
  take_paddle(order.def, *card.vessel);
  order.def.clay = lump_for(card.target, order.def);
  order.target = card.target;
  if (wish.scripted) order.script = wish.script;
  order.seed = seed_ + ++pots_;
  wish_ = wish;
  if (making_.valid())
    waiting_ = std::move(order);
  else
    begin(std::move(order));
}

bool PotOnWheel::made() {
  if (!making_.valid()) return false;
  const auto ready = [this] {
    return at_once_ || making_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  };
  if (!ready()) return false;
  if (!waiting_) return true;
  making_.get();
  begin(*std::exchange(waiting_, std::nullopt));
  return ready();
}

Result<void> PotOnWheel::put(const screens::ShelfCard& card) {
  Made made = making_.get();
  if (!made.scene) return tl::unexpected(made.scene.error());
  def_ = std::move(made.def);
  card_ = wish_.card;
  wheel_host_.start(std::move(*made.scene));
  renderer_.show_clay(wheel_host_.view().clay);
  if (!wish_.scripted) {
    wheel_host_.record(card.vessel->id, seed_);
    show_vessel(renderer_, card);
    return {};
  }
  wheel_host_.show();
  if (!made.script)
    files::log_problem(made.script.error());
  else if (*made.script)
    wheel_host_.play(std::move(*made.script));
  return {};
}

void PotOnWheel::log_faults() {
  for (const std::string& line : faults_.news(wheel_host_.view().status)) files::log_line(line);
}

}  // namespace onggi::exhibit
