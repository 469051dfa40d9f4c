#include "kiosk/exhibit/composition/studio_sound.h"

#include <array>

#include "kiosk/ground/files/log.h"
#include "kiosk/visit/screens/screen_kind.h"
#include "kiosk/visit/sound/ear.h"

namespace onggi::exhibit {

StudioSound::StudioSound(const loop::WheelHost& wheel_host, double volume)
    : volume_(volume), speaker_([&wheel_host] { return sound::hear(wheel_host.status()); }) {}

void StudioSound::frame(double now, const screens::Visit* visit, bool dark) {
  speaker_.look(now);
  if (const std::string line = speaker_.remark(); !line.empty()) files::log_line(line);
  const bool heard = visit != nullptr && !dark && visit->volume_share() > 0.0 &&
                     visit->screen() != screens::ScreenId::attract;
  speaker_.volume(heard ? volume_ * visit->volume_share() : 0.0);
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
