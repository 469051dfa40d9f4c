#include "kiosk/program/watch/run_history.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/kiosk/ground/files/disk.h"

namespace onggi::watch::run_history_test {
namespace {

using files::test::ScratchFolder;

/// A run that lasts `seconds` and then crashes: nothing says that it ended.
void crash_after(const ScratchFolder& state, double seconds) {
  RunHistory ledger(state.path());
  ASSERT_TRUE(ledger.begin());
  ASSERT_TRUE(ledger.lasted(seconds));
}

int crashes_before(const ScratchFolder& state) { return RunHistory(state.path()).crashes(); }

TEST(run_ledger, the_fifth_run_after_four_crashes_at_the_start_is_safe) {
  const ScratchFolder state;
  for (int run = 0; run < RunHistory::kMostCrashes; ++run) {
    EXPECT_FALSE(RunHistory(state.path()).safe()) << run;
    crash_after(state, 0.0);
  }
  EXPECT_TRUE(RunHistory(state.path()).safe());
}

TEST(run_ledger, a_run_that_is_asked_to_end_is_no_crash) {
  const ScratchFolder state;
  crash_after(state, 1.0);
  crash_after(state, 1.0);
  RunHistory ledger(state.path());
  ASSERT_TRUE(ledger.begin());
  ASSERT_TRUE(ledger.ended());
  EXPECT_EQ(crashes_before(state), 0);
}

TEST(run_ledger, a_steady_run_that_crashes_at_last_is_forgiven_with_those_before) {
  const ScratchFolder state;
  crash_after(state, 1.0);
  crash_after(state, RunHistory::kSteady - 1.0);
  EXPECT_EQ(crashes_before(state), 2);
  crash_after(state, RunHistory::kSteady);
  EXPECT_EQ(crashes_before(state), 0);
}

TEST(run_ledger, what_a_run_shows_it_goes_on_showing_once_it_is_steady) {
  const ScratchFolder state;
  for (int run = 0; run < RunHistory::kMostCrashes; ++run) crash_after(state, 0.0);
  RunHistory ledger(state.path());
  ASSERT_TRUE(ledger.begin());
  ASSERT_TRUE(ledger.lasted(2 * RunHistory::kSteady));
  EXPECT_TRUE(ledger.safe());
  EXPECT_EQ(crashes_before(state), 0);
}

TEST(run_ledger, a_damaged_ledger_begins_anew_and_crashes_are_counted_again) {
  for (const std::string damage : {"", "onggi-runs", "onggi-runs 1 running 1 crashes 3",
                                   "onggi-runs 1 running 1 crashes -3.\n",
                                   "onggi-runs 2 running 1 crashes 3.\n", "\xff\xfe\0\1"}) {
    const ScratchFolder state;
    std::ofstream(state.path() / "runs") << damage;
    EXPECT_EQ(crashes_before(state), 0) << damage;
    crash_after(state, 0.0);
    EXPECT_EQ(crashes_before(state), 1) << damage;
  }
}

TEST(run_ledger, the_count_of_years_of_crashes_stays_a_number) {
  const ScratchFolder state;
  std::ofstream(state.path() / "runs") << "onggi-runs 1 running 1 crashes 9999.\n";
  EXPECT_EQ(crashes_before(state), 1001);
  crash_after(state, 0.0);
  EXPECT_EQ(crashes_before(state), 1001);
}

}  // namespace
}  // namespace onggi::watch::run_history_test
