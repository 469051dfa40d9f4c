#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kiosk/visit/access/utterance.h"

namespace onggi::access {

/// Decides what is spoken of the screen, and when: a page when it appears, the control of the
/// keyboard or the switch, the pot's difference after a stroke or on request, and news at most
/// every four seconds. It repeats nothing without a change, and is silent in attract. Knows no
/// voice, clock or visit. Main thread.
class Narrator {
 public:
  static constexpr double kNews = 4.0;    ///< s between two news items.
  static constexpr double kCount = 10.0;  ///< s between two announcements of a countdown.

  /// Call once a frame. `shown`: ids of the controls that the one switch offers; empty without it.
  std::optional<Utterance> look(const screens::ScreenText& reading,
                                const std::vector<std::string>& shown, double now);
  /// The visitor asks where they are: speaks the page again.
  void again() { again_ = true; }
  /// True while something is probably being spoken.
  bool speaks(double now) const { return under_way_ != 0 && now < until_; }
  /// The visitor is still holding: first speaks that holding on brings one switch.
  void hold_on() { hold_on_ = true; }
  /// The voice has finished or dropped it.
  void ended(std::uint64_t id);
  /// The visitor has left.
  void forget() { *this = Narrator(said_); }
  explicit Narrator(std::uint64_t said = 0) : said_(said) {}

 private:
  struct Wish {
    std::string text;
    int weight = 0;
  };
  Wish wish(const screens::ScreenText& reading, const std::vector<std::string>& shown, double now);
  bool another_page(const screens::ScreenText& reading) const;
  std::string page(const screens::ScreenText& reading) const;
  std::string focus(const screens::ScreenText& reading,
                    const std::vector<std::string>& shown) const;
  std::string state_of(const screens::ScreenText& reading,
                       const std::vector<std::string>& shown) const;
  std::string news(const screens::ScreenText& reading, double now);

  std::uint64_t said_ = 0;
  std::string place_;                ///< Screen, overlay and language.
  std::set<std::string> controls_;   ///< Controls of the page that was spoken.
  std::set<std::string> sentences_;  ///< Spoken sentences of that page, without numbers.
  std::string focus_;                ///< The last spoken state_of().
  int asked_ = 0;
  bool begun_ = false, again_ = false, working_ = false, hold_on_ = false;
  double news_at_ = -100, counted_at_ = -100;
  std::string waiting_;  ///< News that waits because something more important was being spoken.
  std::uint64_t under_way_ = 0;
  int weight_ = 0;
  double until_ = -1;  ///< Latest end of the utterance, if no voice reports it.
};

}  // namespace onggi::access
