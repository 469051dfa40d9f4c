#include "kiosk/exhibit/keepsakes.h"

#include <chrono>
#include <utility>

namespace onggi::exhibit {

Keepsakes::Keepsakes(std::filesystem::path folder, int quota_mb)
    : folder_(std::move(folder)), quota_mb_(quota_mb) {}

Keepsakes::~Keepsakes() {
  for (auto& save : saving_) save.wait();
}

int Keepsakes::save(souvenir::Keepsake keepsake) {
  // Each save waits for the one before: two at once would each count the quota without the other.
  std::shared_future<Finished> before;
  if (!saving_.empty()) before = saving_.back();
  const int ticket = ++tickets_;
  saving_.push_back(
      std::async(std::launch::async, [this, ticket, before, kept = std::move(keepsake)] {
        if (before.valid()) before.wait();
        return Finished{ticket, souvenir::save(kept, folder_, quota_mb_)};
      }).share());
  return ticket;
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
