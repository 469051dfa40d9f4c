#include "kiosk/picture/view/camera.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

namespace onggi::view::camera_test {
namespace {

Camera some_camera() {
  Camera camera;
  camera.width = 1280;
  camera.height = 720;
  camera.centre_x = static_cast<float>(*rc::gen::inRange(200, 1100));
  camera.centre_y = static_cast<float>(*rc::gen::inRange(100, 600));
  camera.distance = *rc::gen::inRange(50, 200) * 0.01;
  camera.elevation = *rc::gen::inRange(0, 100) * 0.01;
  camera.azimuth = *rc::gen::inRange(-300, 300) * 0.01;
  return camera;
}

TEST(Camera, SeesItsTargetAtItsCentre) {
  EXPECT_TRUE(rc::check([] {
    const Camera camera = some_camera();
    const auto p = camera.project(camera.target);
    RC_ASSERT(p.has_value());
    RC_ASSERT(std::abs(p->first - camera.centre_x) < 1e-3f);
    RC_ASSERT(std::abs(p->second - camera.centre_y) < 1e-3f);
  }));
}

TEST(Camera, APixelGoesToTheAxisPlaneAndBack) {
  EXPECT_TRUE(rc::check([] {
    const Camera camera = some_camera();
    const double across = *rc::gen::inRange(-100, 100) * 0.001;
    const double height = *rc::gen::inRange(0, 250) * 0.001;
    Vec3 right, up, back;
    camera.basis(right, up, back);
    const auto p = camera.project(right * across + Vec3{0, height, 0});
    RC_ASSERT(p.has_value());
    const Vec2 found = camera.on_axis_plane(p->first, p->second);
    RC_ASSERT(std::abs(found.x - across) < 1e-5);
    RC_ASSERT(std::abs(found.y - height) < 1e-5);
  }));
}

TEST(Camera, APixelOnALevelIsFoundAgain) {
  EXPECT_TRUE(rc::check([] {
    const Camera camera = some_camera();
    const Vec3 there{*rc::gen::inRange(-100, 100) * 0.001, *rc::gen::inRange(0, 100) * 0.001,
                     *rc::gen::inRange(-100, 100) * 0.001};
    const auto p = camera.project(there);
    RC_ASSERT(p.has_value());
    const auto found = camera.on_level(p->first, p->second, there.y);
    RC_PRE(camera.elevation > 0.05 && camera.eye().y > there.y + 0.01);
    RC_ASSERT(found.has_value());
    RC_ASSERT(length(*found - there) < 1e-4);
  }));
}

TEST(Camera, NoPixelAboveTheHorizonLiesOnALevel) {
  Camera camera;
  EXPECT_FALSE(camera.on_level(640, -5000, 0.1));
  EXPECT_TRUE(camera.on_level(640, 700, 0.1));
  camera.elevation = 0.0;
  EXPECT_FALSE(camera.on_level(640, 360, 0.1)) << "the level itself";
}

TEST(Camera, MatricesAgreeWithProject) {
  EXPECT_TRUE(rc::check([] {
    const Camera camera = some_camera();
    const Vec3 p{*rc::gen::inRange(-100, 100) * 0.001, *rc::gen::inRange(0, 250) * 0.001,
                 *rc::gen::inRange(-100, 100) * 0.001};
    float view[16], projection[16];
    camera.matrices(view, projection);
    const auto times = [](const float m[16], const double v[4], double out[4]) {
      for (int r = 0; r < 4; ++r) {
        out[r] = 0;
        for (int c = 0; c < 4; ++c) out[r] += m[4 * c + r] * v[c];
      }
    };
    const double at[4] = {p.x, p.y, p.z, 1.0};
    double seen[4], clip[4];
    times(view, at, seen);
    times(projection, seen, clip);
    const auto pixel = camera.project(p);
    RC_ASSERT(pixel.has_value());
    RC_ASSERT(std::abs((clip[0] / clip[3] + 1) * 0.5 * camera.width - pixel->first) < 0.05);
    RC_ASSERT(std::abs((1 - clip[1] / clip[3]) * 0.5 * camera.height - pixel->second) < 0.05);
    RC_ASSERT(std::abs(clip[2]) < clip[3]);
  }));
}

TEST(Camera, HasNoPixelForWhatLiesBehindTheEye) {
  Camera camera;
  Vec3 right, up, back;
  camera.basis(right, up, back);
  EXPECT_FALSE(camera.project(camera.eye() + back * 0.5).has_value());
}

TEST(FramePot, FillsItsBoxAndStaysInside) {
  EXPECT_TRUE(rc::check([] {
    const double height = *rc::gen::inRange(30, 400) * 0.001;
    const double radius = *rc::gen::inRange(30, 300) * 0.001;
    const Rect box{300, 60, 700, 600};
    const Camera camera = frame_pot(1280, 720, box, height, radius);
    float left = 1e9f, right = -1e9f, top = 1e9f, bottom = -1e9f;
    for (int i = 0; i < 200; ++i) {
      const double a = i * 0.0314159265;
      for (const double y : {0.0, height}) {
        const auto p = camera.project({radius * std::cos(a), y, radius * std::sin(a)});
        RC_ASSERT(p.has_value());
        left = std::min(left, p->first);
        right = std::max(right, p->first);
        top = std::min(top, p->second);
        bottom = std::max(bottom, p->second);
      }
    }
    RC_ASSERT(left > box.x - 1 && right < box.x + box.w + 1);
    RC_ASSERT(top > box.y - 1 && bottom < box.y + box.h + 1);
    RC_ASSERT(right - left > 0.98f * box.w || bottom - top > 0.98f * box.h);
  }));
}

}  // namespace
}  // namespace onggi::view::camera_test
