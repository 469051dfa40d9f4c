#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "engine/base/result.h"
#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/web/message.h"
#include "kiosk/program/console/people.h"

namespace onggi::console {

/// Who is here: somebody of the staff, or whoever came by a code from the machine's own terminal.
struct Session {
  std::string who;  ///< A person's name; kByCode.
  Role role = Role::editor;
  std::int64_t from = 0, seen = 0;  ///< s since 1970.
  static constexpr const char* kByCode = "(code)";
};

/// The sessions of the staff's page, and the codes that open one without a name: for the first who
/// comes, and for who forgot a passphrase. A code is good once. A session is kept by a cookie that
/// no script and no other site can use: 12 hours, or until 30 minutes passed without a request.
/// Sessions end with the process. One thread.
class Door {
 public:
  static constexpr std::int64_t kLongest = 12 * 3600, kIdle = 30 * 60;  // s
  static constexpr std::int64_t kCodeLasts = 3600;                      ///< s

  /// `cookie`: its cookie's name. Browsers keep cookies by host, whatever its port, so two programs
  /// on one machine need two names. One that begins with "__Host-" is for HTTPS alone. `state`: the
  /// program's state folder. Problem, exit 1: no randomness.
  static Result<Door> make(std::string cookie, std::filesystem::path state, std::int64_t now);

  /// The code that opens it now, until it was used or kCodeLasts are over.
  const std::string& code() const { return code_; }
  /// Held while a program serves the page with this state folder, so that served() is true: a code
  /// for a page that nobody serves would open nothing.
  static files::Descriptor serve(const std::filesystem::path& state);
  static bool served(const std::filesystem::path& state);
  /// Another code for the program that serves `state`, given by another process: only its hash is
  /// on the disk. It replaces the one given before. Problem, exit 1: the disk.
  static Result<std::string> give_code(const std::filesystem::path& state, std::int64_t now);

  /// True the first time for `digest`, also after the program was started anew; false where that
  /// cannot be kept. Only the last one is known.
  bool use_once(const std::string& digest) const;
  /// Takes a code: the Set-Cookie of the new session; empty if it is none.
  std::string enter(const std::string& code, std::int64_t now);
  /// Begins a session of `who`, whose passphrase was right: its Set-Cookie; empty: no randomness.
  std::string admit(const std::string& who, Role role, std::int64_t now);
  /// The session of `ask`, which then goes on, unless the page asked `by_itself`; null: none.
  const Session* session_of(const web::Ask& ask, std::int64_t now, bool by_itself = false);
  /// Ends the session of `ask`. Returns the Set-Cookie that forgets it.
  std::string leave(const web::Ask& ask);
  /// Ends every session of `who`.
  void end_all_of(const std::string& who);

 private:
  Door(std::string cookie, std::filesystem::path state, std::string code, std::int64_t now)
      : cookie_(std::move(cookie)), state_(std::move(state)), code_(std::move(code)), made_(now) {}
  std::string set_cookie(const std::string& token, std::int64_t seconds) const;
  bool take_given(const std::string& code, std::int64_t now) const;

  std::string cookie_;
  std::filesystem::path state_;
  std::string code_;
  std::int64_t made_ = 0;
  std::map<std::string, Session> sessions_;  // by token
};

/// The value of cookie `name` in the Cookie field `cookies`; "" if it is not there.
std::string cookie_of(std::string_view cookies, std::string_view name);

}  // namespace onggi::console
