#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/contact/paper_model.h"
#include "tests/engine/contact/papers_pot.h"
#include "tests/support/sphere.h"

// What goes wrong in time with the equations as printed, each with the corrected model's answer
// beside it. Numbers are those of the table in engine/docs/paper.md.
namespace onggi::paper_time_test {
namespace {

using namespace papers_pot;

constexpr double kStiffness = 5e6;

// The tool with its tip at radius `reach`, level with a row.
Vec3 tip_at(const Clay& clay, double reach) { return {reach + kRadius, clay.row_height(200), 0.0}; }
// Where the sphere wants the first element of that row: half a sector off the tool's angle.
double target_of(Vec3 at) {
  const double half = std::acos(-1.0) / 360.0;
  const double off = at.x * std::sin(half);
  return at.x * std::cos(half) - std::sqrt(kRadius * kRadius - off * off);
}
double face(const Clay& clay) { return double{clay.outer(200)[0]}; }

PaperTouch printed(Clay& clay, Vec3 at, double c_eta) {
  return PaperModel(clay).tick(clay, WallSide::outside, at, kRadius, 0.0, 0.0, {c_eta, 0.864, 0.0});
}
// c_eta that takes as much at this tick as 10 does at 1 ms.
double same_clay(double dt) { return 1.0 / -std::expm1(-dt / kTau); }

TEST(Paper10, TheClayIsTwiceAsSoftAtTwiceTheRate) {
  double left[2][2];
  for (int fast : {0, 1}) {
    const double dt = fast ? 0.0005 : 0.001;
    const int ticks = fast ? 40 : 20;
    Clay a = made(sheet());
    Clay b = made(sheet());
    const Vec3 at = tip_at(a, 0.048);
    for (int n = 0; n < ticks; ++n) {
      printed(a, at, 10.0);
      press_sphere(b, WallSide::outside, at, kRadius, dt, {kTau, kStiffness});
    }
    left[0][fast] = face(a) - target_of(at);
    left[1][fast] = face(b) - target_of(at);
  }
  EXPECT_NEAR(left[0][0] / left[0][1], std::pow(0.9, -20), 0.05);  // 8.2 times
  EXPECT_NEAR(left[1][0] / left[1][1], 1.0, 0.001);
}

TEST(Paper10, ASoftClayIsThrownPastTheTool) {
  Clay a = made(sheet());
  Clay b = made(sheet());
  const Vec3 at = tip_at(a, 0.048);
  printed(a, at, 0.6);
  press_sphere(b, WallSide::outside, at, kRadius, 0.001, {1e-4, kStiffness});
  EXPECT_LT(face(a), target_of(at) - 0.001);
  EXPECT_GE(face(b), target_of(at) - 1e-8);
}

TEST(Paper11, ATargetFrozenWithinTheTickIsOfFirstOrderOnly) {
  // The tool comes from the surface at 0.1 m/s for 20 ms.
  const double speed = 0.1;
  const double whole = 0.02;
  const auto run = [&](double dt, bool as_printed) {
    Clay clay = made(sheet());
    const int ticks = static_cast<int>(whole / dt + 0.5);
    // The tip starts where the first element is just touched.
    const double slack = target_of(tip_at(clay, 0.05)) - 0.05;
    const double start = 0.05 - slack;
    for (int n = 0; n < ticks; ++n) {
      const Vec3 from = tip_at(clay, start - speed * dt * n);
      const Vec3 to = tip_at(clay, start - speed * dt * (n + 1));
      if (as_printed)
        printed(clay, to, same_clay(dt));
      else
        press_sphere(clay, WallSide::outside, 0.5 * (from + to), kRadius, dt, {kTau, kStiffness});
    }
    const double target = target_of(tip_at(clay, start - speed * whole));
    const double exact = target - speed * kTau * std::expm1(-whole / kTau);
    return std::fabs(face(clay) - exact);
  };
  EXPECT_NEAR(run(0.001, true) / run(0.0005, true), 2.0, 0.2);
  EXPECT_NEAR(run(0.004, false) / run(0.002, false), 4.0, 0.4);
  EXPECT_GT(run(0.001, true), 20.0 * run(0.001, false));
}

TEST(Paper12, TheImpulseOfOnePressDependsOnTheTick) {
  const auto impulse = [](double dt, bool as_printed) {
    Clay clay = made(sheet());
    const Vec3 at = tip_at(clay, 0.048);
    double sum = 0.0;
    for (double t = 0.0; t < 0.1; t += dt)
      sum += dt * (as_printed
                       ? printed(clay, at, same_clay(dt)).resistance.x
                       : press_sphere(clay, WallSide::outside, at, kRadius, dt, {kTau, kStiffness})
                             .force.x);
    return sum;
  };
  EXPECT_GT(impulse(0.005, true) / impulse(0.001, true), 1.15);
  EXPECT_NEAR(impulse(0.005, false) / impulse(0.001, false), 1.0, 0.01);
}

TEST(Paper14, TheFilteredForceComesTwentyTwoMillisecondsLate) {
  PaperFilter filter;
  double out = 0.0;
  for (int n = 0; n <= 2000; ++n) out = filter.filter({n * 0.001, 0.0, 0.0}).x;
  EXPECT_NEAR(2.0 - out, 0.0225, 0.0005);  // a ramp of 1 N/s

  // The corrected force is not filtered: it is there in the tick of the touch.
  Clay clay = made(sheet());
  const Vec3 at = tip_at(clay, 0.048);
  const double first =
      press_sphere(clay, WallSide::outside, at, kRadius, 0.001, {kTau, kStiffness}).force.x;
  PaperFilter late;
  EXPECT_GT(first, 0.3);
  EXPECT_LT(late.filter({first, 0.0, 0.0}).x, 0.01 * first);
}

TEST(Paper14, ALightToolOnASpringRunsAwayThroughTheFilter) {
  const auto swing = [](bool filtered) {
    constexpr double kMass = 0.045, kDamping = 0.1, kSpring = 100.0;  // kg, N s/m, N/m
    constexpr double kStep = 1e-5;
    PaperFilter filter;
    double x = 0.001;
    double v = 0.0;
    double most = 0.0;
    for (int tick = 0; tick < 1000; ++tick) {
      const double wanted = -kSpring * x;
      const double force = filtered ? filter.filter({wanted, 0.0, 0.0}).x : wanted;
      for (int part = 0; part < 100; ++part) {
        v += kStep * (force - kDamping * v) / kMass;
        x += kStep * v;
      }
      if (tick >= 900) most = std::max(most, std::fabs(x));
    }
    return most;
  };
  EXPECT_GT(swing(true), 0.01);    // ten times where it began
  EXPECT_LT(swing(false), 0.001);  // dying away
}

}  // namespace
}  // namespace onggi::paper_time_test
