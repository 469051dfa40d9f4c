#include "kiosk/ground/web/received_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "tests/kiosk/ground/files/disk.h"

namespace onggi::web::received_file_test {
namespace {

using files::test::content;
using files::test::names_in;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class ReceivedFileTest : public ::testing::Test {
 protected:
  std::shared_ptr<ReceivedFile> made() const {
    return ReceivedFile::make({.folder = scratch_.path(), .most = 100}).value();
  }
  std::vector<std::string> files() const { return names_in(scratch_.path()); }
  files::test::ScratchFolder scratch_;
};

TEST_F(ReceivedFileTest, GoesWithWhoeverHasItAndStaysWhereItWasMovedTo) {
  const std::filesystem::path to = scratch_ / "scan.ply";
  std::ofstream(to) << "the one before";
  {
    const auto kept = made(), dropped = made();
    EXPECT_THAT(files(), SizeIs(3));
    EXPECT_TRUE(kept->append(files::test::bytes("ply")));
    EXPECT_EQ(kept->size(), 3u);
    EXPECT_FALSE(kept->move_to(scratch_ / "none/scan.ply"));
    EXPECT_TRUE(std::filesystem::exists(kept->path())) << "it stays";
    ASSERT_TRUE(kept->move_to(to));
  }
  EXPECT_THAT(files(), ElementsAre("scan.ply"));
  EXPECT_EQ(content(to), "ply");
}

TEST_F(ReceivedFileTest, IsForThisUserAloneAndNeverAnotherFile) {
  const auto first = made(), second = made();
  EXPECT_NE(first->path(), second->path());
  struct stat info {};
  ASSERT_EQ(::stat(first->path().c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 07777, 0600u);
}

TEST_F(ReceivedFileTest, HoldsTheTicketAsLongAsTheFileIsThere) {
  auto ticket = std::make_shared<int>(0);
  const std::weak_ptr<int> under_way = ticket;
  auto file =
      ReceivedFile::make({.folder = scratch_.path(), .most = 100, .ticket = std::move(ticket)})
          .value();
  EXPECT_FALSE(under_way.expired());
  file.reset();
  EXPECT_TRUE(under_way.expired());
}

TEST_F(ReceivedFileTest, WhatAKilledProgramLeftIsRemovedAtTheNextStartAndNothingElse) {
  const pid_t killed = ::fork();
  if (killed == 0) {
    const auto left = made();
    static_cast<void>(left->append(files::test::bytes("half")));
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(killed, nullptr, 0);
  EXPECT_THAT(files(), SizeIs(1));
  const std::filesystem::path museums = scratch_ / "museum.part",
                              like = scratch_ / "onggi-received-x.part";
  std::ofstream(museums) << "the museum's";
  std::filesystem::create_directory(like);
  std::filesystem::create_symlink(museums, scratch_ / "onggi-received-y.part");
  {
    // A running program, even another one, keeps its own.
    const auto under_way = made();
    EXPECT_EQ(remove_abandoned(scratch_.path()), 1u);
    EXPECT_TRUE(std::filesystem::exists(under_way->path()));
  }
  EXPECT_THAT(files(),
              ElementsAre("museum.part", "onggi-received-x.part", "onggi-received-y.part"));
  EXPECT_EQ(remove_abandoned(scratch_.path()), 0u);
  EXPECT_EQ(remove_abandoned(scratch_ / "none"), 0u);
}

}  // namespace
}  // namespace onggi::web::received_file_test
