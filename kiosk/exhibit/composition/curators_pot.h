#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/content/language.h"
#include "kiosk/collection/decoration/decoration.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/composition/scenes.h"
#include "kiosk/exhibit/composition/shelf.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/screens/visit.h"
#include "kiosk/wheel/loop/stepped_wheel.h"

namespace onggi::exhibit {

/// A vessel of the shelf on the screen Decorate, in a window of its own, for a curator. No wheel
/// turns, nothing is counted or kept. Main thread.
class CuratorsPot {
 public:
  /// `vessel`: its folder. Problem where the exhibit, the vessel or the window cannot be opened, or
  /// the exhibit has no way for it. Blocks while the vessel is read, a second at the most.
  static Result<std::unique_ptr<CuratorsPot>> open(const std::filesystem::path& config,
                                                   const std::filesystem::path& vessel,
                                                   const std::string& language,
                                                   const render::WindowOptions& window);

  /// One frame: input, screen, picture. `now` in seconds on a clock that never goes back. False
  /// once the curator has ended, or closed the window.
  bool frame(double now);
  screens::Visit& visit() { return *visit_; }
  render::Renderer& renderer() { return *renderer_; }
  /// The last frame made.
  const view::Frame& shown() const { return shown_; }

  /// What was drawn; no steps: nothing. The clay has the vessel's own colour, glaze that of its
  /// first glaze. Sources and simplifications are the caller's.
  decoration::Decoration decoration() const;

 private:
  CuratorsPot() = default;
  void show_outline(const Profile& pot);

  settings::Exhibit exhibit_;
  std::unique_ptr<Scenes> scenes_;
  std::vector<content::Language> languages_;
  std::unique_ptr<Shelf> shelf_;
  std::unique_ptr<render::Renderer> renderer_;
  loop::SteppedWheel wheel_;  ///< Takes the screens' commands, and never turns.
  loop::WheelView pot_;       ///< The vessel's outline as clay.
  std::unique_ptr<screens::Visit> visit_;
  view::Frame shown_;
};

}  // namespace onggi::exhibit
