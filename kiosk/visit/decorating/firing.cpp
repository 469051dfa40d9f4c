#include "kiosk/visit/decorating/firing.h"

#include <utility>

namespace onggi::decorating {

namespace {
constexpr double kKilnCoat = 4e-4;  // m of raw glaze: a coat of 1 in the picture
// Pots on the wheel stand for ones up to three times as large. What is drawn on them is smaller by
// that, and glaze must level over a length smaller by that, or a finger's drawing were a fog and a
// shoulder bare. The length goes with the fourth root of time.
constexpr double kOfRealSize = 1.0 / 3.0;
constexpr std::int64_t kAllCells = 1 << 20;
}  // namespace

void Firing::heat(const surface::Surface& surface, const Pot& pot) {
  if (melt_) return;
  surface::MeltDef def;
  def.seconds *= kOfRealSize * kOfRealSize * kOfRealSize * kOfRealSize;
  if (!pot.polished) def.even = kKilnCoat;
  if (auto melt = surface::Melt::begin(surface, def)) melt_.emplace(std::move(*melt));
}

bool Firing::go_on(std::int64_t cells) { return melt_ && !melt_->done() && melt_->go_on(cells); }

void Firing::end() {
  while (melt_ && !melt_->go_on(kAllCells)) {
  }
}

bool Firing::molten(const Pot& pot) const {
  return fired_ && (glassy_ || pot.glazed) && melt_ && melt_->done() && melt_->glazed();
}

void Firing::show(decoration::CoatPicture& picture, const Pot& pot) const {
  picture.fire(fired_, molten(pot) ? &*melt_ : nullptr);
}

double Firing::glaze_at(const surface::Surface& surface, int j, int i, const Pot& pot) const {
  return 1e-9 * (molten(pot) ? melt_->fired(j, i) : surface.glaze(j, i) * surface::kGlazeUnit);
}

void Firing::cool(decoration::CoatPicture& picture) {
  if (!melt_) return;
  picture.fire(fired_);
  melt_.reset();
}

}  // namespace onggi::decorating
