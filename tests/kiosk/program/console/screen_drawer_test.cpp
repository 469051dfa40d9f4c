#include "kiosk/program/console/screen_drawer.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

#include "kiosk/ground/files/descriptor.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::console::screen_drawer_test {
namespace {

namespace fs = std::filesystem;

bool never() { return false; }

DrawnScreen end_of(ScreenDrawer& drawer) {
  for (int n = 0; n < 3000; ++n) {
    if (auto drawn = drawer.take()) return *drawn;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ADD_FAILURE() << "it does not end";
  return {};
}

/// A program that draws as `script` says.
class Drawer : public ::testing::Test {
 protected:
  fs::path program(const std::string& script) const {
    std::ofstream(folder_ / "onggi") << "#!/bin/sh\n" << script << '\n';
    fs::permissions(folder_ / "onggi", fs::perms(0755));
    return folder_ / "onggi";
  }
  DrawnScreen drawn(const std::string& script) const {
    ScreenDrawer drawer(program(script), "");
    EXPECT_TRUE(drawer.begin({"label"}, never));
    return end_of(drawer);
  }
  const files::test::ScratchFolder folder_;
};

constexpr const char* kTwoPictures =
    R"({"done":true,"pictures":[{"width":4,"height":3,"bytes":3},{"width":3,"height":4,"bytes":2}]})";

TEST_F(Drawer, BringsThePicturesThatTheProgramDraws) {
  ScreenDrawer drawer(program("echo \"$*\" > '" + (folder_ / "asked").string() + "'; echo '" +
                              kTwoPictures + "'; printf abcde"),
                      "");
  EXPECT_FALSE(drawer.take());
  EXPECT_TRUE(drawer.begin({"--language", "ko", "label"}, never));
  EXPECT_FALSE(drawer.begin({"label"}, never)) << "one at a time";
  const DrawnScreen drawn = end_of(drawer);
  EXPECT_EQ(drawn.what, "");
  ASSERT_EQ(drawn.pictures.size(), 2u);
  EXPECT_EQ(drawn.pictures[0].jpeg, "abc");
  EXPECT_EQ(drawn.pictures[1].jpeg, "de");
  EXPECT_EQ(drawn.pictures[1].height, 4);
  EXPECT_EQ(files::test::content(folder_ / "asked"), "screen --page --language ko label\n");
  EXPECT_TRUE(drawer.begin({"label"}, never)) << "and then the next one";
  end_of(drawer);
}

TEST_F(Drawer, TellsWhyThereIsNone) {
  const DrawnScreen refused =
      drawn(R"(echo '{"done":false,"where":"w","what":"No vessel.","remedy":"Name one."}')");
  EXPECT_EQ(refused.what, "No vessel.");
  EXPECT_EQ(refused.remedy, "Name one.");
  for (const char* broken :
       {"exit 1", "echo nothing", "echo '[1]'", "kill -9 $$",
        "echo '{\"done\":true,\"pictures\":[{\"width\":4,\"height\":3,\"bytes\":9}]}'; printf abc",
        "echo '{\"done\":true,\"pictures\":[]}'", "echo '{\"done\":true}'"}) {
    const DrawnScreen none = drawn(broken);
    EXPECT_EQ(none.what, "The screen could not be drawn.") << broken;
    EXPECT_TRUE(none.pictures.empty());
    EXPECT_FALSE(none.left);
  }
  ScreenDrawer missing(folder_ / "nobody", "");
  EXPECT_TRUE(missing.begin({}, never));
  EXPECT_NE(end_of(missing).what, "");
}

TEST_F(Drawer, EndsTheProgramAsSoonAsNobodyWantsIt) {
  std::atomic<bool> unwanted = false;
  ScreenDrawer drawer(program("echo $$ > '" + (folder_ / "number").string() + "'; exec sleep 600"),
                      "");
  EXPECT_TRUE(drawer.begin({"label"}, [&unwanted] { return unwanted.load(); }));
  for (int n = 0; n < 1000 && files::test::content(folder_ / "number").empty(); ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(drawer.under_way());
  unwanted = true;
  EXPECT_TRUE(end_of(drawer).left);
  const std::string process = "/proc/" + files::test::content(folder_ / "number");
  EXPECT_FALSE(fs::exists(process.substr(0, process.size() - 1)));
}

TEST_F(Drawer, AsksTheServiceWhereThereIsOne) {
  const fs::path at = folder_ / "page.sock";
  ScreenDrawer drawer("/nobody", at);
  EXPECT_TRUE(drawer.begin({"label"}, never));
  EXPECT_NE(end_of(drawer).remedy.find("systemctl start onggi-screen.socket"), std::string::npos);

  const files::Descriptor listening(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_un name{};
  name.sun_family = AF_UNIX;
  at.native().copy(name.sun_path, sizeof name.sun_path - 1);
  ASSERT_EQ(::bind(listening.get(), reinterpret_cast<const sockaddr*>(&name), sizeof name), 0);
  ASSERT_EQ(::listen(listening.get(), 4), 0);
  std::string asked;
  std::thread service([&] {
    const files::Descriptor one(::accept4(listening.get(), nullptr, nullptr, SOCK_CLOEXEC));
    while (!asked.ends_with(std::string(2, '\0'))) {
      char c = 0;
      if (::read(one.get(), &c, 1) != 1) return;
      asked += c;
    }
    const std::string answer = std::string(kTwoPictures) + "\nabcde";
    static_cast<void>(::write(one.get(), answer.data(), answer.size()));
  });
  EXPECT_TRUE(drawer.begin({"--vessel", "olla", "label"}, never));
  EXPECT_EQ(end_of(drawer).pictures.size(), 2u);
  service.join();
  EXPECT_EQ(asked, std::string("--vessel\0olla\0label\0\0", 21));
}

}  // namespace
}  // namespace onggi::console::screen_drawer_test
