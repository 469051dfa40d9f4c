#include "kiosk/lab/measure/stability.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::measure::stability_test {
namespace {

using files::test::content;
using files::test::ScratchFolder;

StabilityPlan short_night(const ScratchFolder& folder, double ticks) {
  StabilityPlan plan;
  plan.ticks = ticks;
  plan.seed = 5;
  plan.threads = 2;
  plan.folder = folder / "night";
  return plan;
}
std::string progress(const ScratchFolder& folder) {
  return content(folder / "night" / "seed_5.txt");
}

TEST(StabilityNight, RunsAtLeastTheTicksThatAreAskedForAndFindsNothing) {
  const ScratchFolder folder;
  const auto tally = measure_stability(short_night(folder, 30'000), stderr);
  ASSERT_TRUE(tally) << to_text(tally.error());
  EXPECT_GE(tally->ticks, 30'000u);
  EXPECT_GT(tally->trials, 2u);
  EXPECT_TRUE(tally->finds.empty());
  EXPECT_FALSE(tally->interrupted);
  EXPECT_EQ(progress(folder), text_of(*tally));
}

TEST(StabilityNight, GoesOnWhereItWasAndComesToWhatOneRunComesTo) {
  const ScratchFolder folder, other;
  StabilityPlan plan = short_night(folder, 20'000);
  plan.threads = 1;
  const auto half = measure_stability(plan, stderr);
  ASSERT_TRUE(half);
  plan.ticks = 60'000;
  const auto all = measure_stability(plan, stderr);
  ASSERT_TRUE(all);
  EXPECT_GT(all->trials, half->trials);
  StabilityPlan once = plan;
  once.folder = other / "night";
  const auto at_once = measure_stability(once, stderr);
  ASSERT_TRUE(at_once);
  EXPECT_EQ(text_of(*all), text_of(*at_once));
}

TEST(StabilityNight, InterruptedItKeepsWhatIsDone) {
  const ScratchFolder folder;
  StabilityPlan plan = short_night(folder, 1e15);
  // Once its progress file is there its answer to the signal is, too, within
  // the moment.
  std::thread hand([&] {
    while (progress(folder).empty()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    ::kill(::getpid(), SIGTERM);
  });
  const auto tally = measure_stability(plan, stderr);
  hand.join();
  ASSERT_TRUE(tally) << to_text(tally.error());
  EXPECT_TRUE(tally->interrupted);
  EXPECT_EQ(progress(folder), text_of(*tally));
}

TEST(StabilityNight, RefusesProgressThatIsNoneAndAnotherSeeds) {
  const ScratchFolder folder;
  const StabilityPlan plan = short_night(folder, 1000);
  std::filesystem::create_directories(plan.folder);
  const auto put = [&](const std::string& text) {
    std::ofstream(plan.folder / "seed_5.txt") << text;
    const auto tally = measure_stability(plan, stderr);
    EXPECT_FALSE(tally) << text;
    return tally ? Problem{} : tally.error();
  };
  EXPECT_NE(put("").what.find("not a progress file"), std::string::npos);
  EXPECT_NE(put("onggi stability, trials of kind 0\n").what.find("not a progress file"),
            std::string::npos);
  StabilityTally tally;
  tally.seed = 6;
  EXPECT_NE(put(text_of(tally)).what.find("another seed"), std::string::npos);
  const std::string good = text_of(tally);
  EXPECT_NE(put(good.substr(0, good.size() - 8)).what.find("are inconsistent"), std::string::npos);
}

TEST(StabilityNight, OneTrialAloneIsWhatItIsAmongTheOthersAndKeepsNoProgress) {
  const ScratchFolder folder;
  StabilityPlan plan = short_night(folder, 1.0);
  plan.threads = 1;
  const auto first = measure_trial(plan, 0);
  const auto second = measure_trial(plan, 1);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->trials, 1u);
  EXPECT_EQ(second->trials, 1u);
  EXPECT_NE(first->ticks, second->ticks);
  EXPECT_FALSE(second->interrupted);
  EXPECT_EQ(progress(folder), "");
  plan.ticks = static_cast<double>(first->ticks) + 1.0;
  const auto night = measure_stability(plan, stderr);
  ASSERT_TRUE(night);
  EXPECT_EQ(night->trials, 2u);
  EXPECT_EQ(night->ticks, first->ticks + second->ticks);
}

TEST(StabilityTallyText, IsReadBackWithAllThatWasFound) {
  StabilityTally tally;
  tally.seed = 12345678901234567890u;
  tally.trials = 7;
  tally.ticks = 99;
  tally.finds = {{3, "same hash", "The same hands left other bits.", "a b/1_3.onggi"},
                 {6, "volume", "There is 1e-5 of the lump's clay more.", "x"}};
  const auto read = read_tally(text_of(tally), "x");
  ASSERT_TRUE(read) << to_text(read.error());
  EXPECT_EQ(read->seed, tally.seed);
  EXPECT_EQ(read->trials, 7u);
  EXPECT_EQ(read->ticks, 99u);
  ASSERT_EQ(read->finds.size(), 2u);
  EXPECT_EQ(read->finds[0].invariant, "same hash");
  EXPECT_EQ(read->finds[0].replay, "a b/1_3.onggi");
  EXPECT_EQ(read->finds[1].trial, 6u);
}

TEST(ReplayCheck, SaysAtWhichTickThePrintedModelBreaksWhat) {
  lab::Trial trial;
  each_effect(trial.def, [](auto& effect) { effect.reset(); });
  trial.def.paper.emplace();
  trial.def.clay.rows = 40;
  trial.def.clay.sectors = 32;
  lab::Stroke away, bad;
  away.ticks = 30;
  bad.hand[0].begins = {{0.0, 0.1, 0.0}, true};
  bad.hand[0].ends = {0.0, 0.1, 0.0};
  trial.strokes = {away, bad};
  const auto broken = Replay::read(lab::replay_of(trial, 31), "x");
  ASSERT_TRUE(broken);
  const auto said = check_replay(*broken);
  ASSERT_FALSE(said);
  EXPECT_EQ(said.error().where, "tick 31");
  EXPECT_EQ(said.error().exit_code, 1);
  const auto whole = Replay::read(lab::replay_of(trial, 30), "x");
  ASSERT_TRUE(whole);
  EXPECT_TRUE(check_replay(*whole));
}

}  // namespace
}  // namespace onggi::measure::stability_test
