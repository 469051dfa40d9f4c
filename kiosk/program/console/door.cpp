#include "kiosk/program/console/door.h"

#include <algorithm>
#include <utility>

#include "kiosk/keepsake/souvenir/pass.h"

namespace onggi::console {

namespace {

// A browser that drops its cookie at each request shall not fill the memory.
constexpr std::size_t kMostSessions = 64;

}  // namespace

std::string cookie_of(std::string_view cookies, std::string_view name) {
  while (!cookies.empty()) {
    const std::size_t end = std::min(cookies.find(';'), cookies.size());
    std::string_view one = cookies.substr(0, end);
    cookies.remove_prefix(std::min(end + 1, cookies.size()));
    while (one.starts_with(' ')) one.remove_prefix(1);
    if (one.size() > name.size() && one.starts_with(name) && one[name.size()] == '=')
      return std::string(one.substr(name.size() + 1));
  }
  return {};
}

bool same_secret(std::string_view a, std::string_view b) {
  unsigned differs = a.size() == b.size() ? 0u : 1u;
  for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n)
    differs |= static_cast<unsigned>(static_cast<unsigned char>(a[n] ^ b[n]));
  return differs == 0;
}

std::string Door::set_cookie(const std::string& token, std::int64_t seconds) const {
  return cookie_ + '=' + token +
         "; Path=/; HttpOnly; SameSite=Strict; Max-Age=" + std::to_string(seconds);
}

Result<Door> Door::make(std::string cookie) {
  auto code = souvenir::Passes::new_token();
  if (!code) return tl::unexpected(code.error());
  return Door(std::move(cookie), std::move(*code));
}

std::string Door::enter(const std::string& code, std::int64_t now) {
  if (!same_secret(code, code_)) return {};
  auto next = souvenir::Passes::new_token();
  auto token = souvenir::Passes::new_token();
  // Two: 256 bits.
  auto more = souvenir::Passes::new_token();
  if (!next || !token || !more) return {};
  code_ = std::move(*next);
  if (sessions_.size() >= kMostSessions)
    sessions_.erase(std::min_element(sessions_.begin(), sessions_.end(), [](auto& a, auto& b) {
      return a.second.seen < b.second.seen;
    }));
  const std::string whole = *token + *more;
  sessions_[whole] = {now, now};
  return set_cookie(whole, kLongest);
}

bool Door::knows(const web::Ask& ask, std::int64_t now) {
  std::erase_if(sessions_, [now](const auto& one) {
    return now - one.second.from >= kLongest || now - one.second.seen >= kIdle;
  });
  const std::string token = cookie_of(ask.cookie, cookie_);
  for (auto& [known, session] : sessions_)
    if (same_secret(known, token)) return session.seen = now, true;
  return false;
}

std::string Door::leave(const web::Ask& ask) {
  sessions_.erase(cookie_of(ask.cookie, cookie_));
  return set_cookie("gone", 0);
}

}  // namespace onggi::console
