#include "kiosk/exhibit/composition/kiosk.h"

#include <chrono>
#include <thread>
#include <utility>

#include "kiosk/collection/content/translation_tables.h"
#include "kiosk/exhibit/composition/device_files.h"
#include "kiosk/exhibit/composition/words.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/log.h"
#include "kiosk/ground/files/memory.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/picture/render/display_loss.h"
#include "kiosk/wheel/loop/loop_thread.h"
#include "kiosk/wheel/loop/stepped_wheel.h"

namespace fs = std::filesystem;

namespace onggi::exhibit {

namespace {

constexpr double kAskFingers = 5.0;  // s between two questions how many fingers the glass tells
                                     // apart

}  // namespace

Result<std::unique_ptr<Kiosk>> Kiosk::open(const KioskOptions& options) {
  // A driver's slabs (Mesa: 32 KiB each) are seldom full. Their unused parts stay resident if they
  // lie in pages of the exhibit before.
  files::give_back_memory();
  std::unique_ptr<Kiosk> kiosk(new Kiosk);
  if (auto good = kiosk->read_settings(options); !good) return tl::unexpected(good.error());
  kiosk->shelf_ = std::make_unique<Shelf>(options.shelf.value_or(kiosk->exhibit_.shelf),
                                          *kiosk->scenes_, kiosk->exhibit_);
  kiosk->missions_ =
      std::make_unique<Missions>(kiosk->exhibit_, *kiosk->scenes_, options.wall, options.mission);
  const fs::path kept_in = options.keepsakes.value_or(kiosk->exhibit_.keepsake.folder);
  // A stepped visit is the same everywhere: it uses the scenes' own grids.
  if (!options.stepped) kiosk->scenes_->tune(kept_in, options.tune);
  if (kiosk->exhibit_.keepsake.gallery)
    kiosk->todays_ = std::make_unique<TodaysPots>(kept_in, options.wall);
  if (kiosk->exhibit_.store.count)
    kiosk->counter_ = std::make_unique<VisitCounter>(files::store_file(kept_in), kiosk->exhibit_,
                                                     souvenir::Passes(kept_in).fetched());
  render::WindowOptions window = options.window;
  window.opening = [&first = kiosk->languages_.front()](int width, int height) {
    return make_opening_frame(first, width, height, 0, 0);
  };
  auto renderer = options.renderer(window);
  if (!renderer) return tl::unexpected(renderer.error());
  kiosk->renderer_ = std::move(*renderer);
  render::when_display_is_lost([lost = kiosk.get()] {
    files::log_line("The screen's X server is gone. What is under way is kept, and onggi ends.");
    if (lost->keeping_) lost->keeping_->lose_screen();
    lost->close_visit();
  });
  const render::RenderStatus drawn_by = kiosk->renderer_->status();
  files::log_line("Drawing with " + drawn_by.device + " by " +
                  (drawn_by.embedded ? "OpenGL ES" : "OpenGL") +
                  (drawn_by.software ? ", without a GPU." : "."));

  if (options.stepped) {
    auto stepped = std::make_unique<loop::SteppedWheel>();
    kiosk->stepped_ = stepped.get();
    kiosk->wheel_host_ = std::move(stepped);
    kiosk->renderer_->set_full_quality(true);
    kiosk->shelf_->wait();
    kiosk->log_unknown_names();
    kiosk->missions_->look(kiosk->shelf_->cards(), true, true);
  } else {
    auto loop = std::make_unique<loop::LoopThread>();
    for (const std::string& remark : loop->remarks()) files::log_line(remark);
    kiosk->wheel_host_ = std::move(loop);
    if (kiosk->exhibit_.sound.volume > 0.0)
      kiosk->sound_ =
          std::make_unique<StudioSound>(*kiosk->wheel_host_, kiosk->exhibit_.sound.volume);
  }
  kiosk->pot_ = std::make_unique<PotOnWheel>(*kiosk->scenes_, *kiosk->wheel_host_,
                                             *kiosk->renderer_, options.seed, options.stepped);
  kiosk->keeping_ = std::make_unique<Keeping>(
      Keeping::World{kiosk->exhibit_, kiosk->languages_, kiosk->names_, *kiosk->renderer_,
                     *kiosk->wheel_host_, kiosk->todays_.get(), kiosk->counter_.get()},
      kept_in);
  kiosk->wall_ = options.wall;
  kiosk->staff_corner_ = std::make_unique<StaffCorner>(
      kept_in, [wall = options.wall] { return static_cast<std::int64_t>(wall()); });
  kiosk->access_input_ = std::make_unique<AccessInput>(kiosk->exhibit_, !options.stepped);
  if (kiosk->exhibit_.hours.kept && !options.stepped) kiosk->night_.emplace(kiosk->exhibit_.hours);
  if (options.devices)
    kiosk->devices_ = std::make_unique<HandDevices>(
        *kiosk->wheel_host_, options.bus(), defined_devices(kiosk->exhibit_),
        HandDevices::Options{options.stepped, kiosk->exhibit_.screen.left_handed,
                             kiosk->exhibit_.screen.force});
  return kiosk;
}

Kiosk::~Kiosk() {
  render::when_display_is_lost({});
  close_visit();
}

void Kiosk::close_visit() {
  if (!visit_) return;
  visit_->close(now_);
  while (const auto request = visit_->take_request())
    if (const auto* over = std::get_if<screens::VisitEnded>(&*request)) carry_out(*over);
  keeping_->finish(*visit_);
}

bool Kiosk::nobody_is_here() const {
  return visit_ && visit_->screen() == screens::ScreenId::attract && !keeping_->saving() &&
         !keeping_->adding();
}

Doing Kiosk::doing() const {
  return {.open_to_visitors = visit_ != nullptr,
          .nobody_is_here = nobody_is_here(),
          .dark = dark(),
          .saving = keeping_->saving(),
          .turning = keeping_->turning(),
          .saved = keeping_->saved(),
          .room = keeping_->room(),
          .keepsake_folder = keeping_->folder(),
          .kept = keeping_->kept() ? &*keeping_->kept() : nullptr,
          .pot = pot_->def(),
          .card = pot_->card(),
          .way_in = staff_corner_->way_in(),
          .device_moves = devices_ ? std::optional(devices_->moves()) : std::nullopt};
}

Result<void> Kiosk::read_settings(const KioskOptions& options) {
  std::error_code ignored;
  if (!fs::is_regular_file(options.config, ignored))
    return problem(options.config.string(), "There is no such exhibit file.",
                   "Name one: onggi run --config config/exhibit.toml.");
  auto exhibit = settings::read_exhibit(options.config);
  files::log_problems(exhibit.problems);
  exhibit_ = std::move(exhibit.exhibit);
  // Both are of the exhibit's own shelf.
  if (options.shelf) exhibit_.order = exhibit_.hidden = {};
  if (!options.languages.empty()) exhibit_.languages = options.languages;
  if (options.scan_seconds) exhibit_.screen.scan_seconds = *options.scan_seconds;
  exhibit_.translations =
      content::read_translations(files::language_folder(exhibit_.file), exhibit_.languages);
  scenes_ = std::make_unique<Scenes>(exhibit_);

  auto languages = read_languages(exhibit_, options.language);
  if (!languages) return tl::unexpected(languages.error());
  languages_ = std::move(*languages);
  auto names = content::KeepsakeNames::read(content::names_file(exhibit_.file), exhibit_.languages);
  files::log_problems(names.problems);
  names_ = std::move(names.names);
  const auto read_lesson = [this](const std::optional<fs::path>& file) {
    if (!file) return std::vector<content::LessonStep>{};
    auto lesson = content::read_lesson(*file, exhibit_.languages, exhibit_.translations);
    files::log_problems(lesson.problems);
    return std::move(lesson.steps);
  };
  lesson_ = read_lesson(exhibit_.lesson);
  build_lesson_ = read_lesson(exhibit_.build_lesson);
  return {};
}

void Kiosk::begin_visit(double now) {
  screens::VisitInputs world;
  world.exhibit = &exhibit_;
  world.languages = &languages_;
  world.shelf = &shelf_->cards();
  world.lesson = &lesson_;
  world.build_lesson = &build_lesson_;
  world.measure = &renderer_->measure();
  world.wheel = &wheel_host_->view();
  world.wheel_commands = wheel_host_.get();
  if (devices_) world.devices = &devices_->news();
  if (todays_) world.todays = &todays_->pots();
  world.missions = &missions_->cards();
  visit_ = std::make_unique<screens::Visit>(world);
  if (stepped_ == nullptr) visit_->wander();
  if (shelf_->cards().empty())
    visit_->fail({exhibit_.shelf.string(), "No vessel on the shelf could be opened.",
                  "Run onggi check, mend what it names, and start again."});
  if (!early_touch_) return;
  // Replay a touch made while the shelf was loading.
  visit_->input(*early_touch_, now);
  early_touch_->kind = early_touch_->kind == view::InputEvent::Kind::key_down
                           ? view::InputEvent::Kind::key_up
                           : view::InputEvent::Kind::pointer_up;
  visit_->input(*early_touch_, now);
}

/// The rest of the shelf may still be read while the first visitor is here.
bool Kiosk::look_at_shelf(double now) {
  const bool complete = shelf_->complete();
  const bool ready = shelf_->look(now);
  if (!complete && shelf_->complete()) log_unknown_names();
  missions_->look(shelf_->cards(), shelf_->complete(), nobody_is_here(), able());
  return ready;
}

/// A scripted visitor has ears and fingers of its own.
Capabilities Kiosk::able() {
  if (stepped_ != nullptr) return {};
  if (now_ >= fingers_asked_ + kAskFingers) {
    fingers_asked_ = now_;
    two_fingers_ = renderer_->fingers() >= 2;
  }
  return {sound_ && sound_->speaker().playing() && !exhibit_.screen.silent, two_fingers_};
}

void Kiosk::log_unknown_names() {
  std::vector<std::string> ids = exhibit_.hidden;  // not read, so not looked for
  for (const screens::ShelfCard& card : shelf_->cards()) ids.push_back(card.vessel->id);
  files::log_problems(unknown_names(exhibit_, ids));
}

void Kiosk::show_as(const settings::Exhibit::Screen& screen, const std::string& language) {
  exhibit_.screen = screen;
  visit_->speak(language);
}

void Kiosk::advance(int ticks) {
  if (stepped_ != nullptr) stepped_->advance(ticks);
}

std::vector<view::InputEvent> Kiosk::look_after_devices(double now) {
  if (!devices_) return {};
  auto events = devices_->frame(now);
  for (const std::string& line : devices_->remarks()) files::log_line(line);
  files::log_problems(devices_->problems());
  if (visit_) devices_->share(dark() ? 0.0 : visit_->force_share());
  return events;
}

/// The touch that wakes the screen is not passed on, because the visitor could not see it.
bool Kiosk::update_night(double now, const std::vector<view::InputEvent>& events) {
  const bool was = night_->dark(), taken = wheel_host_->view().status.hands_taken;
  bool touched = !std::exchange(hands_taken_, taken) && taken;
  for (const view::InputEvent& event : events)
    touched = touched || event.kind == view::InputEvent::Kind::pointer_down ||
              event.kind == view::InputEvent::Kind::key_down;
  const bool dark = night_->look(now, files::local_moment(wall_()), nobody_is_here(), touched);
  if (dark != was) {
    files::log_line(dark ? "The museum is closed: the screen is dark and the wheel rests."
                         : "The screen is on again.");
    wheel_host_->wheel(0.0);
    wheel_host_->pause(dark);
  }
  renderer_->sleep(dark && exhibit_.hours.screen_off);
  return dark || was;
}

void Kiosk::be_dark(bool draw) {
  last_frame_ = {};
  last_frame_.width = renderer_->width();
  last_frame_.height = renderer_->height();
  const view::Rect all{0, 0, static_cast<float>(last_frame_.width),
                       static_cast<float>(last_frame_.height)};
  last_frame_.items.push_back(view::Box{all, 0, {0, 0, 0, 1}, 0, {}});
  if (!draw) return;
  renderer_->draw(last_frame_);
  renderer_->present();
  // Often enough for a touch, the watchdog, and files that arrive in watched folders.
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
}

std::vector<view::InputEvent> Kiosk::passed_on(const std::vector<view::InputEvent>& events,
                                               double now) {
  std::vector<view::InputEvent> out;
  for (const view::InputEvent& event : events)
    for (const view::InputEvent& one :
         staff_corner_->pass(event, renderer_->width(), renderer_->height(), now))
      out.push_back(one);
  return out;
}

bool Kiosk::frame(double now, bool draw) {
  bool open = true;
  now_ = now;
  keeping_->look(now);
  auto events = renderer_->poll();
  for (const std::string& line : renderer_->remarks()) files::log_line(line);
  if (look_at_shelf(now) && !visit_) begin_visit(now);
  // By night too: nobody is here then, and a full disk is reported at once.
  scenes_->take_up_tuned();
  if (counter_) files::log_problems(counter_->remarks());
  if (sound_) sound_->frame(now, visit_.get(), dark());
  const auto pressed = look_after_devices(now);
  events.insert(events.end(), pressed.begin(), pressed.end());
  for (const view::InputEvent& event : events)
    if (event.kind == view::InputEvent::Kind::close) open = false;
  if (visit_ && night_ && update_night(now, events)) {
    wheel_host_->collect();
    pot_->log_faults();
    keeping_->collect(*visit_);
    be_dark(draw);
    return open;
  }
  for (const view::InputEvent& event : passed_on(events, now)) {
    if (visit_)
      access_input_->input(event, *visit_, renderer_->width(), renderer_->height(), now);
    else if (event.kind == view::InputEvent::Kind::pointer_down ||
             event.kind == view::InputEvent::Kind::key_down)
      early_touch_ = event;
  }
  if (!visit_) {
    renderer_->draw(opening_frame());
    renderer_->present();
    return open;
  }

  wheel_host_->collect();
  pot_->log_faults();
  renderer_->update_clay(wheel_host_->view().clay);
  renderer_->show_decoration(visit_->decoration());
  keeping_->collect(*visit_);
  keeping_->draw_keepsake(*visit_);
  if (todays_) todays_->look(now, *renderer_, stepped_ != nullptr);
  visit_->update(now);
  while (auto request = visit_->take_request())
    std::visit([this](const auto& wish) { carry_out(wish); }, *request);
  put_pot();
  while ((shelf_->draw_next_picture(*renderer_) || missions_->draw_next_picture(*renderer_)) &&
         stepped_ != nullptr) {
  }
  last_frame_ = visit_->frame(renderer_->width(), renderer_->height());
  keeping_->draw_turning(last_frame_);
  access_input_->frame(*visit_, last_frame_, now);
  if (const auto sight = visit_->sight(); access_input_->sings() && sound_ && sight)
    sound_->sing(*sight);
  staff_corner_->draw(last_frame_, languages_.front(), now);
  if (draw) {
    renderer_->draw(last_frame_);
    renderer_->present();
  }
  const bool nobody = nobody_is_here() && shelf_->complete();
  if (!std::exchange(nobody_was_here_, nobody) && nobody) files::give_back_memory();
  return open;
}

view::Image Kiosk::picture() {
  renderer_->draw(last_frame_);
  return renderer_->read_pixels();
}

view::Frame Kiosk::opening_frame() const {
  const Arrivals::Progress progress = shelf_->progress();
  return make_opening_frame(languages_.front(), renderer_->width(), renderer_->height(),
                            progress.done, progress.total);
}

void Kiosk::carry_out(const screens::StartPot& request) {
  if (const screens::ShelfCard* wanted = card(request.card)) pot_->start(request, *wanted);
}

void Kiosk::put_pot() {
  if (!pot_->made()) return;
  const screens::ShelfCard* wanted = card(pot_->wished_card());
  if (wanted == nullptr) return;
  keeping_->draw_rest();
  if (const auto put = pot_->put(*wanted); !put) {
    files::log_problem(put.error());
    visit_->fail(put.error());
  }
}

void Kiosk::carry_out(const screens::MakeKeepsake& request) {
  if (const screens::ShelfCard* answered = card(request.card))
    keeping_->make(request, *answered, *visit_);
}

void Kiosk::carry_out(const screens::VisitEnded& request) {
  const screens::ShelfCard* chosen = request.notes ? card(request.notes->card) : nullptr;
  keeping_->forget(request, chosen != nullptr ? chosen->vessel->id : "");
}

}  // namespace onggi::exhibit
