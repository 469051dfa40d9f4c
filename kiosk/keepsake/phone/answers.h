#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "kiosk/keepsake/phone/phone_words.h"
#include "kiosk/keepsake/souvenir/pass.h"

namespace onggi::phone {

/// A phone's request.
struct Ask {
  std::string method, target;  ///< "GET", "/k/TOKEN"
  std::string languages{};     ///< Accept-Language
};

/// The answer to it.
struct Answer {
  int status = 404;
  std::string type = "text/html; charset=utf-8";
  std::string body{};
  std::string file_name{};  ///< If not empty: the file is saved under this name.
};

/// The visitor's page and its files:
///   GET  /k/TOKEN               the page: postcard, turning pot, downloads, delete; in the
///                               visit's language, or that of ?lang=CODE
///   GET  /k/TOKEN/postcard.jpg, turning.gif, pot.glb, pot.stl
///   POST /k/TOKEN/delete        removes every copy at once
///   GET  /page.js, .css, .svg   the same for everybody
///   GET  /generate_204 ...      network checks of phones (probes.h)
/// All other requests, also with a wrong, expired or deleted token, get the same answer. Uses no
/// socket. One thread.
class Answers {
 public:
  /// `clock` gives s since 1970.
  Answers(souvenir::Passes passes, std::function<std::int64_t()> clock,
          PhoneLanguages languages = {})
      : passes_(std::move(passes)), clock_(std::move(clock)), languages_(std::move(languages)) {}

  Answer to(const Ask& ask) const;
  /// Call it at least once a minute: records that the server runs, and removes expired passes.
  void look_after() const {
    passes_.serve();
    passes_.forget(clock_());
  }
  void end() const { passes_.end_serving(); }

 private:
  Answer nothing_here(const Ask& ask) const;

  souvenir::Passes passes_;
  std::function<std::int64_t()> clock_;
  PhoneLanguages languages_;
};

}  // namespace onggi::phone
