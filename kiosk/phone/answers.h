#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "kiosk/souvenir/pass.h"

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
///   GET  /k/TOKEN               the page: postcard, pot that turns, what to take, delete
///   GET  /k/TOKEN/postcard.jpg, pot.glb, pot.stl
///   POST /k/TOKEN/delete        every copy goes, at once
///   GET  /page.js, /page.css    the same for everybody
/// Whatever else is asked, a wrong, an expired and a deleted token too, gets one and the same
/// answer. Knows no socket. One thread.
class Answers {
 public:
  /// `clock` gives s since 1970.
  Answers(souvenir::Passes passes, std::function<std::int64_t()> clock)
      : passes_(std::move(passes)), clock_(std::move(clock)) {}

  Answer to(const Ask& ask) const;
  /// At least once a minute: says that phones are answered, and passes that have expired go.
  void look_after() const {
    passes_.serve();
    passes_.forget(clock_());
  }
  void end() const { passes_.end_serving(); }

 private:
  souvenir::Passes passes_;
  std::function<std::int64_t()> clock_;
};

}  // namespace onggi::phone
