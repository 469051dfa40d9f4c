#include "kiosk/ground/web/connection_shares.h"

namespace onggi::web {

ConnectionShares::Entry ConnectionShares::enter(const std::string& address) {
  const auto own = addresses_.find(address);
  const std::size_t held = own == addresses_.end() ? 0 : own->second.all();
  Entry entry;
  if (held >= share()) {
    if (own->second.silent.empty()) return {};
    entry.out = *own->second.silent.begin();
  } else if (open() >= all_) {
    const auto silent = silent_.begin()->of, most = most_.begin()->of;
    if (!silent->second.silent.empty())
      entry.out = *silent->second.silent.begin();
    else if (most->second.all() > held + 1)
      entry.out = *most->second.asking.begin();
    else
      return {};
  }
  leave(entry.out);
  entry.in = ++last_;
  const auto [at, is_new] = addresses_.try_emplace(address);
  if (!is_new) take_counts(at);
  at->second.silent.insert(entry.in);
  put_counts(at);
  addresses_of_.emplace(entry.in, address);
  return entry;
}

void ConnectionShares::asked(Number number) {
  const auto of = addresses_of_.find(number);
  if (of == addresses_of_.end()) return;
  const auto at = addresses_.find(of->second);
  take_counts(at);
  if (at->second.silent.erase(number) > 0) at->second.asking.insert(number);
  put_counts(at);
}

void ConnectionShares::leave(Number number) {
  const auto of = addresses_of_.find(number);
  if (of == addresses_of_.end()) return;
  const auto at = addresses_.find(of->second);
  take_counts(at);
  at->second.silent.erase(number);
  at->second.asking.erase(number);
  if (at->second.all() == 0)
    addresses_.erase(at);
  else
    put_counts(at);
  addresses_of_.erase(of);
}

ConnectionShares::Count ConnectionShares::silent_of(Addresses::iterator at) {
  const auto& silent = at->second.silent;
  return {silent.size(), silent.empty() ? 0 : *silent.begin(), at};
}

ConnectionShares::Count ConnectionShares::all_of(Addresses::iterator at) {
  const auto& asking = at->second.asking;
  return {at->second.all(), asking.empty() ? 0 : *asking.begin(), at};
}

void ConnectionShares::take_counts(Addresses::iterator at) {
  silent_.erase(silent_of(at));
  most_.erase(all_of(at));
}

void ConnectionShares::put_counts(Addresses::iterator at) {
  silent_.insert(silent_of(at));
  most_.insert(all_of(at));
}

}  // namespace onggi::web
