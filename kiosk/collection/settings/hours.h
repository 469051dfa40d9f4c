#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "kiosk/ground/files/local_time.h"

namespace onggi::settings {

/// When the museum is open, by the local clock. Minutes are clock readings, so opening hours also
/// hold on days when the clocks change.
struct Hours {
  /// In minutes after midnight, `from` included. If `until` is not after `from`, the span continues
  /// into the next day.
  struct Span {
    int from = 0;         ///< 0..1439
    int until = 24 * 60;  ///< 0..1440
    friend bool operator==(const Span&, const Span&) = default;
  };
  using Spans = std::vector<Span>;  ///< None: closed.

  bool kept = false;                        ///< False: always open.
  std::array<Spans, 7> week{};              ///< Monday first.
  std::map<std::string, Spans> exceptions;  ///< By "2026-12-24", or "12-24" for every year.
  bool screen_off = true;  ///< Outside the hours the monitor sleeps; else it is black.

  /// True if the museum is open at `at`.
  bool open_at(const files::LocalMoment& at) const;
};

/// Reads "10:00-18:00", "10:00-12:30, 14:00-24:00" or "closed" into `spans`; false for other text.
bool read_spans(const std::string& text, Hours::Spans& spans);
/// True for a date in the form of Hours::exceptions' keys.
bool is_date(const std::string& text);

}  // namespace onggi::settings
