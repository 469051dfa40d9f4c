#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace onggi::screens {

enum class ScreenId { attract, choose, throwing, result, kiln, keepsake, fault };
std::string_view name_of(
    ScreenId id);  ///< "attract", "choose", "throw", "result", "kiln", "keepsake", "fault"

/// What may be counted of a visit once it is over. Nothing of who it was.
struct VisitNotes {
  enum class End : std::uint8_t { finished, back, idle, fault, closed };
  double since_s = 0.0;                 ///< From the first touch to now.
  double active_s = 0.0;                ///< From the first touch to the last.
  double throwing_s = 0.0;              ///< Of them at the wheel.
  int pots = 0;                         ///< Lumps begun.
  int card = -1;                        ///< Of the shelf: the vessel chosen last; -1: none.
  ScreenId reached = ScreenId::choose;  ///< The furthest but the fault.
  ScreenId left = ScreenId::choose;     ///< The last.
  End end = End::back;
  std::string mission{};           ///< Id of what was chosen last to be done; "": a vessel alone.
  std::string language;            ///< Its code, at the end.
  std::string way;                 ///< "touch", "mouse", "keys", or the device that moved a hand.
  std::optional<double> likeness;  ///< 0..100, of the last pot that was called done.
};
std::string_view name_of(VisitNotes::End end);  ///< "finished", "back", "idle", "fault", "closed"

/// Takes those notes while the visit lasts. Knows no clock: seconds come in, on one that never goes
/// back. Main thread.
class NoteTaker {
 public:
  enum class By : std::uint8_t { nothing, glass, mouse, keys };

  /// To `screen`, never attract. The visit begins at the first but the fault: a fault that nobody
  /// sees is no visit.
  void enter(ScreenId screen, double now);
  /// Somebody touched something; not for idle time.
  void touch(By by, double now);
  /// A device moved a hand.
  void device(std::string_view kind, double now);
  void pot() { ++notes_.pots; }
  void judged(double likeness) { notes_.likeness = likeness; }
  /// The visit is over, and the next one begins with nothing. `how`: idle or closed; back: the
  /// visitor went, and where to is told by the screen. Nothing where no visit had begun.
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
