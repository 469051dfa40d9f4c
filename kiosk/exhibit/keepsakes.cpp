#include "kiosk/exhibit/keepsakes.h"

#include <chrono>
#include <ctime>
#include <string>
#include <utility>

#include "kiosk/files/wall_clock.h"
#include "kiosk/souvenir/pass.h"

namespace onggi::exhibit {

namespace {

/// Waits for `other` and lets go of it. A future keeps what its task holds, and so one that is
/// waited for by the next would keep everything since the program began.
template <class T>
void wait_out(std::shared_future<T>& other) {
  if (other.valid()) other.wait();
  other = {};
}

}  // namespace

Keepsakes::Keepsakes(std::filesystem::path folder, souvenir::KeepsakeLimits limits,
                     double phone_hours)
    : folder_(std::move(folder)), limits_(limits), phone_hours_(phone_hours) {}

Keepsakes::~Keepsakes() {
  wait();
  if (tidying_.valid()) tidying_.wait();
}

void Keepsakes::wait() const {
  for (const auto& save : saving_) save.wait();
}

std::string Keepsakes::token() const {
  if (phone_hours_ <= 0.0 || !souvenir::Passes(folder_).served(std::time(nullptr))) return {};
  return souvenir::Passes::new_token().value_or("");
}

int Keepsakes::save(souvenir::Keepsake keepsake) {
  // Each save waits for the one before: two at once would each count the quota without the other.
  std::shared_future<Finished> before;
  if (!saving_.empty()) before = saving_.back();
  const int ticket = ++tickets_;
  saving_.push_back(std::async(std::launch::async, [this, ticket, before, tidying = tidying_,
                                                    kept = std::move(keepsake)]() mutable {
                      wait_out(before);
                      wait_out(tidying);
                      const souvenir::Keepsake mine = std::move(kept);
                      return Finished{ticket, souvenir::save(mine, folder_, limits_)};
                    }).share());
  return ticket;
}

void Keepsakes::look(double now) {
  if (tidied_at_ && now - *tidied_at_ < kTidy) return;
  tidied_at_ = now;
  std::shared_future<Finished> before;
  if (!saving_.empty()) before = saving_.back();
  told_ = false;
  tidying_ = std::async(std::launch::async, [this, before, last = tidying_]() mutable {
               wait_out(before);
               wait_out(last);
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
