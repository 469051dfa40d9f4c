#include "kiosk/ground/files/passing_folder.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "tests/kiosk/ground/files/disk.h"

namespace onggi::files::passing_folder_test {
namespace {

namespace fs = std::filesystem;

class PassingFolderTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* now = std::getenv("TMPDIR");
    if (now != nullptr) before_ = now;
    ::setenv("TMPDIR", scratch_.path().c_str(), 1);
  }
  void TearDown() override {
    if (before_.empty())
      ::unsetenv("TMPDIR");
    else
      ::setenv("TMPDIR", before_.c_str(), 1);
  }
  static void fill(const fs::path& folder) {
    fs::create_directories(folder / "a/b");
    std::ofstream(folder / "a/b/scan.glb") << "glTF";
  }
  std::string before_;
  test::ScratchFolder scratch_;
};

TEST_F(PassingFolderTest, IsForThisUserAloneAndGoneWithItsOwner) {
  fs::path path;
  {
    PassingFolder first = PassingFolder::make("import").value();
    const PassingFolder folder(std::move(first));
    path = folder.path();
    EXPECT_EQ(path.parent_path(), scratch_.path());
    EXPECT_TRUE(path.filename().string().starts_with("onggi-import-"));
    struct stat info {};
    ASSERT_EQ(::stat(path.c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 07777, 0700u);
    fill(path);
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST_F(PassingFolderTest, IsGoneSoonAfterItsProgramIsKilled) {
  for (const int how : {SIGKILL, SIGINT}) {
    const pid_t killed = ::fork();
    if (killed == 0) {
      ::signal(SIGINT, SIG_DFL);
      const PassingFolder folder = PassingFolder::make("import").value();
      fill(folder.path());
      ::kill(::getpid(), how);
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(killed, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
    for (int n = 0; n < 1000 && !test::names_in(scratch_.path()).empty(); ++n) ::usleep(10'000);
    EXPECT_EQ(test::names_in(scratch_.path()), std::vector<std::string>{});
  }
}

TEST_F(PassingFolderTest, WhereNoneCanBeMadeItIsSaid) {
  ::setenv("TMPDIR", (scratch_ / "none").c_str(), 1);
  const auto none = PassingFolder::make("import");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().exit_code, 1);
}

}  // namespace
}  // namespace onggi::files::passing_folder_test
