#include "kiosk/exhibit/composition/kiosk.h"

#include <chrono>
#include <thread>
#include <utility>

#include "engine/scene/lump.h"
#include "engine/script/script.h"
#include "kiosk/exhibit/composition/device_files.h"
#include "kiosk/exhibit/composition/vessel_model.h"
#include "kiosk/exhibit/composition/words.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/log.h"
#include "kiosk/ground/files/memory.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/picture/render/display_loss.h"
#include "kiosk/wheel/device/hidapi_bus.h"
#include "kiosk/wheel/loop/loop_thread.h"
#include "kiosk/wheel/loop/stepped_potter.h"

namespace fs = std::filesystem;

namespace onggi::exhibit {

namespace {

constexpr double kAskFingers = 5.0;  // s: a glass that is plugged in is seen so soon
constexpr std::size_t kSpokenName = sizeof("2026-05-04_141503") - 1;

}  // namespace

Result<std::unique_ptr<Kiosk>> Kiosk::open(const KioskOptions& options) {
  // A driver's slabs (Mesa: 32 KiB each) are seldom full. What nobody touched of one is resident
  // all the same where it lies in pages of the exhibit before.
  files::give_back_memory();
  std::unique_ptr<Kiosk> kiosk(new Kiosk);
  kiosk->seed_ = options.seed;
  if (auto good = kiosk->read_settings(options); !good) return tl::unexpected(good.error());
  kiosk->shelf_ = std::make_unique<Shelf>(options.shelf.value_or(kiosk->exhibit_.shelf),
                                          *kiosk->scenes_, kiosk->exhibit_.reader);
  kiosk->missions_ =
      std::make_unique<Missions>(kiosk->exhibit_, *kiosk->scenes_, options.wall, options.mission);
  const fs::path kept_in = options.keepsakes.value_or(kiosk->exhibit_.keepsake.folder);
  // A stepped visit is the same wherever it is made: its grids are the scenes' own.
  if (!options.stepped) kiosk->scenes_->tune(kept_in);
  const auto& keep = kiosk->exhibit_.keepsake;
  const auto& phone = kiosk->exhibit_.phone;
  kiosk->keepsakes_ =
      std::make_unique<Keepsakes>(kept_in, souvenir::KeepsakeLimits{keep.quota_mb, keep.days},
                                  phone.address.empty() ? 0.0 : phone.hours);
  if (keep.gallery) kiosk->todays_ = std::make_unique<TodaysPots>(kept_in, options.wall);
  if (kiosk->exhibit_.store.count)
    kiosk->counter_ = std::make_unique<VisitCounter>(files::store_file(kept_in), kiosk->exhibit_,
                                                     souvenir::Passes(kept_in).fetched());
  auto renderer = render::Renderer::create(options.window);
  if (!renderer) return tl::unexpected(renderer.error());
  kiosk->renderer_ = std::move(*renderer);
  render::when_display_is_lost([lost = kiosk.get()] {
    files::log_line("The screen's X server is gone. What is under way is kept, and onggi ends.");
    lost->postcard_ = 0;  // a picture of that screen
    lost->settle();
  });
  const render::RenderStatus drawn_by = kiosk->renderer_->status();
  files::log_line("Drawing with " + drawn_by.device +
                  (drawn_by.software ? ", without a GPU." : "."));

  if (options.stepped) {
    auto stepped = std::make_unique<loop::SteppedPotter>();
    kiosk->stepped_ = stepped.get();
    kiosk->potter_ = std::move(stepped);
    kiosk->renderer_->set_full_quality(true);
    kiosk->shelf_->wait();
    kiosk->note_shelf();
    kiosk->missions_->look(kiosk->shelf_->cards(), true, true);
  } else {
    auto loop = std::make_unique<loop::LoopThread>();
    for (const std::string& remark : loop->remarks()) files::log_line(remark);
    kiosk->potter_ = std::move(loop);
    if (kiosk->exhibit_.sound.volume > 0.0)
      kiosk->sound_ = std::make_unique<StudioSound>(*kiosk->potter_, kiosk->exhibit_.sound.volume);
  }
  kiosk->wall_ = options.wall;
  kiosk->attendant_ = std::make_unique<Attendant>(kiosk->exhibit_, !options.stepped);
  if (kiosk->exhibit_.hours.kept && !options.stepped) kiosk->night_.emplace(kiosk->exhibit_.hours);
  if (options.devices)
    kiosk->devices_ = std::make_unique<HandDevices>(
        *kiosk->potter_, device::hidapi_bus(), defined_devices(kiosk->exhibit_),
        HandDevices::Options{options.stepped, kiosk->exhibit_.screen.left_handed,
                             kiosk->exhibit_.screen.force});
  return kiosk;
}

Kiosk::~Kiosk() {
  render::when_display_is_lost({});
  settle();
}

void Kiosk::settle() {
  if (!visit_) return;
  visit_->close(now_);
  while (const auto request = visit_->take_request())
    if (const auto* over = std::get_if<screens::ForgetVisitor>(&*request)) carry_out(*over);
  keepsakes_->wait();
  while (keepsakes_->busy() || keepsakes_->adding()) note_saved();
  if (!counter_) return;
  counter_->finish();
  files::log_problems(counter_->remarks());
}

Result<void> Kiosk::read_settings(const KioskOptions& options) {
  std::error_code ignored;
  if (!fs::is_regular_file(options.config, ignored))
    return problem(options.config.string(), "There is no such exhibit file.",
                   "Name one: onggi run --config config/exhibit.toml.");
  auto exhibit = settings::read_exhibit(options.config);
  files::log_problems(exhibit.problems);
  exhibit_ = std::move(exhibit.exhibit);
  if (!options.languages.empty()) exhibit_.languages = options.languages;
  if (options.scan_seconds) exhibit_.screen.scan_seconds = *options.scan_seconds;
  scenes_ = std::make_unique<Scenes>(exhibit_);

  auto languages = read_languages(exhibit_, options.language);
  if (!languages) return tl::unexpected(languages.error());
  languages_ = std::move(*languages);
  if (exhibit_.lesson) {
    auto lesson = content::read_lesson(*exhibit_.lesson, exhibit_.languages);
    files::log_problems(lesson.problems);
    lesson_ = std::move(lesson.steps);
  }
  return {};
}

void Kiosk::begin_visit(double now) {
  screens::VisitWorld world;
  world.exhibit = &exhibit_;
  world.languages = &languages_;
  world.shelf = &shelf_->cards();
  world.lesson = &lesson_;
  world.measure = &renderer_->measure();
  world.wheel = &potter_->view();
  world.potter = potter_.get();
  if (devices_) world.devices = &devices_->news();
  if (todays_) world.todays = &todays_->pots();
  world.missions = &missions_->cards();
  visit_ = std::make_unique<screens::Visit>(world);
  if (stepped_ == nullptr) visit_->wander();
  if (shelf_->cards().empty())
    visit_->fail({exhibit_.shelf.string(), "No vessel on the shelf could be opened.",
                  "Run onggi check, mend what it names, and start again."});
  if (!early_touch_) return;
  // The first touch counts, even one that came before there was anything to touch.
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
  if (!complete && shelf_->complete()) note_shelf();
  missions_->look(shelf_->cards(), shelf_->complete(), nobody_is_here(), able());
  return ready;
}

/// A scripted visitor has ears and fingers of its own.
Able Kiosk::able() {
  if (stepped_ != nullptr) return {};
  if (now_ >= fingers_asked_ + kAskFingers) {
    fingers_asked_ = now_;
    two_fingers_ = renderer_->fingers() >= 2;
  }
  return {sound_ && sound_->speaker().playing() && !exhibit_.screen.silent, two_fingers_};
}

void Kiosk::note_shelf() {
  std::vector<std::string> ids;
  for (const screens::ShelfCard& card : shelf_->cards()) ids.push_back(card.vessel->id);
  files::log_problems(names_of_nothing(exhibit_, ids));
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

/// Whoever wakes it only wakes it: what was touched in the dark was not seen.
bool Kiosk::is_night(double now, const std::vector<view::InputEvent>& events) {
  const bool was = night_->dark(), taken = potter_->view().status.hands_taken;
  bool touched = !std::exchange(hands_taken_, taken) && taken;
  for (const view::InputEvent& event : events)
    touched = touched || event.kind == view::InputEvent::Kind::pointer_down ||
              event.kind == view::InputEvent::Kind::key_down;
  const bool dark = night_->look(now, files::local_moment(wall_()), nobody_is_here(), touched);
  if (dark != was) {
    files::log_line(dark ? "The museum is closed: the screen is dark and the wheel rests."
                         : "The screen is on again.");
    potter_->wheel(0.0);
    potter_->pause(dark);
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
  // Often enough for a touch, for what watches over the kiosk, and for what comes into its folders.
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
}

bool Kiosk::frame(double now, bool draw) {
  bool open = true;
  now_ = now;
  keepsakes_->look(now);
  if (const auto untidy = keepsakes_->untidy()) files::log_problem(*untidy);
  auto events = renderer_->poll();
  for (const std::string& line : renderer_->remarks()) files::log_line(line);
  if (look_at_shelf(now) && !visit_) begin_visit(now);
  if (sound_) sound_->frame(now, visit_.get(), dark());
  const auto pressed = look_after_devices(now);
  events.insert(events.end(), pressed.begin(), pressed.end());
  for (const view::InputEvent& event : events)
    if (event.kind == view::InputEvent::Kind::close) open = false;
  if (visit_ && night_ && is_night(now, events)) {
    potter_->collect();
    note_saved();
    be_dark(draw);
    return open;
  }
  for (const view::InputEvent& event : events) {
    if (visit_)
      attendant_->input(event, *visit_, renderer_->width(), renderer_->height(), now);
    else if (event.kind == view::InputEvent::Kind::pointer_down ||
             event.kind == view::InputEvent::Kind::key_down)
      early_touch_ = event;
  }
  if (!visit_) {
    renderer_->draw(opening_frame());
    renderer_->present();
    return open;
  }

  scenes_->take_up_tuned();
  potter_->collect();
  renderer_->update_clay(potter_->view().clay);
  note_saved();
  if (counter_) files::log_problems(counter_->remarks());
  for (const std::string& line : fault_log_.news(potter_->view().status)) files::log_line(line);
  if (todays_) todays_->look(now, *renderer_, stepped_ != nullptr);
  visit_->update(now);
  while (auto request = visit_->take_request())
    std::visit([this](const auto& wish) { carry_out(wish); }, *request);
  while ((shelf_->draw_next_picture(*renderer_) || missions_->draw_next_picture(*renderer_)) &&
         stepped_ != nullptr) {
  }
  last_frame_ = visit_->frame(renderer_->width(), renderer_->height());
  draw_turning();
  attendant_->frame(*visit_, last_frame_, now);
  if (const auto sight = visit_->sight(); attendant_->sings() && sound_ && sight)
    sound_->sing(*sight);
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
  const screens::ShelfCard* wanted = this->card(request.card);
  if (wanted == nullptr) return;
  const screens::ShelfCard& card = *wanted;
  SceneDef def = scenes_->of(card.vessel->id);
  def.clay = lump_for(card.target, def);
  auto scene = Scene::create(def);
  if (!scene) {
    files::log_problem(scene.error());
    visit_->fail(scene.error());
    return;
  }
  pot_def_ = def;
  pot_card_ = request.card;
  potter_->start(std::make_unique<Scene>(std::move(*scene)));
  renderer_->show_clay(potter_->view().clay);
  ++pots_;
  if (!request.scripted) {
    potter_->record(card.vessel->id, seed_);
    show_vessel(*renderer_, card);
    return;
  }
  potter_->show();
  if (request.script.empty()) return;
  auto script = make_script(request.script, {def, &card.target, seed_ + pots_});
  if (script)
    potter_->play(std::move(*script));
  else
    files::log_problem(script.error());
}

void Kiosk::carry_out(const screens::MakeKeepsake& request) {
  const screens::ShelfCard* answered = card(request.card);
  if (answered == nullptr) return;
  auto taken = take_home(request, *answered, language_of(languages_, visit_->language()), exhibit_,
                         *potter_, *renderer_, keepsakes_->token());
  if (!taken) return visit_->keepsake_failed(taken.error());
  if (postcard_ != 0) renderer_->drop_picture(postcard_);
  postcard_ = renderer_->make_picture(taken->keepsake.postcard);
  visit_->show_postcard(postcard_);
  const encoding::Caption caption = taken->keepsake.caption;
  kept_ticket_ = saving_ticket_ = keepsakes_->save(std::move(taken->keepsake));
  if (exhibit_.keepsake.turning)
    turning_.begin(saving_ticket_, caption, request.made, taken->glazing, potter_->view().clay,
                   visit_->shown_on().left_handed);
  kept_ = std::move(taken->visit);
}

void Kiosk::carry_out(const screens::ForgetVisitor& request) {
  if (counter_ && request.notes) {
    const screens::ShelfCard* chosen = card(request.notes->card);
    const std::string vessel = chosen != nullptr ? chosen->vessel->id : "";
    counter_->visit_over(*request.notes, vessel, saving_ticket_);
  }
  potter_->stop_recording();
  saving_ticket_ = 0;
  if (postcard_ != 0) renderer_->drop_picture(std::exchange(postcard_, 0));
}

/// A picture a frame, and none while one screen fades into another.
void Kiosk::draw_turning() {
  if (last_frame_.fade > 0) return;
  auto drawn = turning_.draw(potter_->view().clay, *renderer_);
  if (drawn) keepsakes_->add(drawn->ticket, std::move(drawn->turning), std::move(drawn->caption));
}

void Kiosk::note_saved() {
  if (const auto added = keepsakes_->added()) {
    if (added->outcome)
      files::log_line("Kept " + added->outcome->string());
    else
      files::log_problem(added->outcome.error());
    // The pot of kept() is the last that was saved, and its picture has the same ticket.
    if (kept_ && added->ticket == kept_ticket_) kept_->turning = added->outcome;
  }
  const auto saved = keepsakes_->finished();
  if (!saved) return;
  ++(saved->outcome ? saved_.kept : saved_.refused);
  if (saved->outcome)
    files::log_line("Kept " + saved->outcome->folder.string());
  else
    files::log_problem(saved->outcome.error());
  if (todays_) todays_->hurry();
  if (counter_) counter_->saved(*saved);
  // A save that outlasted its visitor is none of the next one's business.
  if (saved->ticket != saving_ticket_) return;
  if (kept_) kept_->saved = saved->outcome;
  // Date and time are enough to ask for at the desk, and short enough to remember.
  if (saved->outcome)
    visit_->keepsake_kept(
        saved->outcome->folder.filename().string().substr(0, kSpokenName),
        saved->outcome->token.empty() ? "" : phone_address(exhibit_, saved->outcome->token));
  else
    visit_->keepsake_failed(saved->outcome.error());
}

}  // namespace onggi::exhibit
