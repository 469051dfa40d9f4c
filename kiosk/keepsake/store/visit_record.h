#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace onggi::store {

/// The counted facts of a visit. It holds nothing about who it was: no name, no picture, no
/// address, and the start only to the quarter of an hour.
struct VisitRecord {
  std::int64_t start = 0;   ///< s since 1970, UTC, rounded down to the quarter of an hour.
  std::string day;          ///< Local day: "2026-05-04".
  int hour = 0;             ///< Local hour, 0..23.
  std::string vessel;       ///< Its id; "": none was chosen.
  std::string scene;        ///< File name of its scene; "": none.
  std::string language;     ///< Language code at the end.
  std::string way;          ///< "touch", "mouse", "keys", or a device's kind.
  std::string reached;      ///< The furthest screen: "clay", "choose", "throw", "result"...
  std::string left;         ///< The last screen.
  std::string ended;        ///< "finished", "back", "idle", "fault", or "closed" with the program.
  double active_s = 0.0;    ///< First touch to last, without the idle time after it.
  double throwing_s = 0.0;  ///< Part of it at the wheel.
  int pots = 0;             ///< Pots begun.
  std::optional<double> likeness;  ///< 0..100, for the last pot that was called done.
  bool kept = false;               ///< A keepsake is on the disk.
  std::string mission{};           ///< Mission id; "": only a vessel.
  friend bool operator==(const VisitRecord&, const VisitRecord&) = default;
};

}  // namespace onggi::store
