#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "kiosk/ground/files/local_time.h"

namespace onggi::settings {

/// When the museum is open, by the clock on its wall: minutes are labels of a day, so that the days
/// on which clocks are put forward or back open and close at the hours that are written.
struct Hours {
  /// In minutes after midnight, `from` included. One whose `until` is not after `from` goes on into
  /// the next day.
  struct Span {
    int from = 0;         ///< 0..1439
    int until = 24 * 60;  ///< 0..1440
    friend bool operator==(const Span&, const Span&) = default;
  };
  using Spans = std::vector<Span>;  ///< None: closed.

  bool kept = false;                        ///< false: it is always open.
  std::array<Spans, 7> week{};              ///< Monday first.
  std::map<std::string, Spans> exceptions;  ///< By "2026-12-24", or "12-24" of every year.
  bool screen_off = true;                   ///< Outside of them the monitor sleeps; else black.

  /// Whether it is open at `at`.
  bool open_at(const files::LocalMoment& at) const;
};

/// "10:00-18:00", "10:00-12:30, 14:00-24:00" or "closed", into `spans`; false where it is none of
/// them.
bool read_spans(const std::string& text, Hours::Spans& spans);
/// A date as the keys of Hours::exceptions write it.
bool is_date(const std::string& text);

}  // namespace onggi::settings
