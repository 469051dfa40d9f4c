#include "kiosk/collection/changes/revisions.h"

#include <fcntl.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/kiosk/exhibit/editing/small_site.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::changes::revisions_test {
namespace {

using namespace editing::test;

/// Keeps a change of `file` from `before` to `after`.
void keep(const fs::path& file, const std::string& before, const std::string& after) {
  Revisions revisions(file);
  ASSERT_TRUE(revisions.lock());
  Revision revision = revision_of(before, after);
  revision.file = file;
  revision.values = {{"credit", "\"도\"", "\"x\"", ""}};
  revisions.tidy();
  ASSERT_TRUE(revisions.keep(revision));
  std::ofstream(file, std::ios::binary) << after;
  revisions.tidy();
}

/// A text of letters of one to four bytes, quotes and ends of lines.
std::string any_text(std::mt19937& random) {
  static const std::vector<std::string> kLetters{
      "a", "b", "\"", "\\", "\n", "\r\n", "é", "도", "기", "器", "\xF0\x9F\x8F\xBA", "#"};
  std::string out;
  for (std::size_t n = random() % 8; n > 0; --n) out += kLetters[random() % kLetters.size()];
  return out;
}

TEST(revisions, any_change_of_any_letters_is_read_back_and_taken_back) {
  const files::test::ScratchFolder folder;
  const fs::path file = folder / "a.toml";
  std::mt19937 random(46);
  for (int n = 0; n < 200; ++n) {
    const std::string begin = any_text(random), end = any_text(random);
    const std::string before = begin + any_text(random) + end,
                      after = begin + any_text(random) + end;
    if (before == after) continue;
    std::ofstream(file, std::ios::binary) << before;
    keep(file, before, after);
    const auto all = Revisions(file).read();
    ASSERT_FALSE(all.empty()) << before << " -> " << after;
    EXPECT_EQ(all.front().taken_from(after), before);
    EXPECT_EQ(all.front().taken_from(after + "x"), std::nullopt);
    EXPECT_FALSE(all.front().not_carried_out(after));
  }
}

TEST(revisions, of_more_than_twenty_the_newest_twenty_are_kept) {
  const files::test::ScratchFolder folder;
  const fs::path file = folder / "a.toml";
  std::ofstream(file) << "n = 0\n";
  for (int n = 0; n < 25; ++n)
    keep(file, "n = " + std::to_string(n) + "\n", "n = " + std::to_string(n + 1) + "\n");
  const auto all = Revisions(file).read();
  ASSERT_EQ(all.size(), Revisions::kKept);
  EXPECT_EQ(all.front().taken_from("n = 25\n"), "n = 24\n");
  EXPECT_EQ(all.back().taken_from("n = 6\n"), "n = 5\n");
}

TEST(revisions, lie_beside_config_and_content_and_keep_a_versioned_exhibit_clean) {
  const SmallSite site;
  for (const char* file :
       {"config/exhibit.toml", "config/scenes/studio.toml", "content/vessels/moon_jar/vessel.toml"})
    EXPECT_EQ(Revisions(site / file).folder(),
              files::test::fs::canonical(site.path()) / "revisions");
  Revisions revisions(site.exhibit());
  ASSERT_TRUE(revisions.lock());
  EXPECT_EQ(content(site / "revisions/.gitignore"), "*\n");
  const files::test::ScratchFolder other;
  EXPECT_EQ(Revisions(other / "a.toml").folder(), fs::canonical(other.path()) / "revisions");
}

TEST(revisions, move_with_their_exhibit) {
  const files::test::ScratchFolder folder;
  fs::create_directories(folder / "one/config");
  fs::create_directories(folder / "one/content");
  std::ofstream(folder / "one/config/exhibit.toml") << "n = 1\n";
  keep(folder / "one/config/exhibit.toml", "n = 1\n", "n = 2\n");
  fs::rename(folder / "one", folder / "two");
  const auto all = Revisions(folder / "two/config/exhibit.toml").read();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].file, fs::canonical(folder / "two/config/exhibit.toml"));
}

TEST(revisions, that_are_damaged_are_left_out_and_in_nobodys_way) {
  const files::test::ScratchFolder folder;
  const fs::path file = folder / "a.toml";
  std::ofstream(file) << "n = 1\n";
  keep(file, "n = 1\n", "n = 2\n");
  std::ofstream(folder / "revisions/00000002.toml") << "file = [";
  std::ofstream(folder / "revisions/notes.toml") << "";
  EXPECT_EQ(Revisions(file).read().size(), 1u);
  keep(file, "n = 2\n", "n = 3\n");
  const auto all = Revisions(file).read();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].taken_from("n = 3\n"), "n = 2\n");
}

// Two at one time would both read the old file.
TEST(revisions, are_locked_by_one_process_at_a_time) {
  const files::test::ScratchFolder folder;
  std::ofstream(folder / "a.toml") << "n = 1\n";
  int go[2], ready[2];
  ASSERT_EQ(::pipe(go), 0);
  ASSERT_EQ(::pipe(ready), 0);
  // The other process begins before the lock, or it would own it too.
  const pid_t other = ::fork();
  if (other == 0) {
    ::alarm(20);
    char begin = 0;
    Revisions its(folder / "a.toml");
    const bool locked = ::read(go[0], &begin, 1) == 1 && its.lock();
    ::_exit(locked && ::write(ready[1], "x", 1) == 1 ? 0 : 1);
  }
  ::fcntl(ready[0], F_SETFL, O_NONBLOCK);
  char got = 0;
  {
    Revisions mine(folder / "a.toml");
    ASSERT_TRUE(mine.lock());
    ASSERT_EQ(::write(go[1], "x", 1), 1);
    ::usleep(200'000);
    EXPECT_EQ(::read(ready[0], &got, 1), -1);
  }
  int status = -1;
  ::waitpid(other, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(::read(ready[0], &got, 1), 1);
}

}  // namespace
}  // namespace onggi::changes::revisions_test
