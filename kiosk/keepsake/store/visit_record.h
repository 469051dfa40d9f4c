#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace onggi::store {

/// What is counted of a visit. Nothing in it says who it was: no name, no picture, no address, and
/// when it began only to the quarter of an hour.
struct VisitRecord {
  std::int64_t start = 0;   ///< s since 1970, UTC; kept as the quarter of an hour it lies in.
  std::string day;          ///< Where the kiosk stands: "2026-05-04".
  int hour = 0;             ///< Likewise, 0..23.
  std::string vessel;       ///< On the shelf; "": none was chosen.
  std::string scene;        ///< File name of the scene it was thrown in; "" likewise.
  std::string language;     ///< Code in use at the end.
  std::string way;          ///< How they played: "touch", "mouse", "keys", or a device's kind.
  std::string reached;      ///< The furthest screen: "choose", "throw", "result"...
  std::string left;         ///< The last one.
  std::string ended;        ///< "finished", "back", "idle", "fault", or "closed" with the program.
  double active_s = 0.0;    ///< First touch to last, never the idle tail.
  double throwing_s = 0.0;  ///< Of them at the wheel.
  int pots = 0;             ///< Lumps that were begun.
  std::optional<double> likeness;  ///< 0..100, of the last pot that was called done.
  bool kept = false;               ///< A keepsake is on the disk.
  std::string mission{};           ///< Id of what was to be done; "": a vessel, and that was all.
  friend bool operator==(const VisitRecord&, const VisitRecord&) = default;
};

}  // namespace onggi::store
