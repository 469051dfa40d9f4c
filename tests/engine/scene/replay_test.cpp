#include "engine/scene/replay.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "engine/math/random.h"
#include "engine/scene/replay_bytes.h"

namespace onggi::replay_test {
namespace {

SceneDef small() {
  SceneDef def;
  def.clay.rows = 40;
  def.clay.sectors = 48;
  return def;
}

double odd_number(Random& random) {
  const double odd[] = {0.0,
                        -0.0,
                        1e-310,
                        std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::quiet_NaN(),
                        random.uniform(-0.1, 0.1)};
  return odd[random.bits() % 6];
}

TickRecord random_tick(Random& random, TickRecord r) {
  for (HandInput& hand : r.hands.hand) {
    if (random.uniform() < 0.3)
      hand.position = {random.uniform(-0.1, 0.1), random.uniform(0, 0.2),
                       random.uniform(-0.1, 0.1)};
    if (random.uniform() < 0.02) hand.position.y = odd_number(random);
    if (random.uniform() < 0.1) hand.active = !hand.active;
    if (random.uniform() < 0.1) hand.side = static_cast<SideWish>(random.bits() % 3);
    if (random.uniform() < 0.05) hand.tool = static_cast<std::uint8_t>(random.bits() % 9);
    if (random.uniform() < 0.05) hand.handle = {random.uniform(-1, 1), random.uniform(-1, 1), 0.0};
    if (random.uniform() < 0.02) hand.roll = odd_number(random);
    for (bool* held : {&hand.coil, &hand.paddle, &hand.blow})
      if (random.uniform() < 0.05) *held = !*held;
    for (double* share : {&hand.anvil, &hand.swing})
      if (random.uniform() < 0.05) *share = random.uniform();
    if (random.uniform() < 0.01) hand.swing = odd_number(random);
  }
  if (random.uniform() < 0.1) r.hands.wheel_speed = random.uniform(-30, 30);
  if (random.uniform() < 0.1) r.hands.water = !r.hands.water;
  if (random.uniform() < 0.05) r.hands.renew = !r.hands.renew;
  if (random.uniform() < 0.05) r.hands.restore = !r.hands.restore;
  if (random.uniform() < 0.1) r.dt = random.uniform(1e-4, 5e-3);
  if (random.uniform() < 0.01) r.dt = odd_number(random);
  return r;
}

// A random visit played on a scene and recorded.
std::vector<std::byte> recorded(std::uint64_t seed, int ticks, const SceneDef& def,
                                std::vector<TickRecord>* out = nullptr) {
  Scene scene = std::move(*Scene::create(def));
  ReplayWriter writer(def, "moon_jar", seed);
  Random random(seed);
  TickRecord r;
  for (int n = 0; n < ticks; ++n) {
    r = random_tick(random, r);
    scene.step(r.hands, r.dt);
    writer.tick(r);
    if (out != nullptr) out->push_back(r);
    if (n % 50 == 49) writer.note_hash(scene.state_hash());
  }
  return writer.finish(scene.state_hash());
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same_bits(Vec3 a, Vec3 b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

bool same_bits(const TickRecord& a, const TickRecord& b) {
  for (std::size_t k = 0; k < kMaxHands; ++k) {
    const HandInput& one = a.hands.hand[k];
    const HandInput& other = b.hands.hand[k];
    if (!same_bits(one.position, other.position) || !same_bits(one.handle, other.handle) ||
        !same_bits(one.roll, other.roll) || one.active != other.active || one.side != other.side ||
        one.tool != other.tool || one.coil != other.coil || one.blow != other.blow ||
        one.paddle != other.paddle || !same_bits(one.anvil, other.anvil) ||
        !same_bits(one.swing, other.swing))
      return false;
  }
  return same_bits(a.dt, b.dt) && same_bits(a.hands.wheel_speed, b.hands.wheel_speed) &&
         a.hands.water == b.hands.water && a.hands.renew == b.hands.renew &&
         a.hands.restore == b.hands.restore;
}

RC_GTEST_PROP(ReplayProperty, WhatIsWrittenIsReadBackBitForBitAndReplaysToTheSameHashes,
              (std::uint64_t seed)) {
  SceneDef def = small();
  if (seed % 2 == 0) def.friction.reset();
  if (seed % 3 == 0) def.moisture.reset();
  if (seed % 6 == 0) def.paper = PaperDef{9.0, 1.5, 100.0};
  std::vector<TickRecord> ticks;
  const auto bytes = recorded(seed, 120, def, &ticks);
  const Result<Replay> replay = Replay::read(bytes, "test");
  RC_ASSERT(replay.has_value());
  RC_ASSERT(replay->vessel_id == "moon_jar");
  RC_ASSERT(replay->seed == seed);
  RC_ASSERT(replay->def.friction.has_value() == (seed % 2 != 0));
  RC_ASSERT(replay->def.moisture.has_value() == (seed % 3 != 0));
  RC_ASSERT(replay->def.paper.has_value() == (seed % 6 == 0));
  RC_ASSERT(replay->ticks.size() == ticks.size());
  for (std::size_t n = 0; n < ticks.size(); ++n) RC_ASSERT(same_bits(ticks[n], replay->ticks[n]));
  const Result<ReplayOutcome> outcome = run_replay(*replay);
  RC_ASSERT(outcome.has_value());
  RC_ASSERT(outcome->first_difference_tick == -1);
  RC_ASSERT(outcome->replayed_hash == outcome->recorded_hash);
  RC_ASSERT(outcome->hashes_checked == 3u);
}

/// `bytes` with up to four of them changed, put in or cut off at random.
std::vector<std::byte> damaged(std::vector<std::byte> bytes, std::uint64_t seed) {
  Random random(seed);
  const int changes = 1 + static_cast<int>(random.bits() % 4);
  for (int n = 0; n < changes; ++n) {
    switch (random.bits() % 3) {
      case 0:
        bytes[random.bits() % bytes.size()] = static_cast<std::byte>(random.bits());
        break;
      case 1:
        bytes.resize(1 + random.bits() % bytes.size());
        break;
      default:
        bytes.insert(bytes.begin() + static_cast<long>(random.bits() % bytes.size()),
                     static_cast<std::byte>(random.bits()));
    }
  }
  return bytes;
}

RC_GTEST_PROP(ReplayProperty, ADamagedFileIsRefused, (std::uint64_t seed)) {
  static const auto whole = recorded(5, 60, small());
  const auto bytes = damaged(whole, seed);
  const Result<Replay> replay = Replay::read(bytes, "damaged");
  RC_ASSERT(replay.has_value() == (bytes == whole));
  if (!replay) RC_ASSERT(replay.error().exit_code == 2);
}

RC_GTEST_PROP(ReplayProperty, DamageUnderARightChecksumIsRefusedOrReadAndNeverCrashes,
              (std::uint64_t seed)) {
  static const auto whole = recorded(5, 60, small());
  auto bytes = damaged(whole, seed);
  bytes.resize(bytes.size() - std::min<std::size_t>(bytes.size(), 8));
  replay_bytes::seal(bytes);
  const Result<Replay> replay = Replay::read(bytes, "damaged");
  if (!replay) {
    RC_ASSERT(!replay.error().where.empty() && !replay.error().remedy.empty());
  } else {
    RC_ASSERT(validate(replay->def).has_value());
  }
}

TEST(Replay, CarriesTheGlazeThatWasChosenAndNoneWhereThereWasNone) {
  const SceneDef def = small();
  for (const std::string glaze : {"", "white_porcelain"}) {
    ReplayWriter writer(def, "moon_jar", 1);
    writer.tick({});
    const auto bytes = writer.finish(7, glaze);
    const auto read = Replay::read(bytes, "visit.onggi");
    ASSERT_TRUE(read) << to_text(read.error());
    EXPECT_EQ(read->glaze, glaze);
    EXPECT_EQ(read->final_hash, 7u);
    for (std::size_t n = 0; n < bytes.size(); ++n)
      EXPECT_FALSE(Replay::read(std::span(bytes).first(n), "cut"));
  }
}

TEST(Replay, NoFlippedByteIsEverTakenForAnotherPot) {
  auto bytes = recorded(9, 40, small());
  for (std::size_t n = 0; n < bytes.size(); ++n)
    for (const unsigned flip : {0x01u, 0x80u, 0xFFu}) {
      bytes[n] ^= static_cast<std::byte>(flip);
      const Result<Replay> replay = Replay::read(bytes, "visit.onggi");
      ASSERT_FALSE(replay) << n;
      EXPECT_EQ(replay.error().exit_code, 2);
      const bool behind_the_version = n >= 12;
      EXPECT_TRUE(!behind_the_version || replay.error().what.find("damaged") != std::string::npos)
          << replay.error().what;
      bytes[n] ^= static_cast<std::byte>(flip);
    }
  EXPECT_TRUE(Replay::read(bytes, "visit.onggi"));
}

TEST(Replay, UnderARightChecksumAnotherVersionAndBytesBehindTheEndAreStillRefused) {
  auto body = recorded(9, 40, small());
  body.resize(body.size() - replay_bytes::kSealBytes);
  const auto fault = [](std::vector<std::byte> bytes) {
    replay_bytes::seal(bytes);
    const Result<Replay> replay = Replay::read(bytes, "visit.onggi");
    return replay ? "it was read" : replay.error().what;
  };
  EXPECT_EQ(fault(body), "it was read");
  auto other = body;
  other[8] = std::byte{replay_bytes::kVersion + 1};  // behind the eight bytes that say what it is
  EXPECT_NE(fault(other).find("another version"), std::string::npos) << fault(other);
  auto longer = body;
  longer.push_back(std::byte{0});
  EXPECT_NE(fault(longer).find("end is damaged"), std::string::npos) << fault(longer);
}

TEST(Replay, EveryShorterFileIsRefused) {
  const auto bytes = recorded(9, 40, small());
  for (std::size_t n = 0; n < bytes.size(); ++n)
    EXPECT_FALSE(Replay::read(std::span(bytes).first(n), "short")) << n;
  auto longer = bytes;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(Replay::read(longer, "long"));
}

TEST(Replay, NoTickOneTickAndAMillionComeBack) {
  for (const int count : {0, 1, 1'000'000}) {
    ReplayWriter writer(small(), "x", 1);
    Random random(4);
    TickRecord r;
    const auto next = [&r](Random& by) {
      r.hands.hand[0].position.x += 1e-6;
      if (by.bits() % 1000 == 0) r = random_tick(by, r);
    };
    for (int n = 0; n < count; ++n) next(random), writer.tick(r);
    const Result<Replay> replay = Replay::read(writer.finish(9), "many");
    ASSERT_TRUE(replay) << to_text(replay.error());
    ASSERT_EQ(replay->ticks.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(replay->final_hash, 9u);
    random = Random(4);
    r = {};
    for (const TickRecord& tick : replay->ticks) {
      next(random);
      ASSERT_TRUE(same_bits(tick, r));
    }
  }
}

TEST(Replay, MoreThanFourMillionTicksAreRefusedAsTooLong) {
  ReplayWriter writer(small(), "x", 1);
  for (int n = 0; n < 4'000'000; ++n) {
    ASSERT_FALSE(writer.full());
    writer.tick({});
  }
  EXPECT_TRUE(writer.full());
  writer.tick({});
  const Result<Replay> replay = Replay::read(writer.finish(0), "long");
  ASSERT_FALSE(replay);
  EXPECT_NE(replay.error().what.find("longer than an hour"), std::string::npos);
}

// The kiosk keeps a pot twice if its visitor throws on.
TEST(Replay, ARecordingGoesOnBehindItsEnd) {
  ReplayWriter writer(small(), "x", 1);
  TickRecord r;
  for (int n = 0; n < 20; ++n) {
    r.hands.hand[0].position.y = 0.01 * n;
    writer.tick(r);
    const Result<Replay> replay = Replay::read(writer.finish(7), "so far");
    ASSERT_TRUE(replay) << to_text(replay.error());
    EXPECT_EQ(replay->ticks.size(), static_cast<std::size_t>(n) + 1);
  }
}

TEST(Replay, HashesInDisorderOrBehindTheLastTickAreRefused) {
  const auto what = [](std::uint64_t first, std::uint64_t second) {
    ReplayWriter writer(small(), "x", 1);
    writer.note_hash(111);
    writer.note_hash(222);
    writer.tick({});
    writer.tick({});
    auto bytes = writer.finish(3);
    bytes.resize(bytes.size() - replay_bytes::kSealBytes);
    for (const auto& [hash, tick] : {std::pair{111u, first}, std::pair{222u, second}})
      for (std::size_t n = 8; n + 8 <= bytes.size(); ++n)
        if (bytes[n] == std::byte(hash) &&
            std::all_of(&bytes[n - 8], &bytes[n], [](std::byte b) { return b == std::byte{0}; }) &&
            std::all_of(&bytes[n + 1], &bytes[n + 8],
                        [](std::byte b) { return b == std::byte{0}; }))
          bytes[n - 8] = std::byte(tick);
    replay_bytes::seal(bytes);
    const Result<Replay> replay = Replay::read(bytes, "visit.onggi");
    return replay ? std::string("it was read") : replay.error().what;
  };
  EXPECT_EQ(what(0, 2), "it was read");
  EXPECT_NE(what(2, 1).find("not in order"), std::string::npos) << what(2, 1);
  EXPECT_NE(what(1, 3).find("behind the last tick"), std::string::npos) << what(1, 3);
}

TEST(Replay, AnUnchangedTickIsOneByte) {
  const SceneDef def = small();
  ReplayWriter short_one(def, "x", 1);
  ReplayWriter long_one(def, "x", 1);
  TickRecord r;
  r.hands.hand[0].position.x = std::numeric_limits<double>::quiet_NaN();
  short_one.tick(r);
  for (int n = 0; n < 1001; ++n) long_one.tick(r);
  EXPECT_EQ(long_one.finish(0).size(), short_one.finish(0).size() + 1000);
}

TEST(Replay, AnotherHashIsFoundAtItsTick) {
  const SceneDef def = small();
  ReplayWriter writer(def, "x", 1);
  for (int n = 0; n < 10; ++n) writer.tick({});
  writer.note_hash(12345);
  writer.tick({});
  const Result<Replay> replay = Replay::read(writer.finish(0), "test");
  ASSERT_TRUE(replay);
  std::unique_ptr<Scene> scene;
  const Result<ReplayOutcome> outcome = run_replay(*replay, &scene);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->first_difference_tick, 10);
  EXPECT_EQ(outcome->ticks, 11u);
  ASSERT_NE(scene, nullptr);
  EXPECT_EQ(scene->state_hash(), outcome->replayed_hash);
}

}  // namespace
}  // namespace onggi::replay_test
