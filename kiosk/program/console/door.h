#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "engine/base/result.h"
#include "kiosk/ground/web/message.h"

namespace onggi::console {

/// Who may see the staff's page: whoever came with the code of the address that the program
/// printed. The code is good once. It gives a session, kept by a cookie that no script and no other
/// site can use: 12 hours, or until 30 minutes passed without a request. Sessions end with the
/// process. One thread.
class Door {
 public:
  static constexpr std::int64_t kLongest = 12 * 3600, kIdle = 30 * 60;  // s

  /// `cookie`: its cookie's name. Browsers keep cookies by host, whatever its port, so two programs
  /// on one machine need two names. Problem, exit 1: no randomness.
  static Result<Door> make(std::string cookie);

  /// The code that opens it now.
  const std::string& code() const { return code_; }
  /// Takes the code. Empty if it is not this one; else the new session's Set-Cookie, and there is
  /// another code, which nobody has seen.
  std::string enter(const std::string& code, std::int64_t now);
  /// True if `ask` is of a session, which then goes on.
  bool knows(const web::Ask& ask, std::int64_t now);
  /// Ends the session of `ask`. Returns the Set-Cookie that forgets it.
  std::string leave(const web::Ask& ask);

 private:
  struct Session {
    std::int64_t from = 0, seen = 0;
  };
  Door(std::string cookie, std::string code) : cookie_(std::move(cookie)), code_(std::move(code)) {}
  std::string set_cookie(const std::string& token, std::int64_t seconds) const;

  std::string cookie_, code_;
  std::map<std::string, Session> sessions_;  // by token
};

/// The value of cookie `name` in the Cookie field `cookies`; "" if it is not there.
std::string cookie_of(std::string_view cookies, std::string_view name);

/// True if both are the same; takes as long wherever they differ.
bool same_secret(std::string_view a, std::string_view b);

}  // namespace onggi::console
