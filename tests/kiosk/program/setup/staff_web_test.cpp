#include "kiosk/program/setup/staff_web.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <string>

#include "kiosk/program/setup/accounts.h"
#include "kiosk/program/setup/staff_parts.h"
#include "tests/kiosk/program/setup/setup_image.h"

namespace onggi::setup::staff_web_test {
namespace {

using files::test::content;
using test::good;
using test::Image;
namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kMask = "etc/systemd/system/nginx.service";
constexpr const char* kFiles = "etc/onggi/staff-web";

/// An image on a machine with these addresses, where nginx and openssl are there if `web`.
class Museum : public Image {
 public:
  explicit Museum(bool web = true) {
    if (web) bring_nginx();
    put("usr/bin/openssl", "");
  }
  void bring_nginx() const {
    put("usr/sbin/nginx", "");
    put("usr/lib/systemd/system/nginx.service",
        "[Service]\nExecStart=/bin/true\n[Install]\nWantedBy=multi-user.target\n");
  }
  SetupOptions console(const std::string& at = kChoose) const {
    SetupOptions all = options();
    all.console = at;
    all.addresses = addresses;
    return all;
  }
  fs::path file(const std::string& name) const { return root() / kFiles / name; }
  std::string told(const std::string& at) const {
    const auto failed = set_up(console(at));
    return failed ? "" : to_text(failed.error());
  }
  std::vector<MachineAddress> addresses{{"eth0", "192.168.1.20"}};
};

bool openssl_is_here() { return std::system("openssl version >/dev/null 2>&1") == 0; }

TEST(staff_address, is_the_machines_only_one_beside_the_access_points) {
  Museum museum;
  museum.addresses.push_back({"wlan0", "192.168.4.1"});
  EXPECT_THAT(museum.told(kChoose), AllOf(HasSubstr("192.168.1.20 (eth0), 192.168.4.1 (wlan0)"),
                                          HasSubstr("sudo onggi setup --console 192.168.1.20")));
  museum.put("etc/hostapd/hostapd.conf", "ssid=Onggi\ninterface=wlan0\n");
  auto at = staff_address(kChoose, museum.addresses, museum.system());
  ASSERT_TRUE(at);
  EXPECT_EQ(at->listen(), "192.168.1.20:443");
  EXPECT_EQ(at->page(), "https://192.168.1.20");
  fs::remove(museum.root() / "etc/hostapd/hostapd.conf");
  museum.put("etc/systemd/network/50-onggi-phones.network", "[Network]\nAddress=192.168.4.1/24\n");
  EXPECT_TRUE(staff_address(kChoose, museum.addresses, museum.system()));
  EXPECT_THAT(museum.told("192.168.4.1"), HasSubstr("visitors' phones use"));
  EXPECT_THAT(museum.told("192.168.4.1:8443"), HasSubstr("visitors' phones use"));
  museum.addresses.clear();
  EXPECT_THAT(museum.told(kChoose), HasSubstr("no address in a network of the staff's"));
}

TEST(staff_address, is_one_address_and_never_all_of_the_machines) {
  const Museum museum;
  for (const char* all : {"0.0.0.0", "0.0.0.0:443", "::", "[::]:443"})
    EXPECT_THAT(museum.told(all), HasSubstr("every address of the machine")) << all;
  for (const char* none : {"kiosk", "192.168.1", "192.168.1.20:", "192.168.1.20:0", "443",
                           "192.168.1.20:99999", "192.168.1.20;", "192.168.1.20 ssl; listen 80"})
    EXPECT_THAT(museum.told(none), HasSubstr("This is not an address")) << none;
  const auto v6 = staff_address("[fd00::1]:8443", {}, museum.system());
  ASSERT_TRUE(v6);
  EXPECT_EQ(v6->listen(), "[fd00::1]:8443");
  EXPECT_EQ(v6->page(), "https://[fd00::1]:8443");
  const auto bare = staff_address("fd00:0::1", {}, museum.system());
  ASSERT_TRUE(bare);
  EXPECT_EQ(bare->page(), "https://[fd00::1]");
}

TEST(staff_web, one_command_brings_all_of_it_and_undo_takes_it_back) {
  if (!openssl_is_here()) GTEST_SKIP() << "there is no openssl here";
  const Museum museum;
  const auto before = museum.all();
  SetupOptions dry = museum.console();
  dry.dry = true;
  const auto would = good(set_up(dry));
  EXPECT_EQ(museum.all(), before);
  EXPECT_EQ(good(set_up(museum.console())).changed, would.changed);
  EXPECT_THAT(content(museum.file("address.conf")), HasSubstr("listen 192.168.1.20:443 ssl;"));
  EXPECT_THAT(staff_pages(museum.system()),
              ElementsAre("https://192.168.1.20", "https://kiosk.local", "https://kiosk"));
  EXPECT_TRUE(museum.starts("onggi-console.service"));
  EXPECT_TRUE(museum.starts("onggi-staff-web.service"));
  EXPECT_THAT(good(set_up(museum.console())).changed, IsEmpty()) << "a second time";

  good(undo_setup(museum.system()));
  EXPECT_FALSE(museum.starts("onggi-console.service"));
  EXPECT_FALSE(museum.starts("onggi-staff-web.service"));
  EXPECT_FALSE(fs::exists(museum.root() / "etc/onggi"));
}

TEST(staff_web, debians_own_page_can_never_start_and_is_masked_before_nginx_comes) {
  if (!openssl_is_here()) GTEST_SKIP() << "there is no openssl here";
  const Museum museum(false);
  EXPECT_THAT(museum.told(kChoose), HasSubstr("sudo apt install nginx"));
  EXPECT_EQ(fs::read_symlink(museum.root() / kMask), "/dev/null");
  // Its package enables it.
  museum.bring_nginx();
  museum.link("etc/systemd/system/multi-user.target.wants/nginx.service",
              "/usr/lib/systemd/system/nginx.service");
  good(set_up(museum.console()));
  EXPECT_EQ(fs::read_symlink(museum.root() / kMask), "/dev/null");
  EXPECT_EQ(staff_web_remark(museum.system()), "");
  good(undo_setup(museum.system()));
  EXPECT_FALSE(fs::is_symlink(museum.root() / kMask));
  EXPECT_FALSE(museum.starts("nginx.service")) << "nor afterwards";
}

TEST(staff_web, an_nginx_that_was_there_is_the_museums_own_and_left_alone) {
  if (!openssl_is_here()) GTEST_SKIP() << "there is no openssl here";
  const Museum museum;
  museum.link("etc/systemd/system/multi-user.target.wants/nginx.service",
              "/usr/lib/systemd/system/nginx.service");
  museum.put("etc/nginx/sites-enabled/default", "the museum's");
  good(set_up(museum.console()));
  EXPECT_FALSE(fs::is_symlink(museum.root() / kMask));
  EXPECT_TRUE(museum.starts("nginx.service"));
  EXPECT_THAT(staff_web_remark(museum.system()), HasSubstr("left alone"));
  good(undo_setup(museum.system()));
  EXPECT_TRUE(museum.starts("nginx.service"));
  EXPECT_EQ(content(museum.root() / "etc/nginx/sites-enabled/default"), "the museum's");
}

TEST(staff_web, the_certificate_is_made_anew_for_other_names_and_when_it_ends_soon_only) {
  if (!openssl_is_here()) GTEST_SKIP() << "there is no openssl here";
  const Museum museum;
  good(set_up(museum.console()));
  const std::string first = content(museum.file("self-signed.pem")),
                    key = content(museum.file("self-signed-key.pem"));
  EXPECT_THAT(first, HasSubstr("IP:192.168.1.20,DNS:kiosk.local,DNS:kiosk\n"));
  struct stat info {};
  ASSERT_EQ(::stat(museum.file("self-signed-key.pem").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 07777, 0640u);
  EXPECT_EQ(info.st_gid, group_of(museum.system(), kWebUser).value());

  good(set_up(museum.console()));
  EXPECT_EQ(content(museum.file("self-signed.pem")), first);
  good(set_up(museum.console("192.168.1.21")));
  const std::string second = content(museum.file("self-signed.pem"));
  EXPECT_THAT(second, HasSubstr("IP:192.168.1.21"));
  EXPECT_NE(content(museum.file("self-signed-key.pem")), key);
  EXPECT_THAT(content(museum.file("address.conf")), HasSubstr("listen 192.168.1.21:443 ssl;"));

  // One that has 80 days left.
  const std::string soon =
      "openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 80 -subj /CN=x "
      "-keyout /dev/null -out " +
      museum.file("soon.pem").string() + " 2>/dev/null";
  ASSERT_EQ(std::system(soon.c_str()), 0);
  museum.put(std::string(kFiles) + "/self-signed.pem",
             second.substr(0, second.find('\n') + 1) + content(museum.file("soon.pem")));
  EXPECT_THAT(good(set_up(museum.console("192.168.1.21"))).changed,
              ElementsAre(HasSubstr("self-signed.pem")));
  fs::remove(museum.file("soon.pem"));
  good(undo_setup(museum.system()));
  EXPECT_FALSE(fs::exists(museum.root() / "etc/onggi"));
}

TEST(staff_web, the_museums_own_certificate_and_settings_are_used_and_stay) {
  const Museum museum;
  museum.put("etc/onggi/staff-web/certificate.pem", "theirs");
  museum.put("etc/onggi/staff-web/key.pem", "theirs");
  good(set_up(museum.console()));
  EXPECT_THAT(content(museum.file("address.conf")),
              AllOf(HasSubstr("ssl_certificate /etc/onggi/staff-web/certificate.pem;"),
                    HasSubstr("ssl_certificate_key /etc/onggi/staff-web/key.pem;"),
                    HasSubstr("Strict-Transport-Security")));
  EXPECT_FALSE(fs::exists(museum.file("self-signed.pem")));
  museum.put("etc/onggi/staff-web/address.conf", "listen 10.0.0.1:443 ssl;\n");
  EXPECT_THAT(good(set_up(museum.console())).stayed, Contains(HasSubstr("address.conf: stays")));
  good(undo_setup(museum.system()));
  EXPECT_EQ(content(museum.file("address.conf")), "listen 10.0.0.1:443 ssl;\n");
  EXPECT_EQ(content(museum.file("key.pem")), "theirs");
}

TEST(staff_web, a_strange_name_of_the_machine_is_left_out) {
  for (const char* name : {"", "localhost", "a b;", "x\"y", "-k"}) {
    const Museum museum;
    museum.put("etc/hostname", std::string(name) + "\n");
    museum.put("etc/onggi/staff-web/certificate.pem", "theirs");
    museum.put("etc/onggi/staff-web/key.pem", "theirs");
    good(set_up(museum.console()));
    EXPECT_THAT(staff_pages(museum.system()), Not(Contains(HasSubstr(";")))) << name;
    EXPECT_THAT(staff_pages(museum.system()), Not(Contains(HasSubstr("\"")))) << name;
    EXPECT_EQ(staff_pages(museum.system()).front(), "https://192.168.1.20") << name;
  }
}

TEST(staff_web, this_machine_alone_needs_no_nginx_and_does_not_end_https_by_the_way) {
  const Museum museum(false);
  good(set_up(museum.console("127.0.0.1")));
  EXPECT_TRUE(museum.starts("onggi-console.service"));
  EXPECT_FALSE(museum.starts("onggi-staff-web.service"));
  EXPECT_FALSE(fs::exists(museum.root() / "etc/onggi"));
  EXPECT_FALSE(fs::is_symlink(museum.root() / kMask));
  museum.put("etc/onggi/staff-web/console.env", "ADDRESSES=--address https://192.168.1.20\n");
  EXPECT_THAT(museum.told("127.0.0.1"), HasSubstr("by HTTPS already"));
}

}  // namespace
}  // namespace onggi::setup::staff_web_test
