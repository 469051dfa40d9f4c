#include "engine/scene/replay_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "engine/scene/replay.h"

namespace onggi::replay_scene_test {
namespace {

using Bytes = std::vector<std::byte>;

Bytes file(const std::string& name) {
  std::ifstream in("tests/golden/" + name, std::ios::binary);
  Bytes bytes;
  for (auto at = std::istreambuf_iterator<char>(in); at != std::istreambuf_iterator<char>(); ++at)
    bytes.push_back(static_cast<std::byte>(*at));
  return bytes;
}

// Written by the last engine of version 11: 300 ticks, a hash every 100. Clay has had other laws
// since (slump, moisture, what is felt at edges), so it plays to another pot.
TEST(ReplayScene, AFileOfTheOldVersionWithEveryEffectPlaysByTheLawsOfTodayAndSaysSo) {
  const Result<Replay> replay = Replay::read(file("version_11_effects.onggi"), "old");
  ASSERT_TRUE(replay) << to_text(replay.error());
  const SceneDef& def = replay->def;
  EXPECT_EQ(def.clay.rows, 60);
  EXPECT_EQ(def.clay.wall_min, 0.003);
  EXPECT_FALSE(def.clay.keep_undo);
  EXPECT_EQ(def.tool.radius, 0.009);
  ASSERT_EQ(def.tools.size(), 2u);
  EXPECT_EQ(def.tools[1].name, "flat_rib");
  EXPECT_EQ(def.contact.stiffness, 4e6);
  EXPECT_EQ(def.wheel.acceleration, 25.0);
  EXPECT_EQ(def.guard.engage_time, 0.4);
  EXPECT_EQ(def.walls->tear_thickness, 0.004);
  EXPECT_EQ(def.slump->viscosity, 2e4);
  EXPECT_EQ(def.wobble->off_centre, 0.003);
  EXPECT_FALSE(def.paper);
  EXPECT_EQ(replay->glaze, "celadon");
  const Result<ReplayOutcome> outcome = run_replay(*replay);
  ASSERT_TRUE(outcome);
  EXPECT_TRUE(outcome->earlier_laws);
  EXPECT_EQ(outcome->ticks, 300u);
  EXPECT_EQ(outcome->hashes_checked, 4u);
  EXPECT_EQ(outcome->replayed_hash, 0x5158728210cad615u);
}

TEST(ReplayScene, AndSoDoesOneOfThePapersScene) {
  const Result<Replay> replay = Replay::read(file("version_11_paper.onggi"), "old");
  ASSERT_TRUE(replay) << to_text(replay.error());
  each_effect(replay->def, [](const auto& effect) { EXPECT_FALSE(effect); });
  ASSERT_TRUE(replay->def.paper);
  EXPECT_EQ(replay->def.paper->c_v, 1.5);
  const Result<ReplayOutcome> outcome = run_replay(*replay);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->first_difference_tick, -1);
  EXPECT_EQ(outcome->replayed_hash, 0x865f3e1be261c9fdu);
}

// The same 400 ticks, by the last program that wrote ticks one after another and by the first that
// wrote columns, with hands of which every field changes.
TEST(ReplayScene, AFileOfRowsAndOneOfColumnsHoldTheSameVisitAndPlayToTheSamePot) {
  const Result<Replay> rows = Replay::read(file("version_15.onggi"), "rows");
  const Result<Replay> columns = Replay::read(file("version_16.onggi"), "columns");
  ASSERT_TRUE(rows) << to_text(rows.error());
  ASSERT_TRUE(columns) << to_text(columns.error());
  ReplayWriter once(rows->def, rows->vessel_id, rows->seed);
  ReplayWriter again(columns->def, columns->vessel_id, columns->seed);
  for (const TickRecord& tick : rows->ticks) once.tick(tick);
  for (const TickRecord& tick : columns->ticks) again.tick(tick);
  EXPECT_EQ(once.finish(rows->final_hash, rows->glaze),
            again.finish(columns->final_hash, columns->glaze));
  std::vector<std::uint64_t> pots;
  for (const auto& replay : {rows, columns}) {
    EXPECT_EQ(replay->ticks.size(), 400u);
    EXPECT_EQ(replay->notes.size(), 4u);
    EXPECT_EQ(replay->notes[1].tick, 200u);
    EXPECT_EQ(replay->glaze, "celadon");
    const Result<ReplayOutcome> outcome = run_replay(*replay);
    ASSERT_TRUE(outcome);
    EXPECT_TRUE(outcome->earlier_laws);
    EXPECT_EQ(outcome->hashes_checked, 5u);
    pots.push_back(outcome->replayed_hash);
  }
  EXPECT_EQ(pots[0], pots[1]);
}

// Written by the last engine of version 18, where an anvil was there or not, and its bit was that
// of a coil: 900 ticks of one that is held and laid nowhere, and of blows with an anvil, without
// one, with a hand behind the wall, and from inside.
TEST(ReplayScene, APaddleOfBeforeStrikesAsItDidFullyAndAgainstAnAnvilOrNone) {
  const Result<Replay> replay = Replay::read(file("version_18.onggi"), "old");
  ASSERT_TRUE(replay) << to_text(replay.error());
  EXPECT_TRUE(replay->ticks[100].hands.hand[0].coil);
  EXPECT_EQ(replay->ticks[100].hands.hand[0].anvil, 0.0);
  EXPECT_EQ(replay->ticks[300].hands.hand[0].anvil, 1.0);
  EXPECT_EQ(replay->ticks[300].hands.hand[0].swing, 1.0);
  EXPECT_FALSE(replay->ticks[300].hands.hand[0].coil);
  EXPECT_EQ(replay->ticks[400].hands.hand[0].anvil, 0.0);
  EXPECT_TRUE(replay->earlier_laws) << "gaps of coils close since";
  const Result<ReplayOutcome> outcome = run_replay(*replay);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->first_difference_tick, -1);
  EXPECT_EQ(outcome->replayed_hash, 0x08ad5dd38d3ca771u);
}

// A replay of no tick, with its seal taken off.
Bytes written(const SceneDef& def) {
  ReplayWriter writer(def, "moon_jar", 3);
  Bytes bytes = writer.finish(0);
  bytes.resize(bytes.size() - replay_bytes::kSealBytes);
  return bytes;
}
Result<Replay> read(Bytes bytes) {
  replay_bytes::seal(bytes);
  return Replay::read(bytes, "visit.onggi");
}
Bytes::iterator find(Bytes& bytes, const std::string& word) {
  return std::search(bytes.begin(), bytes.end(), word.begin(), word.end(),
                     [](std::byte b, char c) { return b == static_cast<std::byte>(c); });
}

SceneDef odd() {
  SceneDef def;
  double n = 0.0;
  const auto set = [&]<class Def>(Def& part) {
    for (const DefField<Def>& field : Def::fields())
      part.*(field.value) = field.least + 1e-3 * ++n * (field.most - field.least);
  };
  each_part(def, set);
  each_effect(def, [&](auto& effect) { set(effect.emplace()); });
  def.clay.rows = 77;
  def.clay.keep_undo = false;
  return def;
}

TEST(ReplayScene, EveryNumberComesBack) {
  const SceneDef def = odd();
  Bytes bytes;
  replay_bytes::Writer writer(bytes);
  replay_bytes::write_scene(writer, def);
  replay_bytes::Reader reader(bytes);
  SceneDef back;
  std::string unknown;
  ASSERT_TRUE(replay_bytes::read_scene(reader, replay_bytes::kVersion, back, unknown)) << unknown;
  EXPECT_EQ(reader.left(), 0u);
  Bytes again;
  replay_bytes::Writer second(again);
  replay_bytes::write_scene(second, back);
  EXPECT_EQ(again, bytes);
  EXPECT_EQ(back.clay.rows, 77);
  EXPECT_FALSE(back.clay.keep_undo);
  EXPECT_EQ(back.clay.height, def.clay.height);
  EXPECT_EQ(back.kiln->glaze_thickness, def.kiln->glaze_thickness);
}

TEST(ReplayScene, AnEffectOrANumberThatThisEngineDoesNotHaveIsNamed) {
  for (const auto& [name, where] :
       {std::pair{"friction", "frictiom"}, std::pair{"wet_factor", "friction.wet_factom"}}) {
    Bytes bytes = written(SceneDef());
    const auto at = find(bytes, name);
    ASSERT_NE(at, bytes.end());
    *(at + static_cast<std::ptrdiff_t>(std::string(name).size()) - 1) = std::byte{'m'};
    const Result<Replay> replay = read(bytes);
    ASSERT_FALSE(replay);
    EXPECT_NE(replay.error().what.find(where), std::string::npos) << replay.error().what;
    EXPECT_EQ(replay.error().exit_code, 2);
  }
}

// As a visit of version 12 has it: the old name of walls' strength, and no columns.
TEST(ReplayScene, AKeyOfBeforeIsReadAsWhatItIsCalledNow) {
  SceneDef def;
  def.walls.emplace();
  def.walls->bending_strength = 9000.0;
  Bytes bytes;
  replay_bytes::Writer io(bytes);
  std::uint64_t magic = replay_bytes::kMagic, number = 0;
  std::uint32_t version = 12;
  std::uint8_t end = replay_bytes::kEnd;
  io(magic);
  io(version);
  replay_bytes::write_scene(io, def);
  io(number);  // the seed
  io.text("moon_jar", 99);
  io(end);
  io(number);  // the last hash
  const auto at = find(bytes, "bending_strength");
  ASSERT_NE(at, bytes.end());
  const std::string old = "yield_stress";
  *(at - 4) = static_cast<std::byte>(old.size());
  std::transform(old.begin(), old.end(), at, [](char c) { return static_cast<std::byte>(c); });
  const auto rest = at + static_cast<std::ptrdiff_t>(old.size());
  bytes.erase(rest, rest + 4);
  const Result<Replay> replay = read(bytes);
  ASSERT_TRUE(replay) << to_text(replay.error());
  EXPECT_TRUE(replay->earlier_laws);
  EXPECT_EQ(replay->def.walls->bending_strength, 9000.0);
  EXPECT_FALSE(read(written(def))->earlier_laws);
}

// As in a file that is older than the number.
TEST(ReplayScene, ANumberThatIsNotThereHasItsUsualValue) {
  SceneDef def;
  def.friction->wet_factor = 0.5;
  Bytes bytes = written(def);
  ASSERT_EQ(read(bytes)->def.friction->wet_factor, 0.5);
  const auto at = find(bytes, "wet_factor");
  bytes.erase(at - 4, at + 10 + 8);  // its size, its name, its value
  const Result<Replay> replay = read(bytes);
  ASSERT_TRUE(replay) << to_text(replay.error());
  EXPECT_EQ(replay->def.friction->wet_factor, FrictionDef().wet_factor);
}

TEST(ReplayScene, RowsAreWholeAndASwitchIsOnOrOff) {
  for (const std::string key : {"rows", "keep_undo"}) {
    Bytes bytes = written(SceneDef());
    auto at = find(bytes, key) + static_cast<std::ptrdiff_t>(key.size());
    const auto bits = std::bit_cast<std::uint64_t>(40.5);
    for (int n = 0; n < 8; ++n) *at++ = static_cast<std::byte>(bits >> (8 * n));
    EXPECT_FALSE(read(bytes)) << key;
  }
}

}  // namespace
}  // namespace onggi::replay_scene_test
