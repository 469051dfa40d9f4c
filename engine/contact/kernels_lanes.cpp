#include "engine/contact/kernels.h"
#include "engine/contact/window_lanes.h"

namespace onggi::ONGGI_LANES {

// One in each body's file.
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

void measure_extent(int stride, const float* outer, const float* inner, float* outer_most,
                    float* inner_least) {
  Float8 most = all(0.0f);
  Float8 least = all(1e9f);
  for (int i = 0; i < stride; i += kLanes) {
    most = larger(load(outer + i), most);
    least = smaller(load(inner + i), least);
  }
  *outer_most = largest(most);
  *inner_least = smallest(least);
}

}  // namespace

extern const contact::Kernels kContactKernels{&kBall,       &kCapsule,    &kBox,         &kCylinder,
                                              ball_windows, half_windows, measure_extent};

}  // namespace onggi::ONGGI_LANES
