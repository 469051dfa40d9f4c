#include "kiosk/exhibit/composition/studio_sound.h"

#include <array>
#include <variant>

#include "kiosk/ground/files/log.h"
#include "kiosk/visit/screens/screen_kind.h"
#include "kiosk/visit/sound/ear.h"

namespace onggi::exhibit {

namespace {

/// How a tool sounds on leather-hard clay: a needle scratches, a blade rings, the others rub.
struct OnDryClay {
  sound::Rub operator()(const surface::CutDef&) const { return {sound::Rub::Kind::wire, 0, 1.5}; }
  sound::Rub operator()(const surface::ScrapeDef&) const { return {sound::Rub::Kind::rib, 0, 2.0}; }
  sound::Rub operator()(const surface::WipeDef&) const { return {sound::Rub::Kind::hand, 0, 1.0}; }
  sound::Rub operator()(const surface::BurnishDef&) const {
    return {sound::Rub::Kind::rib, 0, 1.0};
  }
  sound::Rub operator()(const auto&) const { return {sound::Rub::Kind::sponge, 0, 0.6}; }
};

sound::Rub rub_of(const decorating::DecoratedPot* pot) {
  if (pot == nullptr || pot->tool_speed() <= 0.0) return {};
  sound::Rub rub = std::visit(OnDryClay{}, pot->held().law);
  rub.slip = pot->tool_speed();
  return rub;
}

}  // namespace

StudioSound::StudioSound(const loop::WheelHost& wheel_host, double volume)
    : volume_(volume), speaker_([&wheel_host] { return sound::hear(wheel_host.status()); }) {}

void StudioSound::frame(double now, const screens::Visit* visit, bool dark) {
  speaker_.look(now);
  if (const std::string line = speaker_.remark(); !line.empty()) files::log_line(line);
  const bool heard = visit != nullptr && !dark && visit->volume_share() > 0.0 &&
                     visit->screen() != screens::ScreenId::attract;
  speaker_.volume(heard ? volume_ * visit->volume_share() : 0.0);
  const bool decorates = heard && visit->screen() == screens::ScreenId::decorate;
  speaker_.rub(rub_of(decorates ? visit->decorated_pot() : nullptr));
  speaker_.fire(heard && screens::kind_of(visit->screen()).fires ? 1.0 : 0.0);
}

void StudioSound::sing(const screens::WheelSnapshot& sight) {
  std::array<double, sound::OutlineSong::kSteps> vessel{}, pot{};
  for (std::size_t n = 0; n < vessel.size(); ++n) {
    const double share = (static_cast<double>(n) + 0.5) / static_cast<double>(vessel.size());
    vessel[n] = sight.target->outer_at(share * sight.target->height());
    pot[n] = sight.made->outer_at(share * sight.made->height());
  }
  speaker_.sing(sound::outline_song(vessel, pot));
}

}  // namespace onggi::exhibit
