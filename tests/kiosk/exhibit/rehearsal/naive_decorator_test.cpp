#include "kiosk/exhibit/rehearsal/naive_decorator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "kiosk/visit/decorating/touched_place.h"

namespace onggi::rehearsal::naive_decorator_test {
namespace {

Profile a_pot() {
  Profile profile;
  for (int n = 0; n <= 40; ++n) {
    const double outer = 0.05 + 0.02 * std::sin(3.0 * n / 40.0);
    profile.points.push_back({0.16 * n / 40, outer, n < 2 ? 0.0 : outer - 0.006});
  }
  return profile;
}

struct Decorated {
  std::uint64_t hash = 0;
  std::set<std::string> controls;
  int touches = 0;
};

constexpr double kSeconds = 20;

/// What the visitor of this seed does with a way of the exhibit's.
Decorated decorate(std::uint64_t seed, const std::string& way_id, double seconds = kSeconds) {
  const auto read = decoration::read_way("content/ways/" + way_id + ".toml", {});
  const auto pot = *decorating::DecoratedPot::begin(a_pot(), read.way);
  const view::Camera camera = view::frame_pot(1280, 720, {560, 40, 680, 600}, 0.16, 0.07);
  NaiveDecorator visitor(seed, seconds);
  Decorated out;
  double down_since = -1;
  for (double now = 0; !visitor.done() && now < 200; now += 0.02) {
    const DecoratingHand::Act act = visitor.step(now, *pot, camera);
    if (!act.control.empty()) {
      out.controls.insert(act.control);
      if (act.control.starts_with("decorate.tool."))
        pot->choose_tool(std::stoi(act.control.substr(14)));
      if (act.control == "decorate.undo") pot->undo();
    }
    if (act.finger) {
      if (down_since < 0) down_since = now, ++out.touches;
      const auto at =
          decorating::place_under(camera, pot->surface(), 0, act.finger->first, act.finger->second);
      if (at && !pot->pressed()) pot->press(*at);
      if (at) pot->move(*at);
    } else if (down_since >= 0) {
      down_since = -1;
      pot->lift();
    }
    pot->update(0.02);
  }
  EXPECT_TRUE(visitor.done());
  pot->finish();
  out.hash = pot->surface().hash();
  return out;
}

TEST(NaiveDecorator, IsTheSamePersonWithTheSameSeedAndAnotherWithAnother) {
  EXPECT_EQ(decorate(3, "porcelain").hash, decorate(3, "porcelain").hash);
  EXPECT_NE(decorate(3, "porcelain").hash, decorate(8, "porcelain").hash);
}

TEST(NaiveDecorator, TouchesThePotManyTimesAndNothingThatIsNotThere) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Decorated of = decorate(seed, "slip_painted");
    EXPECT_GE(of.touches, 4) << seed;
    for (const std::string& control : of.controls) {
      const bool known = control == "decorate.undo" || control.starts_with("decorate.tool.") ||
                         control.starts_with("decorate.color.") ||
                         control.starts_with("decorate.figure.") ||
                         control.starts_with("decorate.times.");
      EXPECT_TRUE(known) << control;
    }
  }
}

TEST(NaiveDecorator, NoneOfThemLooksBehindMoreTools) {
  const auto read = decoration::read_way("content/ways/onggi.toml", {});
  for (const std::uint64_t seed : {2, 3})
    for (const std::string& control : decorate(seed, "onggi").controls)
      if (control.starts_with("decorate.tool.")) {
        EXPECT_FALSE(read.way.tools[std::stoul(control.substr(14))].more) << control;
      }
}

TEST(NaiveDecorator, EachOfThemHasAWay) {
  const auto tools = [](std::uint64_t seed) {
    int n = 0;
    for (const std::string& control : decorate(seed, "porcelain", 60).controls)
      n += control.starts_with("decorate.tool.");
    return n;
  };
  using Who = NaiveDecorator::Who;
  EXPECT_EQ(NaiveDecorator(7, kSeconds).who(), Who::one_tool);
  EXPECT_EQ(tools(7), 1);
  EXPECT_EQ(NaiveDecorator(8, kSeconds).who(), Who::all_tools);
  EXPECT_EQ(tools(8), 4);
}

}  // namespace
}  // namespace onggi::rehearsal::naive_decorator_test
