#include "kiosk/visit/screens/visit_notes.h"

#include <algorithm>
#include <utility>

#include "kiosk/visit/screens/screen_kind.h"

namespace onggi::screens {

std::string_view name_of(ScreenId id) { return kind_of(id).name; }

std::string_view name_of(VisitNotes::End end) {
  switch (end) {
    case VisitNotes::End::finished:
      return "finished";
    case VisitNotes::End::back:
      return "back";
    case VisitNotes::End::idle:
      return "idle";
    case VisitNotes::End::fault:
      return "fault";
    case VisitNotes::End::closed:
      return "closed";
  }
  return "";
}

void NoteTaker::enter(ScreenId screen, double now) {
  screen_ = notes_.left = screen;
  if (screen == ScreenId::fault) return;
  if (!std::exchange(begun_, true)) first_ = last_ = now;
  notes_.reached = std::max(notes_.reached, screen);
}

void NoteTaker::touch(By by, double now) {
  if (!begun_) return;
  glass_ += by == By::glass ? 1 : 0;
  mouse_ += by == By::mouse ? 1 : 0;
  keys_ += by == By::keys ? 1 : 0;
  // From touch to touch: the wait after the last touch does not count.
  const double since = now - std::exchange(last_, now);
  if (screen_ == ScreenId::throwing) notes_.throwing_s += since;
}

void NoteTaker::device(std::string_view kind, double now) {
  touch(By::nothing, now);
  if (screen_ == ScreenId::throwing && !kind.empty()) device_ = kind;
}

std::optional<VisitNotes> NoteTaker::finish(double now, VisitNotes::End how) {
  if (!begun_) {
    *this = NoteTaker();
    return std::nullopt;
  }
  VisitNotes notes = std::exchange(notes_, {});
  notes.since_s = now - first_;
  notes.active_s = last_ - first_;
  if (notes.left == ScreenId::fault)
    notes.end = VisitNotes::End::fault;
  else if (how != VisitNotes::End::back)
    notes.end = how;
  else if (notes.left == ScreenId::keepsake)
    notes.end = VisitNotes::End::finished;
  if (!device_.empty())
    notes.way = device_;
  else if (keys_ > glass_ + mouse_)
    notes.way = "keys";
  else
    notes.way = glass_ > mouse_ ? "touch" : "mouse";
  *this = NoteTaker();
  return notes;
}

}  // namespace onggi::screens
