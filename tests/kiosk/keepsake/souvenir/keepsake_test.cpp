#include "kiosk/keepsake/souvenir/keepsake.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <map>
#include <random>
#include <span>
#include <vector>

#include "kiosk/ground/files/clock_jump.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/ground/files/zstandard.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::souvenir::keepsake_test {
namespace {

using namespace files::test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Keepsake keepsake(const std::string& name = "2026-05-04_141503_moon_jar") {
  Keepsake k;
  k.name = name;
  k.postcard = {50, 70, std::vector<std::uint8_t>(50 * 70 * 4, 200)};
  k.caption = {"My pot, inspired by: Moon jar", "Museum of Jars", "Joseon"};
  k.glb = {std::byte{'g'}, std::byte{'l'}};
  k.replay = {std::byte{'r'}};
  return k;
}

/// A visit of the past with `kilobytes` in it.
void put_visit(const fs::path& folder, const std::string& name, std::size_t kilobytes) {
  fs::create_directories(folder / name);
  std::ofstream(folder / name / "postcard.png") << std::string(kilobytes * 1000, 'x');
}

TEST(keepsake, a_visit_is_a_folder_with_each_thing_once) {
  const ScratchFolder scratch;
  const auto files = save(keepsake(), scratch.path() / "keepsakes", {100});
  ASSERT_TRUE(files) << to_text(files.error());
  EXPECT_EQ(files->folder, scratch.path() / "keepsakes/2026-05-04_141503_moon_jar");
  EXPECT_THAT(names_in(files->folder), ElementsAre("postcard.jpg", "pot.glb", "visit.onggi"));
  EXPECT_TRUE(files->print.empty()) << "the postcard has no code, so it is what the desk prints";
  for (const fs::path& file : {files->postcard, files->glb, files->replay}) {
    EXPECT_TRUE(fs::is_regular_file(file)) << file;
    EXPECT_GT(fs::file_size(file), 0u);
  }
  EXPECT_THAT(names_in(scratch.path() / "keepsakes"), ElementsAre("2026-05-04_141503_moon_jar"));
}

TEST(keepsake, its_name_is_kept_with_it_and_found_again_the_newest_first) {
  const ScratchFolder scratch;
  Keepsake k = keepsake();
  k.spoken = "quiet-blue-heron";
  const auto files = save(k, scratch.path(), {100});
  ASSERT_TRUE(files) << to_text(files.error());
  EXPECT_EQ(files->spoken, "quiet-blue-heron");
  put_visit(scratch.path(), "2026-06-04_141503_unnamed", 1);
  put_visit(scratch.path(), "2026-06-04_141503_going.partial", 1);
  fs::create_directory(scratch.path() / "2026-06-04_141503_photos");
  std::ofstream(scratch.path() / "2026-06-04_141503_photos/of mine.txt") << "x";
  std::ofstream(scratch.path() / "2026-05-04_141503_moon_jar/note.txt") << "the desk's own";
  const auto found = named_visits(scratch.path());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].visit, "2026-06-04_141503_unnamed");
  EXPECT_EQ(found[0].spoken, "");
  EXPECT_EQ(found[1].visit, "2026-05-04_141503_moon_jar");
  EXPECT_EQ(found[1].spoken, "quiet-blue-heron");
  ASSERT_TRUE(remove_visit(scratch.path() / found[1].visit));
  EXPECT_EQ(named_visits(scratch.path()).size(), 1u);
}

TEST(keepsake, what_is_empty_is_not_written) {
  const ScratchFolder scratch;
  Keepsake k = keepsake();
  k.replay.clear();
  k.glb.clear();
  const auto files = save(k, scratch.path(), {100});
  ASSERT_TRUE(files);
  EXPECT_TRUE(files->replay.empty() && files->glb.empty());
  EXPECT_THAT(names_in(files->folder), ElementsAre("postcard.jpg"));
}

TEST(keepsake, a_decorated_pot_has_its_model_made_of_its_picture_and_its_outside_unrolled) {
  const ScratchFolder scratch;
  Keepsake k = keepsake();
  k.glb.clear();
  const auto grey = [](int height, std::uint8_t value) {
    return view::Image{64, height, std::vector<std::uint8_t>(64u * height * 4u, value)};
  };
  Painted::Pictures got;
  k.painted = Painted{grey(32, 90),
                      grey(16, 90),
                      grey(20, 90),
                      [&] { return grey(32, 128); },
                      [&](Painted::Pictures jpegs) {
                        got = std::move(jpegs);
                        return std::vector<std::byte>{std::byte{'m'}};
                      },
                      [](std::span<const std::byte> model) {
                        EXPECT_EQ(model.size(), 1u) << "of this GLB";
                        return std::vector<std::byte>(2, std::byte{'r'});
                      },
                      [&](const std::string& spoken) {
                        EXPECT_EQ(spoken, "quiet-blue-heron");
                        return grey(44, 200);
                      }};
  k.spoken = "quiet-blue-heron";
  const auto files = save(k, scratch.path(), {100});
  ASSERT_TRUE(files) << to_text(files.error());
  EXPECT_THAT(names_in(files->folder),
              ElementsAre("name.txt", "postcard.jpg", "pot.glb", "relief.onggi", "rollout.jpg",
                          "sheet.jpg", "visit.onggi"));
  EXPECT_GT(fs::file_size(files->folder / "sheet.jpg"), 100u);
  EXPECT_EQ(fs::file_size(files->folder / "relief.onggi"), 2u);
  for (const auto& jpeg : {got.skin, got.roughness, got.normals}) {
    ASSERT_GT(jpeg.size(), 2u);
    EXPECT_EQ(jpeg[0], std::byte{0xFF});
    EXPECT_EQ(jpeg[1], std::byte{0xD8}) << "a JPEG";
  }
  EXPECT_NE(got.skin, got.normals);
  EXPECT_EQ(fs::file_size(files->glb), 1u);
  EXPECT_EQ(files->rollout, files->folder / "rollout.jpg");
  EXPECT_GT(fs::file_size(files->rollout), 100u);
  EXPECT_EQ(visits_in(scratch.path()).size(), 1u) << "it is ours, so it is tidied with the rest";
}

TEST(keepsake, two_visits_of_one_name_are_both_kept) {
  const ScratchFolder scratch;
  ASSERT_TRUE(save(keepsake(), scratch.path(), {100}));
  ASSERT_TRUE(save(keepsake(), scratch.path(), {100}));
  fs::create_directories(scratch.path() / "2026-05-04_141503_moon_jar_3.partial");
  ASSERT_TRUE(save(keepsake(), scratch.path(), {100}));
  EXPECT_THAT(names_in(scratch.path()),
              ElementsAre("2026-05-04_141503_moon_jar", "2026-05-04_141503_moon_jar_2",
                          "2026-05-04_141503_moon_jar_3.partial", "2026-05-04_141503_moon_jar_4"));
}

TEST(keepsake, a_vessels_name_can_never_lead_out_of_the_folder) {
  const ScratchFolder scratch;
  const auto files =
      save(keepsake("2026-05-04_141503_../../etc/my jar\n달"), scratch.path() / "k", {100});
  ASSERT_TRUE(files);
  EXPECT_EQ(files->folder.parent_path(), scratch.path() / "k");
  EXPECT_EQ(files->folder.filename(), "2026-05-04_141503_.._.._etc_my_jar____");
  EXPECT_THAT(names_in(scratch.path()), ElementsAre("k"));
  EXPECT_FALSE(save(keepsake("moon_jar"), scratch.path() / "k", {100})) << "no date, no visit";
}

TEST(keepsake, names_of_visits_begin_with_their_time_and_never_end_as_partial) {
  EXPECT_TRUE(is_visit_name("2026-05-04_141503_a"));
  for (const char* name : {"", "2026-05-04_141503_", "2026-05-04_14150_a", "x026-05-04_141503_a",
                           "photos", "2026-05-04"}) {
    EXPECT_FALSE(is_visit_name(name)) << name;
  }
  EXPECT_EQ(visit_name("2026-05-04_141503_a.partial"), "2026-05-04_141503_a_partial");
  EXPECT_EQ(visit_name("2026-05-04_141503_" + std::string(500, 'x')).size(), 120u);
}

TEST(keepsake, the_oldest_visits_go_when_the_quota_is_reached) {
  const ScratchFolder scratch;
  put_visit(scratch.path(), "2026-01-01_100000_a", 6000);
  put_visit(scratch.path(), "2026-01-02_100000_b", 3000);
  put_visit(scratch.path(), "2026-01-03_100000_c", 3000);
  ASSERT_TRUE(save(keepsake(), scratch.path(), {10}));
  EXPECT_THAT(names_in(scratch.path()), ElementsAre("2026-01-02_100000_b", "2026-01-03_100000_c",
                                                    "2026-05-04_141503_moon_jar"));
}

TEST(keepsake, only_a_visitor_with_a_page_gets_a_card_with_its_code_and_the_replay_is_packed) {
  const ScratchFolder scratch;
  Keepsake k = keepsake();
  k.replay.assign(100'000, std::byte{7});
  k.phone = ByPhone{*Passes::new_token(), 24.0, "en", k.postcard};
  const auto files = save(k, scratch.path(), {100});
  ASSERT_TRUE(files) << to_text(files.error());
  EXPECT_THAT(names_in(files->folder),
              ElementsAre("postcard.jpg", "pot.glb", "print.jpg", "visit.onggi"));
  EXPECT_LT(fs::file_size(files->replay), 1000u);
  const auto frame = files::read_file(files->replay, 1000);
  ASSERT_TRUE(frame);
  EXPECT_EQ(files::unpacked(std::as_bytes(std::span(*frame)), 200'000), k.replay);
}

// A pot was removed within hours on a good day, though its page promised a day.
TEST(keepsake, the_quota_takes_no_visit_whose_page_is_promised_and_the_next_oldest_instead) {
  const ScratchFolder scratch;
  const std::time_t now = std::time(nullptr);
  for (const char* name :
       {"2026-01-01_100000_a", "2026-01-02_100000_b", "2026-01-03_100000_c", "2026-01-04_100000_d"})
    put_visit(scratch.path(), name, 4000);
  const Passes passes(scratch.path());
  ASSERT_TRUE(passes.give("2026-01-01_100000_a", now, 24));
  ASSERT_TRUE(passes.give("2026-01-01_100000_a", now - 12 * 3600, 24));
  ASSERT_TRUE(passes.give("2026-01-02_100000_b", now - 26 * 3600, 24));
  ASSERT_TRUE(passes.give("2026-01-03_100000_c", now, 24));
  ASSERT_TRUE(tidy(scratch.path(), {10}, {}, now));
  EXPECT_THAT(names_in(scratch.path()),
              ElementsAre("2026-01-01_100000_a", "2026-01-03_100000_c", "phone"));
  ASSERT_TRUE(tidy(scratch.path(), {5}, {}, now));
  EXPECT_THAT(names_in(scratch.path()),
              ElementsAre("2026-01-01_100000_a", "2026-01-03_100000_c", "phone"));
  // No visits since: the clock alone is not believed (PassAges).
  ASSERT_TRUE(tidy(scratch.path(), {5}, {}, now + 25 * 3600));
  EXPECT_THAT(names_in(scratch.path()),
              ElementsAre("2026-01-01_100000_a", "2026-01-03_100000_c", "phone"));
  ASSERT_TRUE(passes.give("2026-01-04_100000_d", now + 12 * 3600, 24));
  ASSERT_TRUE(tidy(scratch.path(), {5}, {}, now + 25 * 3600));
  EXPECT_THAT(names_in(scratch.path()), ElementsAre("2026-01-03_100000_c", "phone"));
}

TEST(keepsake, the_visit_just_made_stays_even_with_a_clock_that_was_set_back) {
  const ScratchFolder scratch;
  put_visit(scratch.path(), "2031-01-01_100000_a", 12000);
  ASSERT_TRUE(save(keepsake("1970-01-01_000000_jar"), scratch.path(), {10}));
  EXPECT_THAT(names_in(scratch.path()), ElementsAre("1970-01-01_000000_jar"));
}

TEST(keepsake, nothing_that_save_did_not_write_is_ever_removed) {
  const ScratchFolder scratch, elsewhere;
  put_visit(scratch.path(), "photos", 20000);
  put_visit(scratch.path(), "2026-01-01_100000_with_a_note", 20000);
  std::ofstream(scratch.path() / "2026-01-01_100000_with_a_note/thanks.txt") << "keep me";
  put_visit(scratch.path(), "2026-01-01_100000_with_a_folder", 20000);
  fs::create_directories(scratch.path() / "2026-01-01_100000_with_a_folder/pot.stl");
  std::ofstream(scratch.path() / "2026-01-02_100000_a_file") << "x";
  put_visit(elsewhere.path(), "visit", 20000);
  fs::create_directory_symlink(elsewhere.path() / "visit",
                               scratch.path() / "2026-01-03_100000_a_link");
  put_visit(scratch.path(), "photos.partial", 1);
  fs::last_write_time(scratch.path() / "photos.partial",
                      fs::file_time_type::clock::now() - std::chrono::hours(48));
  const auto before = names_in(scratch.path());
  EXPECT_TRUE(tidy(scratch.path(), {10, 1}));
  EXPECT_EQ(names_in(scratch.path()), before);
  EXPECT_TRUE(fs::exists(elsewhere.path() / "visit/postcard.png"));
}

TEST(keepsake, a_visit_goes_when_its_days_are_over_and_no_folder_of_the_staffs_does) {
  const ScratchFolder scratch;
  const std::time_t now = std::time(nullptr);
  const auto put = [&](int days, int seconds, const std::string& vessel) {
    const std::time_t at = now - std::time_t{86400} * days - seconds;
    put_visit(scratch.path(), files::local_time(at, files::kStamp) + "_" + vessel, 1);
    return files::local_time(at, files::kStamp) + "_" + vessel;
  };
  put(40, 0, "long_over");
  put(7, 60, "over");
  const std::string not_yet = put(7, -60, "not_yet"), noted = put(30, 0, "with_a_note");
  std::ofstream(scratch.path() / noted / "thanks.txt") << "keep me";
  put_visit(scratch.path(), "photos", 1);
  ASSERT_TRUE(tidy(scratch.path(), {100, 0})) << "0: never by age";
  EXPECT_EQ(names_in(scratch.path()).size(), 5u);
  ASSERT_TRUE(tidy(scratch.path(), {100, 7}));
  EXPECT_THAT(names_in(scratch.path()), ElementsAre(noted, not_yet, "photos"));
  ASSERT_TRUE(save(keepsake("1999-05-04_141503_moon_jar"), scratch.path(), {100, 7}));
  EXPECT_TRUE(fs::exists(scratch.path() / "1999-05-04_141503_moon_jar"))
      << "whoever just made it may ask for it, whatever the clock says";
}

// Ten years ahead by mistake, and set right within the day: nobody's keepsake has gone.
TEST(keepsake, a_clock_that_leapt_years_ahead_takes_nothing_until_it_has_gone_on_for_a_day) {
  const ScratchFolder scratch;
  constexpr std::time_t kDay = 86400, kThen = 1'800'000'000, kNow = kThen + 3650 * kDay;
  const auto visits_after = [&](std::time_t made, std::time_t now) {
    put_visit(scratch.path(), files::local_time(made, files::kStamp) + "_jar", 1);
    EXPECT_TRUE(tidy(scratch.path(), {100, 7}, {}, now));
    return names_in(scratch.path()).size();
  };
  EXPECT_EQ(visits_after(kThen - kDay, kThen), 1u);
  EXPECT_EQ(visits_after(kThen, kThen), 2u);
  EXPECT_EQ(visits_after(kNow, kNow), 3u) << "the first one since the leap";
  EXPECT_EQ(visits_after(kNow + kDay / 2, kNow + kDay - 1), 4u);
  EXPECT_EQ(visits_after(kNow + kDay, kNow + kDay), 3u) << "now the clock is believed";
}

// A visit every half an hour over both nights on which the clocks are set, one of which has an hour
// twice: its names do not tell its order, and a visit goes an hour early or late at the most.
TEST(keepsake, the_nights_of_summer_time_take_no_visit_before_its_day_is_over) {
  EXPECT_EQ(in_child([] {
              ::setenv("TZ", "CET-1CEST,M3.5.0,M10.5.0/3", 1);
              ::tzset();
              constexpr std::time_t kHour = 3600;
              bool right = true;
              for (const char* noon : {"2026-03-28_120000", "2026-10-24_120000"}) {
                const ScratchFolder scratch;
                const std::time_t first = *files::time_of_stamp(noon);
                std::map<std::string, std::time_t> made;
                for (std::time_t now = first; now < first + 72 * kHour; now += kHour / 2) {
                  std::string name = files::local_time(now, files::kStamp) + "_jar";
                  while (made.count(name) > 0) name += "_2";
                  made[name] = now;
                  put_visit(scratch.path(), name, 1);
                  right &= tidy(scratch.path(), {100, 1}, {}, now).has_value();
                  const auto left = names_in(scratch.path());
                  for (const auto& [visit, at] : made) {
                    const bool there = std::find(left.begin(), left.end(), visit) != left.end();
                    if (now - at < 23 * kHour) right &= there;
                    if (now - at > 25 * kHour) right &= !there;
                  }
                }
              }
              return right;
            }),
            0);
}

TEST(keepsake, what_was_to_go_and_could_not_is_told_and_the_rest_goes) {
  const ScratchFolder scratch;
  const auto days_ago = [](std::time_t days) {
    return files::local_time(std::time(nullptr) - days * 86400, files::kStamp) + "_jar";
  };
  const std::string first = days_ago(60);
  put_visit(scratch.path(), first, 1);
  put_visit(scratch.path(), days_ago(59), 1);
  // Where the first is to be moved there is something already.
  fs::create_directories(scratch.path() / (first + ".partial/a_note"));
  const auto tidied = tidy(scratch.path(), {100, 7});
  ASSERT_FALSE(tidied);
  EXPECT_EQ(tidied.error().where, (scratch.path() / first).string());
  EXPECT_EQ(tidied.error().exit_code, 1);
  EXPECT_THAT(names_in(scratch.path()), ElementsAre(first, first + ".partial"));
}

// After a flat battery: its name and its files have the date of the clock that was wrong.
TEST(keepsake, a_visit_made_by_a_clock_years_back_has_its_days_from_when_the_clock_is_right) {
  const ScratchFolder scratch;
  const fs::path visit = scratch.path() / "2001-05-04_141503_jar";
  const auto now = fs::file_time_type::clock::now();
  put_visit(scratch.path(), visit.filename(), 1);
  fs::last_write_time(visit, now - std::chrono::hours(24 * 365 * 26));
  for (int day = 0; day < 2; ++day) {
    ASSERT_TRUE(tidy(scratch.path(), {100, 7}));
    EXPECT_TRUE(fs::exists(visit)) << day;
  }
  fs::last_write_time(visit, now - std::chrono::hours(24 * 7 - 1));
  ASSERT_TRUE(tidy(scratch.path(), {100, 7}));
  EXPECT_TRUE(fs::exists(visit)) << "its days are not over";
  fs::last_write_time(visit, now - std::chrono::hours(24 * 7 + 1));
  ASSERT_TRUE(tidy(scratch.path(), {100, 7}));
  EXPECT_FALSE(fs::exists(visit));
  put_visit(scratch.path(), visit.filename(), 2000);
  ASSERT_TRUE(tidy(scratch.path(), {1, 7}));
  EXPECT_FALSE(fs::exists(visit)) << "the quota goes by the name as ever";
}

TEST(keepsake, leftovers_of_a_power_cut_go_after_an_hour) {
  const ScratchFolder scratch;
  const auto now = fs::file_time_type::clock::now();
  const auto leftover = [&](const std::string& name, std::chrono::minutes age) {
    put_visit(scratch.path(), name, 1);
    std::ofstream(scratch.path() / name / ".pot.stl.12-3.part") << "half";
    fs::last_write_time(scratch.path() / name, now - age);
  };
  leftover("2026-01-01_100000_old.partial", std::chrono::minutes(61));
  leftover("2026-01-01_100000_at_work.partial", std::chrono::minutes(5));
  leftover("2026-01-01_100000_from_the_future.partial", std::chrono::minutes(-500));
  ASSERT_TRUE(tidy(scratch.path(), {100}));
  EXPECT_THAT(names_in(scratch.path()), ElementsAre("2026-01-01_100000_at_work.partial",
                                                    "2026-01-01_100000_from_the_future.partial"));
}

TEST(keepsake, tidying_a_folder_that_is_not_there_is_no_fault) {
  EXPECT_TRUE(tidy("/nowhere/at/all", {10, 1}));
}

/// Bytes that do not pack.
std::vector<std::byte> unlike_bytes(std::size_t count) {
  std::mt19937 random(7);
  std::vector<std::byte> bytes(count);
  for (std::byte& b : bytes) b = static_cast<std::byte>(random() & 0xffu);
  return bytes;
}

TEST(keepsake, a_disk_that_fills_leaves_no_half_visit) {
  const ScratchFolder scratch;
  const int status = on_a_disk(scratch.path(), 0, "size=24k", [&] {
    Keepsake k = keepsake();
    k.replay = unlike_bytes(100000);
    const auto files = save(k, scratch.path(), {100});
    return !files && files.error().what == "The disk is full." && names_in(scratch.path()).empty();
  });
  if (WEXITSTATUS(status) == kNoMounts) GTEST_SKIP() << "a disk of our own is not allowed here";
  EXPECT_EQ(status, 0);
}

TEST(keepsake, an_end_in_the_middle_leaves_the_visit_absent) {
  const ScratchFolder scratch;
  const int status = in_child([&] {
    Keepsake k = keepsake();
    k.replay = unlike_bytes(100000);
    const rlimit limit{50000, 50000};  // the replay comes last: its signal ends us
    ::setrlimit(RLIMIT_FSIZE, &limit);
    return save(k, scratch.path(), {100}).has_value();
  });
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGXFSZ);
  EXPECT_THAT(names_in(scratch.path()), ElementsAre("2026-05-04_141503_moon_jar.partial"));
  ASSERT_TRUE(save(keepsake(), scratch.path(), {100})) << "the next visit is kept all the same";
}

TEST(keepsake, a_file_in_the_folders_place_is_told) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "keepsakes") << "x";
  const auto files = save(keepsake(), scratch.path() / "keepsakes", {100});
  ASSERT_FALSE(files);
  EXPECT_EQ(files.error().exit_code, 1);
  EXPECT_EQ(files.error().where, (scratch.path() / "keepsakes").string());
}

}  // namespace
}  // namespace onggi::souvenir::keepsake_test
