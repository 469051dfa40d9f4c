#include "kiosk/visit/sound/synthesis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace onggi::sound::synthesis_test {
namespace {

Heard at_rest() {
  Heard heard;
  heard.volume = 1.0;
  return heard;
}
Heard rubbing(double slip, double push, Rub::Kind kind = Rub::Kind::hand, double wet = 0.0) {
  Heard heard = at_rest();
  heard.rub[0] = {kind, slip, push};
  heard.wet = wet;
  return heard;
}
Heard turning(double rpm) {
  Heard heard = at_rest();
  heard.wheel = rpm * 2.0 * 3.14159265358979 / 60.0;
  return heard;
}

std::vector<float> played(Synthesis& synthesis, const Heard& heard, double seconds) {
  std::vector<float> out(static_cast<std::size_t>(seconds * kRate));
  synthesis.play(heard, out);
  return out;
}
std::vector<float> settled(const Heard& heard) {
  Synthesis synthesis;
  played(synthesis, heard, 1.0);
  return played(synthesis, heard, 1.0);
}
double loudness(const std::vector<float>& sound) {
  double sum = 0.0;
  for (const float x : sound) sum += double{x} * x;
  return std::sqrt(sum / static_cast<double>(sound.size()));
}
double share_at(const std::vector<float>& sound, double hz) {
  double re = 0.0, im = 0.0;
  for (std::size_t n = 0; n < sound.size(); ++n) {
    const double angle = 2.0 * 3.14159265358979 * hz * static_cast<double>(n) / kRate;
    re += sound[n] * std::cos(angle);
    im += sound[n] * std::sin(angle);
  }
  return std::hypot(re, im);
}
// Hz, to 1, of the strongest tone below 300.
double pitch_of(const std::vector<float>& sound) {
  double best = 0.0, most = -1.0;
  for (double hz = 20.0; hz < 300.0; hz += 1.0)
    if (const double share = share_at(sound, hz); share > most) most = share, best = hz;
  return best;
}
// Changes of sign a second, halved: of noise, about where its middle lies.
double brightness(const std::vector<float>& sound) {
  int changes = 0;
  for (std::size_t n = 1; n < sound.size(); ++n) changes += (sound[n] > 0) != (sound[n - 1] > 0);
  return 0.5 * changes * kRate / static_cast<double>(sound.size());
}

TEST(Studio, IsSilentToTheLastBitWhereNothingMoves) {
  for (const float x : settled(at_rest())) ASSERT_EQ(x, 0.0f);
  Heard muted = rubbing(1.0, 5.0);
  muted.volume = 0.0;
  for (const float x : settled(muted)) ASSERT_EQ(x, 0.0f);
}

TEST(Studio, IsSilentAgainHalfASecondAfterHandsAreGone) {
  Synthesis synthesis;
  played(synthesis, rubbing(1.0, 5.0), 1.0);
  played(synthesis, at_rest(), 0.5);
  for (const float x : played(synthesis, at_rest(), 0.1)) ASSERT_EQ(x, 0.0f);
}

TEST(Wheel, HumsHigherAndLouderTheFasterItTurnsEitherWayRound) {
  const auto slow = settled(turning(60)), fast = settled(turning(180));
  EXPECT_NEAR(pitch_of(slow), 28 + 4 * 6.283, 1.5);
  EXPECT_NEAR(pitch_of(fast), 28 + 4 * 18.85, 1.5);
  EXPECT_GT(loudness(fast), 1.2 * loudness(slow));
  EXPECT_LT(loudness(settled(turning(600))), 0.06) << "quiet at its fastest";
  EXPECT_EQ(settled(turning(-180)), fast);
}

TEST(Friction, IsLouderTheHarderAndTheFasterAndBrighterTheFasterForEveryTool) {
  for (const auto kind : {Rub::Kind::hand, Rub::Kind::sponge, Rub::Kind::rib, Rub::Kind::wire}) {
    const auto light = settled(rubbing(0.5, 0.3, kind)), firm = settled(rubbing(0.5, 3.0, kind)),
               hasty = settled(rubbing(2.0, 3.0, kind));
    EXPECT_GT(loudness(firm), 1.5 * loudness(light)) << static_cast<int>(kind);
    EXPECT_GT(loudness(hasty), 1.05 * loudness(firm)) << static_cast<int>(kind);
    EXPECT_GT(brightness(hasty), 1.15 * brightness(firm)) << static_cast<int>(kind);
  }
}

TEST(Friction, OfASpongeIsDullerThanAHandsAndARibsAndAWiresAreSharper) {
  const auto of = [](Rub::Kind kind) { return brightness(settled(rubbing(0.6, 2.0, kind))); };
  EXPECT_LT(1.5 * of(Rub::Kind::sponge), of(Rub::Kind::hand));
  EXPECT_LT(1.2 * of(Rub::Kind::hand), of(Rub::Kind::rib));
  EXPECT_LT(1.2 * of(Rub::Kind::hand), of(Rub::Kind::wire));
  EXPECT_LT(1.1 * brightness(settled(rubbing(0.6, 2.0, Rub::Kind::hand, 1.0))), of(Rub::Kind::hand))
      << "wet clay is duller";
}

TEST(Friction, NeedsPushAndSlipBoth) {
  for (const Heard& heard : {rubbing(1.0, 0.0), rubbing(0.0, 5.0)})
    for (const float x : settled(heard)) ASSERT_EQ(x, 0.0f);
}

TEST(Friction, IsHeardFiveMillisecondsAfterTheTouch) {
  Synthesis synthesis;
  played(synthesis, at_rest(), 0.2);
  const auto first = played(synthesis, rubbing(0.5, 2.0), 0.005);
  EXPECT_GT(loudness(first), 0.3 * loudness(settled(rubbing(0.5, 2.0))));
}

TEST(Kiln, RumblesLowAndCracklesNowAndThen) {
  Heard heard = at_rest();
  heard.fire = 1.0;
  Synthesis synthesis;
  played(synthesis, heard, 3.0);
  const auto fire = played(synthesis, heard, 4.0);
  EXPECT_GT(loudness(fire), 0.02);
  double low = 0.0, high = 0.0;
  for (double hz = 30; hz < 130; hz += 5) low += share_at(fire, hz);
  for (double hz = 3000; hz < 3100; hz += 5) high += share_at(fire, hz);
  EXPECT_GT(low, 5.0 * high);
  const float loudest = *std::max_element(fire.begin(), fire.end());
  EXPECT_GT(loudest, 3.0 * loudness(fire)) << "sparks";
}

// A blow of `force` N that lies for an eighth of a second, and what follows.
std::vector<float> knocked(double force, double wet, int blows = 1) {
  Synthesis synthesis;
  Heard before = at_rest();
  before.wet = wet;
  played(synthesis, before, 1.0);
  std::vector<float> all;
  for (int n = 0; n < blows; ++n)
    for (const bool lies : {true, false}) {
      Heard heard = at_rest();
      heard.wet = wet;
      heard.knock[0].force = lies ? force : 0.0;
      const std::vector<float> part = played(synthesis, heard, lies ? 0.125 : 0.375);
      all.insert(all.end(), part.begin(), part.end());
    }
  return all;
}

TEST(Paddle, IsHeardOnceABlowAndFadesWithinHalfASecond) {
  const std::vector<float> one = knocked(60.0, 0.0), two = knocked(60.0, 0.0, 2);
  EXPECT_GT(loudness(one), 0.01);
  EXPECT_NEAR(loudness(two), loudness(one), 0.1 * loudness(one)) << "as loud in twice the time";
  float steepest = 0.0f;
  for (std::size_t n = 1; n < two.size(); ++n)
    steepest = std::max(steepest, std::fabs(two[n] - two[n - 1]));
  EXPECT_LT(steepest, 0.03f) << "a knock, and no click";
  const std::vector<float> end(one.end() - 4800, one.end());
  EXPECT_LT(loudness(end), 0.02 * loudness(one));
  EXPECT_EQ(loudness(knocked(0.0, 0.0)), 0.0) << "a blow that missed";
  EXPECT_GT(loudness(one), 1.5 * loudness(knocked(10.0, 0.0)));
}

// That is how a potter hears that clay is ready.
TEST(Paddle, RingsOnClayThatIsReadyAndIsDullOnWetClay) {
  const auto bright = [](double wetness) {
    const std::vector<float> sound = knocked(60.0, wetness);
    double high = 0.0, low = 0.0;
    for (double hz = 60.0; hz < 300.0; hz += 8.0) low += share_at(sound, hz);
    for (double hz = 300.0; hz < 1200.0; hz += 8.0) high += share_at(sound, hz);
    return high / low;
  };
  const double ready = bright(0.0), soft = bright(0.25), wet = bright(0.6);
  EXPECT_GT(ready, 1.5 * soft);
  EXPECT_GT(soft, wet);
  const auto lasts = [](double wetness) {
    const std::vector<float> sound = knocked(60.0, wetness);
    return loudness({sound.begin() + 4800, sound.end()}) / loudness(sound);  // after 0.1 s
  };
  EXPECT_GT(lasts(0.0), 3.0 * lasts(0.6));
}

TEST(Studio, NeverLeavesItsRangeNorClicksWhateverItIsTold) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  Synthesis synthesis;
  // Tones and fire, whose samples lie near each other by themselves; each told to go and come at
  // once.
  float last = 0.0f, steepest = 0.0f;
  for (int n = 0; n < 400; ++n) {
    Heard heard = n % 2 != 0 ? turning(600) : at_rest();
    heard.volume = n % 3 != 0 ? 1.0 : 0.0;
    for (const float x : played(synthesis, heard, 0.004)) {
      steepest = std::max(steepest, std::fabs(x - last));
      last = x;
    }
  }
  EXPECT_LT(steepest, 0.01f);
  const double figures[] = {0.0, -3.0, 1e-320, 0.5, 40.0, 1e9, kNan, kInf, -kInf};
  int told = 0;
  for (const double a : figures)
    for (const double b : figures)
      for (const auto kind :
           {Rub::Kind::hand, Rub::Kind::sponge, Rub::Kind::rib, Rub::Kind::wire}) {
        Heard heard{.wheel = a,
                    .wet = b,
                    .rub = {Rub{kind, a, b}, Rub{kind, b, a}},
                    .knock = {Knock{a}, Knock{b}},
                    .fire = b,
                    .volume = ++told % 5 == 0 ? a : 1.0};
        for (const float x : played(synthesis, heard, 0.01))
          ASSERT_LE(std::fabs(x), 1.0f) << a << ' ' << b;
      }
  played(synthesis, at_rest(), 10.0);
  for (const float x : played(synthesis, at_rest(), 0.1))
    ASSERT_EQ(x, 0.0f) << "it gets over anything";
}

TEST(Studio, SoundsTheSameHoweverItsSamplesAreAskedFor) {
  Synthesis whole, parts;
  Heard heard = rubbing(0.7, 2.0);
  heard.wheel = 12.0;
  heard.fire = 0.5;
  const auto at_once = played(whole, heard, 0.1);
  std::vector<float> out(at_once.size());
  for (std::size_t n = 0, next = 1; n < out.size(); n += next, next = next % 13 + 1) {
    next = std::min(next, out.size() - n);
    parts.play(heard, std::span(out).subspan(n, next));
  }
  EXPECT_EQ(at_once, out);
}

}  // namespace
}  // namespace onggi::sound::synthesis_test
