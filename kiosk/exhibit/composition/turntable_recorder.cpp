#include "kiosk/exhibit/composition/turntable_recorder.h"

#include <utility>

#include "engine/math/portable.h"

namespace onggi::exhibit {

void TurntableRecorder::begin(int ticket, const encoding::Caption& caption, const Profile& made,
                              const std::optional<view::Glazing>& glazing, const ClayView& clay,
                              bool left_handed) {
  constexpr float kMargin = 0.09f * kSide;
  drawn_ = {ticket, caption, {kSide, kSide, 0, kTurn, {}}};
  clay_ = clay.change();
  step_ = (left_handed ? -2.0 : 2.0) * portable::kPi / kPictures;
  frame_ = {};
  frame_.width = frame_.height = kSide;
  view::PotView pot;
  pot.camera =
      view::frame_pot(kSide, kSide, {kMargin, kMargin, kSide - 2 * kMargin, kSide - 2.2f * kMargin},
                      made.height(), made.max_radius());
  pot.wheel = false;
  if (glazing) {
    pot.finish = view::Finish::fired;
    pot.glazing = *glazing;
  }
  frame_.pot = pot;
}

std::optional<TurntableRecorder::Drawn> TurntableRecorder::draw(const ClayView& clay,
                                                                render::Renderer& renderer) {
  if (!drawing()) return std::nullopt;
  if (clay.change() != clay_) {
    stop();
    return std::nullopt;
  }
  encoding::Turning& turning = drawn_.turning;
  frame_.pot->clay_angle = step_ * turning.frames;
  const view::Image picture = renderer.draw_offscreen(frame_);
  // 26 MB: growing by doubling would take 41 and copy them during frames.
  turning.rgba.reserve(kPictures * picture.rgba.size());
  turning.rgba.insert(turning.rgba.end(), picture.rgba.begin(), picture.rgba.end());
  if (++turning.frames < kPictures) return std::nullopt;
  return std::exchange(drawn_, {});
}

}  // namespace onggi::exhibit
