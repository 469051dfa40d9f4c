#include "kiosk/exhibit/composition/pot_on_wheel.h"

#include <memory>
#include <utility>

#include "engine/scene/lump.h"
#include "engine/script/script.h"
#include "kiosk/exhibit/composition/vessel_model.h"
#include "kiosk/ground/files/log.h"

namespace onggi::exhibit {

PotOnWheel::PotOnWheel(const Scenes& scenes, loop::WheelHost& wheel_host,
                       render::Renderer& renderer, std::uint64_t seed)
    : scenes_(scenes), wheel_host_(wheel_host), renderer_(renderer), seed_(seed) {}

Result<void> PotOnWheel::start(const screens::StartPot& wish, const screens::ShelfCard& card) {
  SceneDef def = scenes_.of(card.vessel->id);
  def.clay = lump_for(card.target, def);
  auto scene = Scene::create(def);
  if (!scene) return tl::unexpected(scene.error());
  def_ = def;
  card_ = wish.card;
  wheel_host_.start(std::make_unique<Scene>(std::move(*scene)));
  renderer_.show_clay(wheel_host_.view().clay);
  ++pots_;
  if (!wish.scripted) {
    wheel_host_.record(card.vessel->id, seed_);
    show_vessel(renderer_, card);
    return {};
  }
  wheel_host_.show();
  if (wish.script.empty()) return {};
  auto script = make_script(wish.script, {def, &card.target, seed_ + pots_});
  if (script)
    wheel_host_.play(std::move(*script));
  else
    files::log_problem(script.error());
  return {};
}

void PotOnWheel::log_faults() {
  for (const std::string& line : faults_.news(wheel_host_.view().status)) files::log_line(line);
}

}  // namespace onggi::exhibit
