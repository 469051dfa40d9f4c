#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "kiosk/keepsake/phone/phone_words.h"
#include "kiosk/keepsake/souvenir/pass.h"

namespace onggi::phone {

/// What a phone asks for.
struct Ask {
  std::string method, target;  ///< "GET", "/k/TOKEN"
  std::string languages{};     ///< Accept-Language
};

/// What it gets.
struct Answer {
  int status = 404;
  std::string type = "text/html; charset=utf-8";
  std::string body{};
  std::string file_name{};  ///< Not empty: to be saved under this name.
};

/// The visitor's page and what belongs to it:
///   GET  /k/TOKEN               the page: postcard, pot that turns, what to take, delete; in the
///                               visit's language, or that of ?lang=CODE
///   GET  /k/TOKEN/postcard.jpg, turning.gif, pot.glb, pot.stl
///   POST /k/TOKEN/delete        every copy goes, at once
///   GET  /page.js, .css, .svg   the same for everybody
///   GET  /generate_204 ...      what a phone asks of a network that it has joined (probes.h)
/// Whatever else is asked, a wrong, an expired and a deleted token too, gets one and the same
/// answer. Knows no socket. One thread.
class Answers {
 public:
  /// `clock` gives s since 1970.
  Answers(souvenir::Passes passes, std::function<std::int64_t()> clock,
          PhoneLanguages languages = {})
      : passes_(std::move(passes)), clock_(std::move(clock)), languages_(std::move(languages)) {}

  Answer to(const Ask& ask) const;
  /// At least once a minute: says that phones are answered, and passes that have expired go.
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
