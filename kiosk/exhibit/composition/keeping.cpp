#include "kiosk/exhibit/composition/keeping.h"

#include <utility>

#include "kiosk/exhibit/composition/words.h"
#include "kiosk/ground/files/log.h"

namespace onggi::exhibit {

namespace {
constexpr int kUpdatesAFrame = 3;  // of some 6 ms
constexpr std::size_t kStampLength = sizeof("2026-05-04_141503") - 1;
}  // namespace

Keeping::Keeping(const World& world, const std::filesystem::path& folder)
    : world_(world),
      keepsakes_(folder, {world.exhibit.keepsake.quota_mb, world.exhibit.keepsake.days},
                 world.exhibit.phone.address.empty() ? 0.0 : world.exhibit.phone.hours,
                 [&names = world.names](std::uint64_t seed, const std::set<std::string>& taken) {
                   return names.pick(seed, taken);
                 }) {}

void Keeping::look(double now) {
  keepsakes_.look(now);
  if (const auto untidy = keepsakes_.untidy()) files::log_problem(*untidy);
  if (const auto crowded = keepsakes_.crowded(now)) files::log_problem(*crowded);
}

void Keeping::make(const screens::MakeKeepsake& wish, const screens::ShelfCard& card,
                   screens::Visit& visit) {
  draw_rest();
  auto taking =
      TakingHome::begin(wish, card, language_of(world_.languages, visit.language()), world_.exhibit,
                        world_.names, world_.wheel_host, keepsakes_.token());
  if (!taking) return visit.keepsake_failed(taking.error());
  taking_ = std::move(*taking);
  left_handed_ = visit.shown_on().left_handed;
  made_ = wish.made;
  decorated_ = wish.decorated;
  kept_ = taking_->taken.visit;
  kept_ticket_ = saving_ticket_ = 0;
  if (postcard_ == 0) return;
  world_.renderer.drop_picture(std::exchange(postcard_, 0));
  visit.show_postcard(postcard_);
}

void Keeping::draw_keepsake(screens::Visit& visit) {
  if (!taking_) return;
  if (postcard_ != 0 || !taking_->has_postcard()) return draw_next();
  drew_ = true;
  postcard_ = world_.renderer.make_picture(taking_->taken.keepsake.postcard);
  visit.show_postcard(postcard_);
}

void Keeping::draw_next() {
  drew_ = true;
  if (decorated_ && !decorated_->settled()) {
    // A visitor may be quicker than the kiln's melt.
    for (int n = 0; n < kUpdatesAFrame && !decorated_->settled(); ++n) decorated_->update(0.0);
    return;
  }
  const ClayView& clay = world_.wheel_host.view().clay;
  world_.renderer.show_decoration(coat());
  if (taking_->draw_next(world_.exhibit, clay, decorated_.get(), world_.renderer)) return;
  TakenHome taken = std::move(taking_->taken);
  taking_.reset();
  const encoding::Caption caption = taken.keepsake.caption;
  // The clay names the pot, so that a scripted visit has the same pictures each time.
  kept_ticket_ = saving_ticket_ =
      keepsakes_.save(std::move(taken.keepsake), taken.visit.state_hash);
  if (world_.exhibit.keepsake.turning)
    turning_.begin(saving_ticket_, caption, made_, taken.glazing, clay, left_handed_);
}

void Keeping::lose_screen() {
  postcard_ = 0;
  if (!taking_) return;
  if (!taking_->has_postcard()) {
    files::log_problem({"the keepsake", "The screen was lost before its postcard was drawn.",
                        "The visitor may throw another pot once the screen is back.", 1});
    taking_.reset();
    return;
  }
  // Without the code on its other postcard nobody can open a page, so there is none.
  TakenHome taken = std::move(taking_->taken);
  taking_.reset();
  taken.keepsake.phone.reset();
  kept_ticket_ = saving_ticket_ =
      keepsakes_.save(std::move(taken.keepsake), taken.visit.state_hash);
}

void Keeping::draw_rest() {
  if (taking_ && decorated_) decorated_->finish();
  while (taking_) draw_next();
}

void Keeping::forget(const screens::VisitEnded& wish, const std::string& vessel) {
  draw_rest();
  // Counted first: the ticket says which save the visit waits for.
  if (world_.counter && wish.notes) world_.counter->visit_over(*wish.notes, vessel, saving_ticket_);
  world_.wheel_host.stop_recording();
  saving_ticket_ = 0;
  if (postcard_ != 0) world_.renderer.drop_picture(std::exchange(postcard_, 0));
}

void Keeping::collect(screens::Visit& visit) {
  if (const auto added = keepsakes_.added()) {
    if (added->outcome)
      files::log_line("Kept " + added->outcome->string());
    else
      files::log_problem(added->outcome.error());
    // The pot of kept() is the last that was saved, and its picture has the same ticket.
    if (kept_ && added->ticket == kept_ticket_) kept_->turning = added->outcome;
  }
  if (const auto save = keepsakes_.finished()) tell(*save, visit);
}

void Keeping::tell(const Keepsakes::Finished& save, screens::Visit& visit) {
  ++(save.outcome ? saved_.kept : saved_.refused);
  if (save.outcome)
    files::log_line("Kept " + save.outcome->folder.string());
  else
    files::log_problem(save.outcome.error());
  if (world_.todays) world_.todays->hurry();
  if (world_.counter) world_.counter->saved(save);
  if (save.ticket != saving_ticket_) return;  // its visitor has left
  if (kept_) kept_->saved = save.outcome;
  if (!save.outcome) return visit.keepsake_failed(save.outcome.error());
  // Three words are enough to ask for at the desk, and easy to remember. An exhibit without a file
  // of names has the date and time.
  const souvenir::KeepsakeFiles& files = *save.outcome;
  const std::string folder = files.folder.filename().string();
  visit.keepsake_kept(files.spoken.empty() ? folder.substr(0, kStampLength)
                                           : world_.names.said(files.spoken, visit.language()),
                      files.token.empty() ? "" : phone_address(world_.exhibit, files.token),
                      folder);
}

void Keeping::draw_turning(const view::Frame& shown) {
  if (std::exchange(drew_, false) || shown.fade > 0) return;
  if (turning_.drawing()) world_.renderer.show_decoration(coat());
  auto drawn = turning_.draw(world_.wheel_host.view().clay, world_.renderer);
  if (drawn) keepsakes_.add(drawn->ticket, std::move(drawn->turning), std::move(drawn->caption));
}

void Keeping::finish(screens::Visit& visit) {
  draw_rest();
  keepsakes_.wait();
  while (keepsakes_.busy() || keepsakes_.adding()) collect(visit);
  // Last: a visit that waits for its save is counted as kept only once the save is told.
  if (!world_.counter) return;
  world_.counter->finish();
  files::log_problems(world_.counter->remarks());
}

}  // namespace onggi::exhibit
