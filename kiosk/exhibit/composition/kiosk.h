#pragma once

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/collection/content/language.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/composition/access_input.h"
#include "kiosk/exhibit/composition/hand_devices.h"
#include "kiosk/exhibit/composition/keeping.h"
#include "kiosk/exhibit/composition/missions.h"
#include "kiosk/exhibit/composition/night.h"
#include "kiosk/exhibit/composition/pot_on_wheel.h"
#include "kiosk/exhibit/composition/scenes.h"
#include "kiosk/exhibit/composition/shelf.h"
#include "kiosk/exhibit/composition/staff_corner.h"
#include "kiosk/exhibit/composition/studio_sound.h"
#include "kiosk/exhibit/composition/todays_pots.h"
#include "kiosk/exhibit/composition/visit_counter.h"
#include "kiosk/exhibit/tuning/tuner.h"
#include "kiosk/ground/files/wall_clock.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/screens/visit.h"
#include "kiosk/wheel/device/hidapi_bus.h"
#include "kiosk/wheel/loop/stepped_wheel.h"
#include "kiosk/wheel/loop/wheel_host.h"

namespace onggi::exhibit {

/// How a kiosk is opened. Everything but `config` has a default.
struct KioskOptions {
  std::filesystem::path config;                    ///< exhibit.toml
  std::optional<std::filesystem::path> shelf;      ///< Instead of the exhibit's.
  std::optional<std::filesystem::path> keepsakes;  ///< Instead of the exhibit's folder.
  render::WindowOptions window;
  bool devices = true;  ///< Use the hand devices that are plugged in.
  /// Where hand devices come from; tests bring their own.
  std::function<std::unique_ptr<device::HidBus>()> bus = device::hidapi_bus;
  /// Where the window comes from; tests watch one.
  std::function<Result<std::unique_ptr<render::Renderer>>(const render::WindowOptions&)> renderer =
      render::Renderer::create;
  tuning::TunePlan tune{};  ///< How a grid is looked for where a scene asks; tests look briefly.
  bool stepped = false;     ///< Turn the wheel by hand (advance()), not by the 1 kHz thread.
  std::uint64_t seed = 1;
  /// The clock on the wall, for opening hours; a stepped kiosk is always open.
  std::function<std::time_t()> wall = [] { return files::wall_now(); };
  std::string language;                  ///< Instead of the exhibit's first; empty keeps it.
  std::vector<std::string> languages{};  ///< Instead of the exhibit's; empty keeps them.
  std::optional<double> scan_seconds{};  ///< Instead of the exhibit's, s.
  std::string
      mission{};  ///< One that is on, whatever its file says, or Missions::kEvery; empty: none.
};

/// The kiosk's present state. Its references and pointers stay valid as long as the kiosk.
struct Doing {
  bool open_to_visitors;  ///< A vessel of the shelf is read, and attract has begun.
  bool nobody_is_here;    ///< True in attract with no save pending: safe to close or reload.
  bool dark;              ///< Outside of the museum's hours, and nobody is here.
  bool saving;            ///< A keepsake is being drawn or saved.
  bool turning;  ///< A turntable GIF is being drawn or saved. Optional: callers need not wait.
  const SavedCount& saved;
  std::optional<souvenir::Room> room;  ///< For phones' pages, if they have some.
  const std::filesystem::path& keepsake_folder;
  const KeptVisit* kept;  ///< The last kept visit; null: none.
  const SceneDef& pot;    ///< The scene of the pot on the wheel.
  int card;  ///< Card of that pot: of the shelf, or a mission's own; -1 before the first pot.
  std::optional<WayIn> way_in;                ///< Into the staff's page, that the screen showed.
  std::optional<std::uint64_t> device_moves;  ///< HandDevices::moves(); none: no devices are used.
};

/// Connects all parts: settings and content to screens, screens' wishes to the wheel, rows to the
/// picture, pictures to the keepsake. Main thread.
class Kiosk {
 public:
  /// Opens settings, window and wheel, and begins to read the shelf. Problems that leave an exhibit
  /// to show are logged; others are returned.
  static Result<std::unique_ptr<Kiosk>> open(const KioskOptions& options);
  /// Ends the current visit and blocks until keepsakes and counts are saved; failures are logged.
  ~Kiosk();

  /// One frame: input, wheel, screens, picture. `now` in seconds on a clock that never goes back.
  /// False once the window is to close.
  /// `draw` false makes the frame without drawing it: for visits faster than real time.
  bool frame(double now, bool draw = true);
  /// Draws the last frame made and reads it back.
  view::Image picture();
  /// The last frame made.
  const view::Frame& shown() const { return last_frame_; }
  /// For contact sheets: redraws the current screen with other screen settings and language.
  void show_as(const settings::Exhibit::Screen& screen, const std::string& language);
  /// Stepped kiosks only: turns the wheel by `ticks` of 1 ms before the next frame.
  void advance(int ticks);

  screens::Visit& visit() { return *visit_; }
  /// Handles input and speech for blind and one-switch visitors.
  AccessInput& access_input() { return *access_input_; }
  loop::WheelHost& wheel_host() { return *wheel_host_; }
  render::Renderer& renderer() { return *renderer_; }
  Shelf& shelf() { return *shelf_; }
  const settings::Exhibit& exhibit() const { return exhibit_; }
  const Missions& missions() const { return *missions_; }
  /// Null if the exhibit has none.
  const screens::ShelfCard* card(int index) const {
    return missions_->card(index, shelf_->cards());
  }
  const std::vector<content::Glaze>& glazes() const { return scenes_->glazes(); }
  /// Names of the hand devices that are plugged in.
  std::vector<std::string> plugged_in() const {
    return devices_ ? devices_->plugged_in() : std::vector<std::string>();
  }
  /// For reports, scripted visitors and the service.
  Doing doing() const;

 private:
  Kiosk() = default;
  Result<void> read_settings(const KioskOptions& options);
  /// Ends the current visit and blocks until keepsakes and counts are saved. Runs once.
  void close_visit();
  bool nobody_is_here() const;
  bool dark() const { return night_ && night_->dark(); }
  bool look_at_shelf(double now);
  void log_unknown_names();
  Capabilities able();
  void begin_visit(double now);
  void carry_out(const screens::StartPot& request);
  /// Puts the pot that was asked for on the wheel, once it is made.
  void put_pot();
  void carry_out(const screens::MakeKeepsake& request);
  void carry_out(const screens::VisitEnded& request);
  std::vector<view::InputEvent> look_after_devices(double now);
  /// What the staff's corner leaves of them.
  std::vector<view::InputEvent> passed_on(const std::vector<view::InputEvent>& events, double now);
  view::Frame opening_frame() const;
  bool update_night(double now, const std::vector<view::InputEvent>& events);
  void be_dark(bool draw);

  settings::Exhibit exhibit_;
  std::unique_ptr<Scenes> scenes_;
  std::vector<content::Language> languages_;
  content::KeepsakeNames names_;
  std::vector<content::LessonStep> lesson_;
  std::vector<content::LessonStep> build_lesson_;
  std::unique_ptr<render::Renderer> renderer_;
  std::unique_ptr<loop::WheelHost> wheel_host_;
  loop::SteppedWheel* stepped_ = nullptr;  ///< wheel_host_, where it is turned by hand.
  std::unique_ptr<StudioSound> sound_;    ///< Null if the exhibit has no sound. Reads wheel_host_'s
                                          ///< status.
  std::unique_ptr<HandDevices> devices_;  ///< Null if devices are not used.
  std::unique_ptr<Shelf> shelf_;
  std::unique_ptr<Missions> missions_;
  std::unique_ptr<TodaysPots> todays_;     ///< Null if the gallery is switched off.
  std::unique_ptr<VisitCounter> counter_;  ///< Null if visits are not counted.
  std::unique_ptr<PotOnWheel> pot_;
  std::unique_ptr<Keeping> keeping_;
  std::unique_ptr<screens::Visit> visit_;
  std::unique_ptr<AccessInput> access_input_;
  std::unique_ptr<StaffCorner> staff_corner_;
  std::optional<Night> night_;  ///< Empty if the exhibit is always open.
  std::function<std::time_t()> wall_;
  bool hands_taken_ = false, two_fingers_ = false, nobody_was_here_ = false;
  double fingers_asked_ = -1e9;  ///< Time of the last question how many fingers the glass tells
                                 ///< apart, s.
  double now_ = 0.0;             ///< Time of the last frame, s.
  std::optional<view::InputEvent>
      early_touch_;  ///< The first touch, made while the shelf was loading.
  view::Frame last_frame_;
};

}  // namespace onggi::exhibit
