#include "engine/contact/kernels.h"
#include "engine/contact/window_lanes.h"

namespace onggi::ONGGI_LANES {

// Each is defined in its body's file.
extern const contact::BodyKernel<body::Ball> kBall;
extern const contact::BodyKernel<body::Capsule> kCapsule;
extern const contact::BodyKernel<body::Box> kBox;
extern const contact::BodyKernel<body::Cylinder> kCylinder;

namespace {

void ball_windows(WallSide side, const contact::WindowFigures& figures, int count,
                  contact::BallWindows& rows) {
  if (side == WallSide::outside)
    ball_windows_of<WallSide::outside>(figures, count, rows);
  else
    ball_windows_of<WallSide::inside>(figures, count, rows);
}

void half_windows(WallSide side, const float* d, const float* r, const float* t,
                  const float* extent, float* half) {
  store(side == WallSide::outside
            ? half_window<WallSide::outside>(load(d), load(r), load(t), load(extent))
            : half_window<WallSide::inside>(load(d), load(r), load(t), load(extent)),
        half);
}

float outer_extent(int stride, const float* outer) {
  Float8 most[2] = {all(0.0f), all(0.0f)};  // two, because one would wait for its own last result
  int i = 0;
  for (; i + 2 * kLanes <= stride; i += 2 * kLanes) {
    most[0] = larger(load(outer + i), most[0]);
    most[1] = larger(load(outer + i + kLanes), most[1]);
  }
  if (i < stride) most[0] = larger(load(outer + i), most[0]);
  return largest(larger(most[0], most[1]));
}

float inner_extent(int stride, const float* inner) {
  Float8 least[2] = {all(1e9f), all(1e9f)};
  int i = 0;
  for (; i + 2 * kLanes <= stride; i += 2 * kLanes) {
    least[0] = smaller(load(inner + i), least[0]);
    least[1] = smaller(load(inner + i + kLanes), least[1]);
  }
  if (i < stride) least[0] = smaller(load(inner + i), least[0]);
  return smallest(smaller(least[0], least[1]));
}

float extent_of(WallSide side, int stride, const float* face) {
  return side == WallSide::outside ? outer_extent(stride, face) : inner_extent(stride, face);
}

}  // namespace

extern const contact::Kernels kContactKernels{&kBall,       &kCapsule,    &kBox,    &kCylinder,
                                              ball_windows, half_windows, extent_of};

}  // namespace onggi::ONGGI_LANES
