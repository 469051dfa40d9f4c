#include "kiosk/exhibit/composition/arrivals.h"

#include <utility>

namespace onggi::exhibit {

void Arrivals::begins(std::size_t, std::size_t total, const std::string&) {
  const std::lock_guard lock(mutex_);
  total_ = total;
  taken_.resize(total);
}

void Arrivals::has_read(std::size_t at, Read read) {
  const std::lock_guard lock(mutex_);
  ++read_;
  waiting_.emplace(at, std::move(read));
}

void Arrivals::finish() {
  const std::lock_guard lock(mutex_);
  finished_ = true;
}

Arrivals::Progress Arrivals::progress() const {
  const std::lock_guard lock(mutex_);
  return {static_cast<int>(read_), static_cast<int>(total_)};
}

std::vector<Arrivals::Read> Arrivals::take(double now) {
  const std::lock_guard lock(mutex_);
  std::vector<Read> out;
  const auto take_first = [&] {
    const auto first = waiting_.begin();
    taken_[first->first] = true;
    out.push_back(std::move(first->second));
    waiting_.erase(first);
    while (next_ < taken_.size() && taken_[next_]) ++next_;
  };
  while (!waiting_.empty() && (finished_ || waiting_.begin()->first <= next_)) take_first();
  if (!waiting_.empty() && since_ < 0.0) since_ = now;
  if (!waiting_.empty() && now - since_ >= kPatience)
    while (!waiting_.empty()) take_first();
  if (waiting_.empty()) since_ = -1.0;
  return out;
}

bool Arrivals::over() const {
  const std::lock_guard lock(mutex_);
  return finished_ && waiting_.empty();
}

}  // namespace onggi::exhibit
