#include "kiosk/exhibit/composition/keepsakes.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <string>
#include <utility>

#include "kiosk/ground/files/wall_clock.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"

namespace onggi::exhibit {

namespace {

/// Waits for `other` and releases it. A future keeps its task's data, so a chain of futures would
/// keep everything since the start of the program.
template <class T>
void wait_out(std::shared_future<T>& other) {
  if (other.valid()) other.wait();
  other = {};
}

std::set<std::string> spoken_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (souvenir::NamedVisit& one : souvenir::named_visits(folder))
    names.insert(std::move(one.spoken));
  return names;
}

}  // namespace

Keepsakes::Keepsakes(std::filesystem::path folder, souvenir::KeepsakeLimits limits,
                     double phone_hours, Namer namer)
    : folder_(std::move(folder)),
      limits_(limits),
      phone_hours_(phone_hours),
      namer_(std::move(namer)) {}

Keepsakes::~Keepsakes() {
  wait();
  if (tidying_.valid()) tidying_.wait();
  if (looking_.valid()) looking_.wait();
}

void Keepsakes::wait() const {
  for (const auto& save : saving_) save.wait();
  for (const auto& picture : adding_) picture.wait();
}

std::string Keepsakes::token() const {
  const auto known = room();
  if (phone_hours_ <= 0.0 || (known && !known->for_a_page()) ||
      !souvenir::Passes(folder_).served(std::time(nullptr)))
    return {};
  return souvenir::Passes::new_token().value_or("");
}

int Keepsakes::save(souvenir::Keepsake keepsake, std::uint64_t name_seed) {
  // Each save waits for the one before: two at once would each check the quota without the other.
  std::shared_future<Finished> before;
  if (!saving_.empty()) before = saving_.back();
  const int ticket = ++tickets_;
  saving_.push_back(
      std::async(std::launch::async, [this, ticket, before, name_seed, tidying = tidying_,
                                      kept = std::move(keepsake)]() mutable {
        wait_out(before);
        wait_out(tidying);
        souvenir::Keepsake mine = std::move(kept);
        const std::lock_guard one_at_a_time(folder_in_use_);
        if (namer_) mine.spoken = namer_(name_seed, spoken_in(folder_));
        Finished done{ticket, souvenir::save(mine, folder_, limits_)};
        look_for_room();
        return done;
      }).share());
  last_save_ = {ticket, saving_.back()};
  return ticket;
}

void Keepsakes::add(int ticket, encoding::Turning turning, encoding::Caption caption) {
  if (ticket != last_save_.first) return;
  adding_.push_back(std::async(
      std::launch::async, [this, ticket, save = std::exchange(last_save_, {}).second,
                           turning = std::move(turning), caption = std::move(caption)]() mutable {
        const auto gif = souvenir::turning_picture(turning, caption);
        turning = {};
        const Result<souvenir::KeepsakeFiles> kept = save.get().outcome;
        save = {};
        const auto add = [&]() -> Result<std::filesystem::path> {
          if (!kept) return tl::unexpected(kept.error());
          if (!gif) return tl::unexpected(gif.error());
          const std::lock_guard one_at_a_time(folder_in_use_);
          return souvenir::add_turning(kept->folder, *gif, limits_);
        };
        return Added{ticket, add()};
      }));
}

std::optional<Keepsakes::Added> Keepsakes::added() {
  const auto done = std::find_if(adding_.begin(), adding_.end(), [](const auto& picture) {
    return picture.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  });
  if (done == adding_.end()) return std::nullopt;
  Added added = done->get();
  adding_.erase(done);
  return added;
}

void Keepsakes::look_for_room() {
  if (phone_hours_ <= 0.0) return;
  const souvenir::Room found = souvenir::room_in(folder_, limits_, files::wall_now());
  const std::lock_guard lock(room_in_use_);
  room_ = found;
}

std::optional<souvenir::Room> Keepsakes::room() const {
  const std::lock_guard lock(room_in_use_);
  return room_;
}

std::optional<Problem> Keepsakes::crowded(double now) {
  const auto known = room();
  if (!known) return std::nullopt;
  const bool last = !known->for_a_page();
  if (warned_at_ && now - *warned_at_ < kTidy && (warned_of_last_ || !last)) return std::nullopt;
  auto warning = souvenir::warning_of(*known, phone_hours_);
  if (warning) warned_at_ = now, warned_of_last_ = last;
  return warning;
}

void Keepsakes::look(double now) {
  // Pages end by themselves, and visitors delete theirs.
  if (phone_hours_ > 0.0 && (!looked_at_ || now - *looked_at_ >= kRoom)) {
    looked_at_ = now;
    looking_ = std::async(std::launch::async, [this, last = std::move(looking_)]() mutable {
      if (last.valid()) last.get();
      look_for_room();
    });
  }
  if (tidied_at_ && now - *tidied_at_ < kTidy) return;
  tidied_at_ = now;
  std::shared_future<Finished> before;
  if (!saving_.empty()) before = saving_.back();
  told_ = false;
  tidying_ = std::async(std::launch::async, [this, before, last = tidying_]() mutable {
               wait_out(before);
               wait_out(last);
               const std::lock_guard one_at_a_time(folder_in_use_);
               return souvenir::tidy(folder_, limits_);
             }).share();
}

std::optional<Problem> Keepsakes::untidy() {
  if (told_ || !tidying_.valid() ||
      tidying_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return std::nullopt;
  told_ = true;
  const Result<void>& good = tidying_.get();
  if (good) return std::nullopt;
  return good.error();
}

std::optional<Keepsakes::Finished> Keepsakes::finished() {
  if (saving_.empty() ||
      saving_.front().wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return std::nullopt;
  Finished done = saving_.front().get();
  saving_.erase(saving_.begin());
  return done;
}

}  // namespace onggi::exhibit
