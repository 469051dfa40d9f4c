#include "kiosk/visit/access/scan.h"

#include <algorithm>
#include <utility>

#include "kiosk/visit/screens/focus.h"

namespace onggi::access {

using screens::Control;
using screens::ScreenText;

bool Scan::changed(const ScreenText& reading) {
  std::vector<std::string> ids;
  for (const Control& control : reading.controls) ids.push_back(control.id);
  std::string screen = std::string(name_of(reading.screen)) + reading.over;
  if (ids == ids_ && screen == screen_) return false;
  const bool same_screen = screen == screen_ && !ids_.empty();
  const std::string was = same_screen && !shown_.empty() ? shown_.front() : std::string();
  ids_ = std::move(ids);
  screen_ = std::move(screen);
  rows_ = screens::rows_of(reading.controls, reading.language->right_to_left());
  row_ = item_ = 0;
  // If only other controls came or went, keep the current place.
  const auto row_with = [&](const std::string& id) {
    return std::find_if(rows_.begin(), rows_.end(), [&](const auto& row) {
      return std::any_of(row.begin(), row.end(),
                         [&](std::size_t i) { return reading.controls[i].id == id; });
    });
  };
  auto at = was.empty() ? rows_.end() : row_with(was);
  const bool kept = at != rows_.end();
  if (!kept) at = row_with(reading.first);
  if (at != rows_.end()) row_ = static_cast<std::size_t>(at - rows_.begin());
  if (kept && in_row_) {
    const auto item = std::find_if(at->begin(), at->end(),
                                   [&](std::size_t i) { return reading.controls[i].id == was; });
    item_ = static_cast<std::size_t>(item - at->begin());
    return false;
  }
  in_row_ = false;
  return !kept;
}

void Scan::show(const ScreenText& reading, double now) {
  since_ = now;
  shown_.clear();
  if (rows_.empty()) return;
  const auto& row = rows_[row_];
  if (in_row_)
    shown_.push_back(reading.controls[row[item_]].id);
  else
    for (const std::size_t i : row) shown_.push_back(reading.controls[i].id);
}

void Scan::look(const ScreenText& reading, double now) {
  if (changed(reading)) {
    fresh_ = true;
    return show(reading, now);
  }
  if (rows_.empty()) return;
  if (now - since_ < reading.scan_seconds * (fresh_ ? kFirst : 1.0)) return;
  fresh_ = false;
  if (!in_row_) {
    row_ = (row_ + 1) % rows_.size();
  } else if (++item_ >= rows_[row_].size()) {
    item_ = 0;
    if (++rounds_ >= kRounds) in_row_ = false;
  }
  show(reading, now);
}

std::optional<std::string> Scan::press(const ScreenText& reading, double now) {
  if (now - pressed_at_ < kTremble) return std::nullopt;
  pressed_at_ = now;
  if (changed(reading)) {  // The choices have changed, so ignore the press.
    fresh_ = true;
    show(reading, now);
    return std::nullopt;
  }
  if (rows_.empty()) return std::nullopt;
  const bool alone = rows_[row_].size() == 1;
  fresh_ = true;
  if (!in_row_ && !alone) {
    in_row_ = true;
    item_ = 0;
    rounds_ = 0;
    show(reading, now);
    return std::nullopt;
  }
  const Control& chosen = reading.controls[rows_[row_][in_row_ ? item_ : 0]];
  in_row_ = false;
  // After a setting continue with the next row. After an action start again.
  if (chosen.on)
    row_ = (row_ + 1) % rows_.size();
  else
    for (std::size_t r = 0; r < rows_.size(); ++r)
      for (const std::size_t i : rows_[r])
        if (reading.controls[i].id == reading.first) row_ = r;
  show(reading, now);
  return chosen.id;
}

}  // namespace onggi::access
