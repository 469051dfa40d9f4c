#include "kiosk/program/console/door.h"

#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
#include <span>
#include <sstream>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/ground/secrets/digest.h"
#include "kiosk/keepsake/souvenir/pass.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;
using secrets::digest_of;
using secrets::same_secret;

constexpr std::size_t kMostSessions = 1024;
constexpr std::ptrdiff_t kMostOfOne = 8;
constexpr std::size_t kMostOfACode = 1024;  // bytes of its file

fs::path code_file(const fs::path& state) { return state / "code"; }
fs::path used_file(const fs::path& state) { return state / "used"; }

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

std::string Door::set_cookie(const std::string& token, std::int64_t seconds) const {
  return cookie_ + '=' + token + (cookie_.starts_with("__Host-") ? "; Secure" : "") +
         "; Path=/; HttpOnly; SameSite=Strict; Max-Age=" + std::to_string(seconds);
}

Result<Door> Door::make(std::string cookie, fs::path state, std::int64_t now) {
  auto code = souvenir::Passes::new_token();
  if (!code) return tl::unexpected(code.error());
  return Door(std::move(cookie), std::move(state), std::move(*code), now);
}

files::Descriptor Door::serve(const fs::path& state) {
  files::Descriptor file(
      ::open((state / "serving").c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
  if (file.open()) static_cast<void>(::flock(file.get(), LOCK_SH | LOCK_NB));
  return file;
}

bool Door::served(const fs::path& state) {
  const files::Descriptor file(
      ::open((state / "serving").c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  return file.open() && ::flock(file.get(), LOCK_EX | LOCK_NB) != 0;
}

Result<std::string> Door::give_code(const fs::path& state, std::int64_t now) {
  auto code = souvenir::Passes::new_token();
  if (!code) return code;
  const std::string text = digest_of(*code) + ' ' + std::to_string(now + kCodeLasts) + '\n';
  if (auto written = files::write_durably(code_file(state), std::as_bytes(std::span(text)));
      !written)
    return tl::unexpected(written.error());
  return code;
}

bool Door::take_given(const std::string& code, std::int64_t now) const {
  const auto bytes = files::read_file(code_file(state_), kMostOfACode);
  if (!bytes) return false;
  std::istringstream words(std::string(bytes->begin(), bytes->end()));
  std::string digest;
  std::int64_t until = 0;
  words >> digest >> until;
  // One that lasts longer than any was given while the clock was ahead.
  if (!same_secret(digest, digest_of(code)) || now >= until || until - now > kCodeLasts)
    return false;
  std::error_code error;
  return fs::remove(code_file(state_), error);  // good once, or not at all
}

bool Door::use_once(const std::string& digest) const {
  const auto known = files::read_file(used_file(state_), kMostOfACode);
  if (known && std::string(known->begin(), known->end()) == digest) return false;
  return files::write_durably(used_file(state_), std::as_bytes(std::span(digest))).has_value();
}

std::string Door::enter(const std::string& code, std::int64_t now) {
  const bool printed = same_secret(code, code_) && now - made_ < kCodeLasts;
  if (!printed && !take_given(code, now)) return {};
  auto next = souvenir::Passes::new_token();
  if (!next) return {};
  if (printed) code_ = std::move(*next);
  return admit(Session::kByCode, Role::editor, now);
}

std::string Door::admit(const std::string& who, Role role, std::int64_t now) {
  auto token = souvenir::Passes::new_token();
  auto more = souvenir::Passes::new_token();  // together 256 bits and more
  if (!token || !more) return {};
  // Nobody's browsers, dropping their cookies, put out others.
  const auto drop_oldest = [this](const auto& which) {
    auto oldest = sessions_.end();
    for (auto it = sessions_.begin(); it != sessions_.end(); ++it)
      if (which(it->second) && (oldest == sessions_.end() || it->second.seen < oldest->second.seen))
        oldest = it;
    if (oldest != sessions_.end()) sessions_.erase(oldest);
  };
  const auto of_who = [&who](const Session& one) { return one.who == who; };
  if (std::ranges::count_if(sessions_, [&](const auto& one) { return of_who(one.second); }) >=
      kMostOfOne)
    drop_oldest(of_who);
  if (sessions_.size() >= kMostSessions) drop_oldest([](const Session&) { return true; });
  const std::string whole = *token + *more;
  sessions_[whole] = {who, role, now, now};
  return set_cookie(whole, kLongest);
}

const Session* Door::session_of(const web::Ask& ask, std::int64_t now, bool by_itself) {
  std::erase_if(sessions_, [now](const auto& one) {
    // Nor does a clock that was set back make it last longer.
    return now - one.second.from >= kLongest || now - one.second.seen >= kIdle ||
           one.second.seen - now >= kIdle;
  });
  const std::string token = cookie_of(ask.cookie, cookie_);
  for (auto& [known, session] : sessions_)
    if (same_secret(known, token)) {
      if (!by_itself) session.seen = now;
      return &session;
    }
  return nullptr;
}

std::string Door::leave(const web::Ask& ask) {
  sessions_.erase(cookie_of(ask.cookie, cookie_));
  return set_cookie("gone", 0);
}

void Door::end_all_of(const std::string& who) {
  std::erase_if(sessions_, [&who](const auto& one) { return one.second.who == who; });
}

}  // namespace onggi::console
