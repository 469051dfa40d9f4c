#include "kiosk/exhibit/composition/night.h"

namespace onggi::exhibit {

bool Night::look(double now, const files::LocalMoment& wall, bool nobody, bool touched) {
  if (touched) touched_at_ = now;
  const bool open = wall.year < files::kFirstYear || hours_.open_at(wall);
  const bool awake = touched_at_ && now - *touched_at_ < kAwake;
  // Do not interrupt a visitor at closing time.
  dark_ = !open && nobody && !awake;
  return dark_;
}

}  // namespace onggi::exhibit
