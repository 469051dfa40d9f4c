#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace onggi::screens {

/// In the order of a visit; a row each in screen_kind.cpp.
enum class ScreenId { attract, clay, choose, throwing, result, decorate, kiln, keepsake, fault };
std::string_view name_of(ScreenId id);  ///< ScreenKind::name: "throw", "kiln"

/// The countable facts of a finished visit, without anything about the visitor.
struct VisitNotes {
  enum class End : std::uint8_t { finished, back, idle, fault, closed };
  double since_s = 0.0;               ///< From the first touch to now.
  double active_s = 0.0;              ///< From the first touch to the last.
  double throwing_s = 0.0;            ///< Part of it at the wheel.
  int pots = 0;                       ///< Pots begun.
  int card = -1;                      ///< On the shelf: the last chosen vessel; -1: none.
  bool built = false;                 ///< It was built of coils.
  ScreenId reached = ScreenId::clay;  ///< The furthest screen, not counting the fault screen.
  ScreenId left = ScreenId::choose;   ///< The last screen.
  End end = End::back;
  std::string mission{};  ///< Id of the last chosen mission; "" if only a vessel was chosen.
  std::string language;   ///< Language code at the end.
  std::string way;        ///< "touch", "mouse", "keys", or the device that moved a hand.
  std::optional<double> likeness;  ///< 0..100, for the last pot that was called done.
};
std::string_view name_of(VisitNotes::End end);  ///< "finished", "back", "idle", "fault", "closed"

/// Takes notes during the visit. It has no clock: the caller passes seconds on a clock that never
/// goes back. Main thread.
class NoteTaker {
 public:
  enum class By : std::uint8_t { nothing, glass, mouse, keys };

  /// The visit goes to `screen`, never attract. A visit begins at its first screen other than the
  /// fault screen, because a fault that nobody sees is not a visit.
  void enter(ScreenId screen, double now);
  /// Call when somebody touched something; idle time needs no call.
  void touch(By by, double now);
  void device(std::string_view kind, double now);
  void pot() { ++notes_.pots; }
  void judged(double likeness) { notes_.likeness = likeness; }
  /// Ends the visit; the next one starts empty. `how`: idle or closed; for back, the last screen
  /// shows how far the visitor came. Nothing if no visit had begun.
  std::optional<VisitNotes> finish(double now, VisitNotes::End how);

 private:
  VisitNotes notes_;
  ScreenId screen_ = ScreenId::attract;
  bool begun_ = false;
  double first_ = 0.0, last_ = 0.0;
  int glass_ = 0, mouse_ = 0, keys_ = 0;
  std::string device_;
};

}  // namespace onggi::screens
