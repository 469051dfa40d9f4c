#include "kiosk/ground/web/turns.h"

#include <utility>

namespace onggi::web {

void Turns::add(const std::string& address, Work work) {
  auto& own = waiting_[address];
  if (own.empty()) order_.push_back(address);
  own.push_back(std::move(work));
}

void Turns::next() {
  if (order_.empty()) return;
  std::string address = std::move(order_.front());
  order_.pop_front();
  const auto own = waiting_.find(address);
  const Work work = std::move(own->second.front());
  own->second.pop_front();
  if (own->second.empty())
    waiting_.erase(own);
  else
    order_.push_back(std::move(address));
  work();
}

}  // namespace onggi::web
