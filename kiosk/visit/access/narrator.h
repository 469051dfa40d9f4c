#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kiosk/visit/access/utterance.h"

namespace onggi::access {

/// What is said of what is on the screen, and when: a page when it comes, the control that the
/// keyboard or the switch is on, how the pot differs when a stroke is done or somebody asks, and
/// news, no more often than every four seconds. Nothing twice while nothing changed, nothing in
/// attract. Knows no voice, clock or visit. Main thread.
class Narrator {
 public:
  static constexpr double kNews = 4.0;    ///< s between two pieces of news.
  static constexpr double kCount = 10.0;  ///< s between two words of a countdown.

  /// Once a frame. `shown`: what one switch stands on, ids of controls; none without it.
  std::optional<Utterance> look(const screens::Reading& reading,
                                const std::vector<std::string>& shown, double now);
  /// Somebody asks where they are: the page is said again.
  void again() { again_ = true; }
  /// Something is being said, as far as one knows.
  bool speaks(double now) const { return under_way_ != 0 && now < until_; }
  /// A visitor is still holding: says first that holding on brings one switch.
  void hold_on() { hold_on_ = true; }
  /// The voice has said it, or ended it.
  void ended(std::uint64_t id);
  /// The visitor has gone.
  void forget() { *this = Narrator(said_); }
  explicit Narrator(std::uint64_t said = 0) : said_(said) {}

 private:
  struct Wish {
    std::string text;
    int weight = 0;
  };
  Wish wish(const screens::Reading& reading, const std::vector<std::string>& shown, double now);
  bool another_page(const screens::Reading& reading) const;
  std::string page(const screens::Reading& reading) const;
  std::string focus(const screens::Reading& reading, const std::vector<std::string>& shown) const;
  std::string standing_of(const screens::Reading& reading,
                          const std::vector<std::string>& shown) const;
  std::string news(const screens::Reading& reading, double now);

  std::uint64_t said_ = 0;
  std::string place_;                ///< Screen, what lies over it, and language.
  std::set<std::string> controls_;   ///< Of the page that was said.
  std::set<std::string> sentences_;  ///< That were said of it; figures left out.
  std::string focus_;                ///< standing_of() what was said.
  int asked_ = 0;
  bool begun_ = false, again_ = false, working_ = false, hold_on_ = false;
  double news_at_ = -100, counted_at_ = -100;
  std::string waiting_;  ///< News that found something weightier being said.
  std::uint64_t under_way_ = 0;
  int weight_ = 0;
  double until_ = -1;  ///< When it is over at the latest, if nobody says so.
};

}  // namespace onggi::access
