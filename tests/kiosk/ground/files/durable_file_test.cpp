#include "kiosk/ground/files/durable_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

#include "kiosk/ground/files/durable_steps.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::files::durable_file_test {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(durable_file, what_was_written_is_there_and_nothing_beside_it) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "a/b/postcard.png";
  EXPECT_FALSE(write_durably(file, bytes("first")));  // it makes no folder unasked
  EXPECT_THAT(names_in(scratch.path()), IsEmpty());
  ASSERT_TRUE(make_folder(file.parent_path()));
  ASSERT_TRUE(write_durably(file, bytes("first")));
  ASSERT_TRUE(write_durably(file, bytes("second, and longer")));
  EXPECT_EQ(content(file), "second, and longer");
  EXPECT_THAT(names_in(file.parent_path()), ElementsAre("postcard.png"));
}

// In a container a process often has the number of the one that was killed before it.
TEST(durable_file, what_a_killed_process_of_the_same_number_left_behind_is_in_nobodys_way) {
  const ScratchFolder scratch;
  for (int n = 0; n < 200; ++n)
    std::ofstream(scratch.path() /
                  (".pot.json." + std::to_string(::getpid()) + "-" + std::to_string(n) + ".part"));
  ASSERT_TRUE(write_durably(scratch.path() / "pot.json", bytes("{}")));
  EXPECT_EQ(content(scratch.path() / "pot.json"), "{}");
}

std::vector<std::string> seen_steps;

// Synced before it is renamed: after a power cut the new name would else lead to no bytes.
TEST(durable_file, its_steps_come_in_the_order_that_survives_a_power_cut) {
  const ScratchFolder scratch;
  seen_steps.clear();
  watch_steps([](std::string_view step) { seen_steps.emplace_back(step); });
  const auto written = write_durably(scratch.path() / "pot.json", bytes("{}"));
  watch_steps(nullptr);
  ASSERT_TRUE(written);
  EXPECT_EQ(seen_steps, std::vector<std::string>(kDurableSteps.begin(), kDurableSteps.end()));
}

// A real process is ended at each step, over an old file and over none.
TEST(durable_file, a_process_that_is_killed_at_any_step_leaves_the_old_file_or_the_new_one) {
  static std::string_view kill_at;
  for (const bool there : {true, false})
    for (std::size_t n = 0; n < kDurableSteps.size(); ++n) {
      const ScratchFolder scratch;
      const fs::path file = scratch.path() / "pot.json";
      if (there) {
        ASSERT_TRUE(write_durably(file, bytes("old")));
      }
      const int status = in_child([&] {
        kill_at = kDurableSteps[n];
        watch_steps([](std::string_view step) {
          if (step == kill_at) ::raise(SIGKILL);
        });
        return write_durably(file, bytes("new, and longer")).has_value();
      });
      ASSERT_TRUE(WIFSIGNALED(status)) << kDurableSteps[n];
      const bool renamed = n >= 4;
      EXPECT_EQ(content(file), renamed ? "new, and longer"
                               : there ? "old"
                                       : "")
          << kDurableSteps[n];
    }
}

TEST(durable_file, an_empty_file_and_a_bare_name_are_files_too) {
  const ScratchFolder scratch;
  const int status = in_child([&] {
    fs::current_path(scratch.path());
    return write_durably("bare", {}).has_value() && fs::file_size("bare") == 0;
  });
  EXPECT_EQ(status, 0);
}

TEST(durable_file, a_file_where_a_folder_should_be_is_told_with_a_remedy) {
  const ScratchFolder scratch;
  ASSERT_TRUE(write_durably(scratch.path() / "keepsakes", bytes("not a folder")));
  const auto written = make_folder(scratch.path() / "keepsakes/visit");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().where, (scratch.path() / "keepsakes").string());
  EXPECT_THAT(written.error().what, HasSubstr("A file is in the place of a folder"));
  EXPECT_EQ(written.error().exit_code, 1);
}

TEST(durable_file, a_folder_in_the_files_place_is_left_alone) {
  const ScratchFolder scratch;
  fs::create_directories(scratch.path() / "postcard.png/inside");
  EXPECT_FALSE(write_durably(scratch.path() / "postcard.png", bytes("x")));
  EXPECT_THAT(names_in(scratch.path()), ElementsAre("postcard.png"));
  EXPECT_TRUE(fs::exists(scratch.path() / "postcard.png/inside"));
}

TEST(durable_file, a_link_stays_and_what_is_no_file_is_not_replaced) {
  const ScratchFolder scratch;
  const fs::path scene = scratch.path() / "scene.toml", link = scratch.path() / "link.toml";
  ASSERT_TRUE(write_durably(scene, bytes("old")));
  fs::create_symlink("scene.toml", link);
  ASSERT_TRUE(write_durably(link, bytes("new")));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(content(scene), "new");
  ASSERT_EQ(::mkfifo((scratch.path() / "pipe").c_str(), 0600), 0);
  EXPECT_FALSE(write_durably(scratch.path() / "pipe", bytes("x")));
  EXPECT_TRUE(fs::is_fifo(scratch.path() / "pipe"));
}

TEST(durable_file, a_limit_on_size_leaves_the_old_file_and_no_temporary_one) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "pot.stl";
  ASSERT_TRUE(write_durably(file, bytes("the old pot")));
  const int status = in_child([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const auto written = write_durably(file, bytes(std::string(5000, 'x')));
    return !written && written.error().exit_code == 1 &&
           written.error().what.find("larger than") != std::string::npos;
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(content(file), "the old pot");
  EXPECT_THAT(names_in(scratch.path()), ElementsAre("pot.stl"));
}

TEST(durable_file, an_end_in_the_middle_of_writing_leaves_the_old_file_whole) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "pot.stl";
  ASSERT_TRUE(write_durably(file, bytes("the old pot")));
  const int status = in_child([&] {
    // The signal of the size limit ends the child between the first byte and the rename.
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    return write_durably(file, bytes(std::string(5000, 'x'))).has_value();
  });
  ASSERT_TRUE(WIFSIGNALED(status));
  ASSERT_EQ(WTERMSIG(status), SIGXFSZ);
  EXPECT_EQ(content(file), "the old pot");
  ASSERT_TRUE(write_durably(file, bytes("the new pot")));
  EXPECT_EQ(content(file), "the new pot");
}

TEST(durable_file, a_full_disk_is_told_and_keeps_the_old_file) {
  const ScratchFolder scratch;
  const int status = on_a_disk(scratch.path(), 0, "size=64k", [&] {
    const fs::path file = scratch.path() / "postcard.png";
    if (!write_durably(file, bytes("old"))) return false;
    const auto written = write_durably(file, bytes(std::string(200000, 'x')));
    return !written && written.error().what == "The disk is full." && content(file) == "old" &&
           names_in(scratch.path()).size() == 1;
  });
  if (WEXITSTATUS(status) == kNoMounts) GTEST_SKIP() << "a disk of our own is not allowed here";
  EXPECT_EQ(status, 0);
}

TEST(durable_file, a_disk_that_is_read_only_is_told) {
  const ScratchFolder scratch;
  const int status = on_a_disk(scratch.path(), MS_RDONLY, "size=64k", [&] {
    const auto written = write_durably(scratch.path() / "postcard.png", bytes("x"));
    return !written && written.error().what == "The disk is mounted read-only.";
  });
  if (WEXITSTATUS(status) == kNoMounts) GTEST_SKIP() << "a disk of our own is not allowed here";
  EXPECT_EQ(status, 0);
}

TEST(durable_file, a_folder_of_someone_else_is_told_with_the_users_number) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become someone else";
  const ScratchFolder scratch;
  fs::permissions(scratch.path(),
                  fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec);
  const int status = in_child([&] {
    if (::setuid(12345) != 0) return false;
    const auto written = write_durably(scratch.path() / "postcard.png", bytes("x"));
    return !written && written.error().what == "The kiosk's user may not write here." &&
           written.error().remedy.find("12345") != std::string::npos;
  });
  EXPECT_EQ(status, 0);
}

TEST(durable_file, every_disk_error_has_a_meaning_and_a_remedy) {
  for (const int error :
       {ENOSPC, EDQUOT, EFBIG, EROFS, EACCES, EPERM, ENOTDIR, EISDIR, ENAMETOOLONG, EIO, EMFILE}) {
    const Problem p = disk_problem("keepsakes/visit/pot.stl", "write", error);
    EXPECT_EQ(p.where, "keepsakes/visit/pot.stl");
    EXPECT_FALSE(p.what.empty());
    EXPECT_TRUE(p.remedy.ends_with("."));
    EXPECT_EQ(p.exit_code, 1);
  }
}

}  // namespace
}  // namespace onggi::files::durable_file_test
