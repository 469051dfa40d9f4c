#include "kiosk/program/setup/rights.h"

#include <gmock/gmock.h>
#include <grp.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "kiosk/keepsake/souvenir/keepsake.h"
#include "kiosk/keepsake/souvenir/open_passes.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"
#include "kiosk/keepsake/store/statistics.h"
#include "kiosk/keepsake/store/visit_store.h"
#include "kiosk/program/setup/accounts.h"
#include "kiosk/program/watch/kiosk_state.h"
#include "tests/kiosk/ground/files/disk.h"
#include "tests/kiosk/program/setup/setup_image.h"

namespace onggi::setup::rights_test {
namespace {

using test::good;
using test::Image;
namespace fs = std::filesystem;

/// Users and groups that no machine has, as the units name them.
constexpr uid_t kKiosk = 64101, kPhone = 64102, kConsole = 64103, kOther = 64104;
constexpr gid_t kKeepsakes = 64105, kSite = 64106;

struct User {
  uid_t user;
  std::vector<gid_t> groups;
};
const User kAsKiosk{kKiosk, {kKeepsakes}}, kAsPhone{kPhone, {kKeepsakes}},
    kAsConsole{kConsole, {kKiosk, kKeepsakes, kSite}}, kAsOther{kOther, {}};

/// True if `act` is true to a process of this user.
bool as(const User& user, const std::function<bool()>& act) {
  return files::test::in_child([&] {
           return ::setgroups(user.groups.size(), user.groups.data()) == 0 &&
                  ::setgid(user.user) == 0 && ::setuid(user.user) == 0 && act();
         }) == 0;
}

bool reads(const fs::path& file) { return std::ifstream(file).good(); }
bool writes(const fs::path& file) {
  std::ofstream out(file);
  return out.good() && (out << "x").flush().good();
}

struct stat rights_of(const fs::path& file) {
  struct stat info {};
  EXPECT_EQ(::lstat(file.c_str(), &info), 0) << file;
  return info;
}

/// A kiosk's machine after `onggi setup --console`, where tests become its users.
class Users : public ::testing::Test {
 protected:
  void SetUp() override {
    if (::geteuid() != 0) GTEST_SKIP() << "Only root can become another user.";
    for (fs::path above = image_.root(); above != above.root_path(); above = above.parent_path()) {
      if (above == image_.root()) fs::permissions(above, fs::perms(0755));
      if ((fs::status(above).permissions() & fs::perms::others_exec) == fs::perms::none)
        GTEST_SKIP() << above << " is shut to other users.";
    }
    ::umask(0022);
    image_.give_users(kKiosk, kKiosk, kKeepsakes, kSite);
  }
  void set_up() const {
    SetupOptions options = image_.options();
    options.console = "127.0.0.1";
    good(setup::set_up(options));
  }
  fs::path kept() const { return image_.root() / "srv/onggi/keepsakes"; }
  fs::path site() const { return image_.root() / "srv/onggi"; }
  /// What a kiosk keeps, as its user.
  bool keep(const std::string& visit) const {
    return as(kAsKiosk, [&] {
      souvenir::Keepsake k;
      k.name = visit;
      k.postcard = {50, 70, std::vector<std::uint8_t>(50 * 70 * 4, 200)};
      k.glb = {std::byte{'g'}};
      std::vector<Problem> remarks;
      return souvenir::save(k, kept(), {100}) &&
             store::VisitStore::open(kept() / "onggi.sqlite", "2026-05-04_141503", remarks);
    });
  }
  Image image_;
};
constexpr const char* kJar = "2026-05-04_141503_moon_jar";
constexpr const char* kOlla = "2026-05-04_150000_olla";

TEST_F(Users, ThePhonesProgramDeletesAKeepsakeAndReadsNoStoreAndChangesNoExhibit) {
  set_up();
  ASSERT_TRUE(keep(kJar));
  ASSERT_TRUE(
      as(kAsKiosk, [&] { return souvenir::Passes(kept()).give(kJar, 1000, 24).has_value(); }));
  EXPECT_TRUE(as(kAsPhone, [&] { return reads(kept() / kJar / "postcard.jpg"); }));
  EXPECT_FALSE(as(kAsPhone, [&] { return reads(kept() / "onggi.sqlite"); }));
  EXPECT_FALSE(as(kAsPhone, [&] { return writes(site() / "config/exhibit.toml"); }));
  EXPECT_FALSE(as(kAsPhone, [&] { return writes(site() / "content/vessels/jar/new.toml"); }));
  EXPECT_TRUE(as(kAsPhone, [&] {
    souvenir::OpenPasses passes(kept());
    passes.serve();
    const auto pass = passes.find(souvenir::tokens_of(kept()).at(0), 1000);
    if (!pass) return false;
    passes.note_fetched(*pass, 1000);
    return passes.remove_all_of(*pass).has_value() &&
           souvenir::Passes(kept()).served(std::time(nullptr));
  }));
  EXPECT_FALSE(fs::exists(kept() / kJar));
  EXPECT_TRUE(souvenir::tokens_of(kept()).empty());
}

TEST_F(Users, TheStaffsProgramReadsTheStoreDeletesAKeepsakeAndChangesTheExhibit) {
  set_up();
  ASSERT_TRUE(keep(kJar));
  EXPECT_TRUE(as(kAsConsole, [&] {
    return store::read_statistics((kept() / "onggi.sqlite").string(), "", "").has_value();
  }));
  EXPECT_TRUE(
      as(kAsConsole, [&] { return souvenir::Passes(kept()).give(kJar, 1000, 24).has_value(); }));
  EXPECT_TRUE(as(kAsPhone, [&] {
    return souvenir::OpenPasses(kept()).find(souvenir::tokens_of(kept()).at(0), 1000).has_value();
  })) << "a pass of the staff's is good at the phone";
  EXPECT_TRUE(as(kAsConsole, [&] { return souvenir::remove_visit(kept() / kJar).has_value(); }));
  for (const char* file :
       {"config/exhibit.toml", "config/new.toml", "content/vessels/jar/vessel.toml",
        "content/vessels/new.toml", "revisions/1"})
    EXPECT_TRUE(as(kAsConsole, [&] { return writes(site() / file); })) << file;
  EXPECT_FALSE(as(kAsConsole, [&] { return writes(image_.root() / "etc/new"); }));
}

TEST_F(Users, TheKioskKeepsAndDeletesButChangesNoExhibit) {
  set_up();
  ASSERT_TRUE(keep(kJar));
  ASSERT_TRUE(
      as(kAsConsole, [&] { return souvenir::Passes(kept()).give(kJar, 1000, 24).has_value(); }));
  EXPECT_TRUE(as(kAsKiosk, [&] {
    souvenir::Passes(kept()).take_back_all(kJar);
    return souvenir::tokens_of(kept()).empty() && souvenir::remove_visit(kept() / kJar);
  })) << "what another program wrote, too";
  EXPECT_FALSE(as(kAsKiosk, [&] { return writes(site() / "config/exhibit.toml"); }));
  EXPECT_FALSE(as(kAsKiosk, [&] { return writes(site() / "content/new.toml"); }));
  EXPECT_FALSE(as(kAsKiosk, [&] { return writes(site() / "revisions/1"); }));
}

TEST_F(Users, ThePhonesProgramCannotSayWhoMayComeIntoTheStaffsPage) {
  set_up();
  watch::KioskState state;
  state.way_in = "a digest";
  state.way_in_until = 4000;
  const auto say = [&] {
    std::error_code ignored;
    fs::remove(kept() / watch::kStateFile, ignored);
    std::ofstream(kept() / watch::kStateFile) << watch::text_of(state);
    return fs::exists(kept() / watch::kStateFile);
  };
  const auto heard = [&] {
    const watch::SeenKiosk seen = watch::look_at_kiosk(kept());
    return seen.state && seen.state->way_in == state.way_in;
  };
  ASSERT_TRUE(as(kAsKiosk, say));
  EXPECT_TRUE(as(kAsConsole, heard));
  ASSERT_TRUE(as(kAsPhone, say)) << "it may write in this folder";
  EXPECT_FALSE(as(kAsConsole, heard));
}

TEST_F(Users, OthersOfTheMachineReadKeepsakesAndNothingMore) {
  set_up();
  ASSERT_TRUE(keep(kJar));
  EXPECT_TRUE(as(kAsOther, [&] { return reads(kept() / kJar / "postcard.jpg"); }));
  EXPECT_FALSE(as(kAsOther, [&] { return reads(kept() / "onggi.sqlite"); }));
  EXPECT_FALSE(as(kAsOther, [&] { return writes(kept() / "new"); }));
  EXPECT_FALSE(as(kAsOther, [&] { return writes(kept() / kJar / "new"); }));
  EXPECT_FALSE(as(kAsOther, [&] { return writes(site() / "config/exhibit.toml"); }));
  EXPECT_FALSE(as(kAsOther, [&] {
    return store::read_statistics((kept() / "onggi.sqlite").string(), "", "").has_value();
  }));
}

/// As the package before left it: one user for all programs.
TEST_F(Users, AnOlderKiosksFoldersGetTheRightsAndLoseNone) {
  good(setup::set_up(image_.options()));
  ASSERT_TRUE(keep(kJar));
  ASSERT_TRUE(keep(kOlla));
  for (const auto& entry : fs::recursive_directory_iterator(kept())) {
    ASSERT_EQ(::lchown(entry.path().c_str(), kKiosk, kKiosk), 0);
    fs::permissions(entry, fs::perms(entry.is_directory() ? 0755 : 0644));
  }
  ASSERT_EQ(::chown(kept().c_str(), kKiosk, kKiosk), 0);
  fs::permissions(kept(), fs::perms(0755));
  fs::create_directories(kept() / "photos of ours");
  std::ofstream(kept() / "photos of ours/one.jpg") << "x";
  const auto ours = rights_of(kept() / "photos of ours");

  EXPECT_FALSE(as(kAsPhone, [&] { return souvenir::remove_visit(kept() / kJar).has_value(); }));
  EXPECT_THAT(good(renew_rights(image_.options())).changed, ::testing::SizeIs(1));
  EXPECT_THAT(good(renew_rights(image_.options())).changed, ::testing::IsEmpty());
  EXPECT_TRUE(as(kAsPhone, [&] { return souvenir::remove_visit(kept() / kJar).has_value(); }));
  EXPECT_FALSE(as(kAsPhone, [&] { return reads(kept() / "onggi.sqlite"); }));
  EXPECT_TRUE(as(kAsConsole, [&] { return reads(kept() / "onggi.sqlite"); }));
  const auto visit = rights_of(kept() / kOlla), file = rights_of(kept() / kOlla / "postcard.jpg"),
             after = rights_of(kept() / "photos of ours");
  EXPECT_EQ(visit.st_uid, kKiosk);
  EXPECT_EQ(visit.st_mode & 07777, 0775u);
  EXPECT_EQ(file.st_uid, kKiosk);
  EXPECT_EQ(file.st_gid, kKiosk) << "to delete a file, its folder's right is enough";
  EXPECT_EQ(file.st_mode & 07777, 0644u);
  EXPECT_EQ(after.st_gid, ours.st_gid) << "a folder of the museum's own is left alone";
  EXPECT_EQ(after.st_mode, ours.st_mode);
  EXPECT_TRUE(as(kAsKiosk, [&] { return souvenir::remove_visit(kept() / kOlla).has_value(); }));
}

TEST_F(Users, NoLinkLeadsSetupElsewhere) {
  good(setup::set_up(image_.options()));
  image_.put("etc/shadow", "secret");
  image_.put("etc/hosts", "own");
  fs::permissions(image_.root() / "etc/shadow", fs::perms(0600));
  image_.link("srv/onggi/config/link.toml", (image_.root() / "etc/shadow").string());
  image_.link("srv/onggi/content/out", (image_.root() / "etc").string());
  fs::create_hard_link(image_.root() / "etc/shadow", site() / "config/hard.toml");
  set_up();
  const auto shadow = rights_of(image_.root() / "etc/shadow"),
             hosts = rights_of(image_.root() / "etc/hosts");
  EXPECT_EQ(shadow.st_gid, 0u);
  EXPECT_EQ(shadow.st_mode & 07777, 0600u);
  EXPECT_EQ(hosts.st_gid, 0u);
}

TEST_F(Users, UndoLeavesTheExhibitToRootAlone) {
  set_up();
  ASSERT_TRUE(as(kAsConsole, [&] { return writes(site() / "config/exhibit.toml"); }));
  const auto would = good(undo_setup(image_.system(), true));
  EXPECT_TRUE(as(kAsConsole, [&] { return writes(site() / "config/exhibit.toml"); }));
  EXPECT_EQ(good(undo_setup(image_.system())).changed, would.changed);
  EXPECT_FALSE(as(kAsConsole, [&] { return writes(site() / "config/exhibit.toml"); }));
  EXPECT_FALSE(as(kAsConsole, [&] { return writes(site() / "content/vessels/new.toml"); }));
  EXPECT_EQ(rights_of(site() / "config").st_gid, 0u);
  EXPECT_EQ(rights_of(site() / "config").st_mode & 07777, 0755u);
  EXPECT_EQ(rights_of(site() / "config/exhibit.toml").st_mode & 07777, 0644u);
}

}  // namespace
}  // namespace onggi::setup::rights_test
