#include "kiosk/keepsake/phone/connection_shares.h"

#include <algorithm>

namespace onggi::phone {

ConnectionShares::Entry ConnectionShares::enter(const std::string& address) {
  const auto own = addresses_.find(address);
  const std::size_t held = own == addresses_.end() ? 0 : own->second.all();
  Entry entry;
  if (held >= share()) {
    if (own->second.silent.empty()) return {};
    entry.out = *own->second.silent.begin();
  } else if (open() >= all_) {
    const auto silent =
        std::max_element(addresses_.begin(), addresses_.end(), [](const auto& a, const auto& b) {
          return a.second.silent.size() < b.second.silent.size();
        });
    const auto most = std::max_element(
        addresses_.begin(), addresses_.end(),
        [](const auto& a, const auto& b) { return a.second.all() < b.second.all(); });
    if (!silent->second.silent.empty())
      entry.out = *silent->second.silent.begin();
    else if (most->second.all() > held + 1)
      entry.out = *most->second.asking.begin();
    else
      return {};
  }
  leave(entry.out);
  entry.in = ++last_;
  addresses_[address].silent.insert(entry.in);
  addresses_of_.emplace(entry.in, address);
  return entry;
}

void ConnectionShares::asked(Number number) {
  const auto at = addresses_of_.find(number);
  if (at == addresses_of_.end()) return;
  Address& address = addresses_[at->second];
  if (address.silent.erase(number) > 0) address.asking.insert(number);
}

void ConnectionShares::leave(Number number) {
  const auto at = addresses_of_.find(number);
  if (at == addresses_of_.end()) return;
  const auto address = addresses_.find(at->second);
  address->second.silent.erase(number);
  address->second.asking.erase(number);
  if (address->second.all() == 0) addresses_.erase(address);
  addresses_of_.erase(at);
}

}  // namespace onggi::phone
