#include "kiosk/exhibit/composition/access_input.h"

#include <cmath>
#include <filesystem>

#include "kiosk/ground/files/log.h"

namespace onggi::exhibit {

namespace fs = std::filesystem;

AccessInput::AccessInput(const settings::Exhibit& exhibit, bool voice)
    : access_mode_(exhibit.access.hold_to_speak), diagonal_mm_(exhibit.screen.diagonal_mm) {
  std::error_code ignored;
  if (voice)
    voice_.emplace(
        (fs::read_symlink("/proc/self/exe", ignored).parent_path() / "onggi-speech").string());
}

void AccessInput::input(const view::InputEvent& event, screens::Visit& visit, int width, int height,
                        double now) {
  access_mode_.input(event, visit, std::hypot(width, height) / diagonal_mm_, now);
}

void AccessInput::frame(screens::Visit& visit, view::Frame& frame, double now) {
  access_mode_.look(visit, frame, now);
  const auto said = access_mode_.take();
  if (said && heard_) heard_(*said);
  if (!voice_) return;
  if (visit.spoken() && visit.screen() != screens::ScreenId::attract) voice_->begin(now);
  if (said) voice_->say(*said, now);
  voice_->look(now);
  for (const std::uint64_t id : voice_->ended()) access_mode_.ended(id);
  for (const std::string& line : voice_->remarks()) files::log_line(line);
}

}  // namespace onggi::exhibit
