#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>

#include "kiosk/program/console/staff_answers.h"
#include "kiosk/program/watch/kiosk_state.h"

// Any bytes are a request for the staff's page, or a kiosk's state. The first byte says whether it
// comes from a session, under the page's own name, from the page itself, and as JSON; then a line
// each for method, target and cookie, and the body.

namespace {

namespace fs = std::filesystem;
namespace console = onggi::console;

constexpr const char* kHost = "127.0.0.1:8090";
constexpr const char* kExhibit = "credit = \"Kl4y-0f-museum\"\nlanguages = [\"en\"]\n";
constexpr const char* kVessel =
    "drawing = \"../../../outside\"\ntrue_height_mm = 100\n[label.en]\ntitle = "
    "\"Kl4y-0f-museum\"\n";
constexpr const char* kScene = "# Kl4y-0f-museum\n[moisture]\nair = 0.1\n[clay]\nrows = 40\n";
constexpr const char* kWords =
    "code = \"en\"\nname = \"English\"\n[text.attract]\ntitle = \"Kl4y-0f-museum\"\n";
constexpr const char* kVisit = "2026-05-28_141503_moon_jar";

/// A site with one keepsake, and a file outside that no request may reach.
struct World {
  fs::path site = fs::path(access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp") /
                  ("onggi_fuzz_" + std::to_string(getpid()));
  std::unique_ptr<console::StaffAnswers> staff;
  std::string cookie;

  World() {
    fs::create_directories(site / "config");
    fs::create_directories(site / "content/vessels/jar");
    std::ofstream(site / "content/vessels/jar/vessel.toml") << kVessel;
    std::ofstream(site / "config/exhibit.toml") << kExhibit;
    fs::create_directories(site / "config/scenes");
    fs::create_directories(site / "content/languages");
    std::ofstream(site / "config/scenes/soft.toml") << kScene;
    std::ofstream(site / "content/languages/en.toml") << kWords;
    std::ofstream(site / "outside") << "S3cr3t-0utside";
    put_back();
    auto found = console::Site::open(site);
    auto people = console::People::open(site / "state");
    if (!found || !people) std::abort();
    staff = std::make_unique<console::StaffAnswers>(console::StaffAnswers::Parts{
        .site = std::move(*found),
        .check = console::FileCheck("/bin/true", site / "config/exhibit.toml"),
        .onggi = "/bin/true",
        .people = std::move(*people),
        .changes = console::ChangeLog(site / "state"),
        .prices = site / "state/prices",
        .scans = site / "state/scans",
        .sheets = site / "state/sheets",
        .trial = site / "state/trial",
        .clock = [] { return std::int64_t{1'780'000'000}; },
        .tell = [](const onggi::Problem&) {}});
    auto door = console::Door::make("staff", site / "state", 1'780'000'000);
    if (!door) std::abort();
    cookie = door->admit("fuzz", console::Role::editor, 1'780'000'000);
    cookie.resize(cookie.find(';'));
    staff->open(std::move(*door), {kHost});
  }
  void put_back() const {
    if (fs::exists(site / "keepsakes" / kVisit / "postcard.jpg")) return;
    fs::create_directories(site / "keepsakes" / kVisit);
    std::ofstream(site / "keepsakes" / kVisit / "postcard.jpg") << "card";
  }
};

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string_view line(std::string_view& rest) {
  const auto end = std::min(rest.find('\n'), rest.size());
  const auto one = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return one;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static World world;
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  if (const auto state = onggi::watch::state_of(rest))
    if (onggi::watch::text_of(*state).size() > onggi::watch::kMostOfAState) std::abort();
  if (rest.empty()) return 0;
  const unsigned flags = static_cast<unsigned char>(rest.front());
  rest.remove_prefix(1);
  onggi::web::Ask ask;
  ask.method = line(rest);
  ask.target = line(rest);
  ask.cookie = line(rest);
  ask.body = rest;
  const bool inside = (flags & 1) != 0;
  if (inside) ask.cookie = world.cookie;
  ask.host = (flags & 2) != 0 ? kHost : ask.cookie;
  ask.origin = (flags & 4) != 0 ? std::string("http://") + kHost : ask.cookie;
  ask.type = (flags & 8) != 0 ? "application/json" : ask.body;
  // The session that everything is tried with stays.
  if (inside && ask.target == "/api/leave") return 0;
  const onggi::web::Answer answer = world.staff->to(ask);
  if (answer.status < 200 || answer.status > 599) std::abort();
  if (ask.host != kHost && answer.status != 421) std::abort();
  if (!inside && answer.file) std::abort();
  if (!inside && answer.body.find("Kl4y-0f-museum") != std::string::npos) std::abort();
  if (answer.body.find("S3cr3t-0utside") != std::string::npos) std::abort();
  if (answer.file && answer.file->size != 4) std::abort();  // the postcard
  // This process writes no curator's file: another does, and here it does nothing.
  if (text_of(world.site / "config/exhibit.toml") != kExhibit ||
      text_of(world.site / "content/vessels/jar/vessel.toml") != kVessel ||
      text_of(world.site / "config/scenes/soft.toml") != kScene ||
      text_of(world.site / "content/languages/en.toml") != kWords ||
      !fs::exists(world.site / "outside"))
    std::abort();
  for (const char* of_editors :
       {"/api/edit/", "/api/prices/", "/api/scenes", "/api/screen", "/screen/"})
    if (!inside && ask.target.starts_with(of_editors) && answer.status < 400) std::abort();
  world.put_back();
  return 0;
}
