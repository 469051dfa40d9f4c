#include <cmath>
#include <cstdio>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/virtual_display.h"
#include "kiosk/picture/encoding/encode.h"
#include "tests/pages/page_program.h"

namespace fs = std::filesystem;

namespace onggi::pages {

namespace {

constexpr int kTicks = 20;             // of 1 ms: 50 frames a second
constexpr double kLongestPot = 400.0;  // s

struct AttractArguments {
  std::string config, out, vessel;
  double every = 5.0;
  int width = 1280, height = 720;
};

/// All that attract shows, one pot after another, until each vessel of the shelf was thrown once.
Result<int> look_at_attract(const AttractArguments& arguments) {
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  if (auto made = files::make_folder(arguments.out); !made) return tl::unexpected(made.error());
  exhibit::KioskOptions options;
  options.config = *config;
  options.stepped = true;
  options.devices = false;
  options.keepsakes = fs::path(arguments.out) / "keepsakes";
  options.window = {.width = arguments.width, .height = arguments.height, .visible = false};
  auto display = files::VirtualDisplay::ensure(options.window.width, options.window.height);
  if (!display) return tl::unexpected(display.error());
  auto opened = exhibit::Kiosk::open(options);
  if (!opened) return tl::unexpected(opened.error());
  exhibit::Kiosk& kiosk = **opened;
  kiosk.renderer().set_full_quality(true);
  kiosk.shelf().wait();
  double now = 0, begun = 0, looked = 0;
  int card = -1;
  std::size_t thrown = 0;
  while (thrown <= kiosk.shelf().cards().size() && now - begun < kLongestPot) {
    kiosk.advance(kTicks);
    kiosk.frame(now += 1e-3 * kTicks, false);
    if (const int of = kiosk.doing().card; of != card) {
      card = of;
      begun = looked = now;
      ++thrown;
    }
    if (card < 0 || now - looked < arguments.every) continue;
    looked = now;
    const std::string& id = kiosk.shelf().cards()[static_cast<std::size_t>(card)].vessel->id;
    if (!arguments.vessel.empty() && id != arguments.vessel) continue;
    kiosk.frame(now += 1e-3, true);
    auto bytes = encoding::encode(kiosk.picture(), encoding::Format::jpeg, {id, "", ""});
    if (!bytes) return tl::unexpected(bytes.error());
    char name[16];
    std::snprintf(name, sizeof name, "_%03d.jpg", static_cast<int>(std::lround(now - begun)));
    if (auto kept = files::write_durably(fs::path(arguments.out) / (id + name), *bytes); !kept)
      return tl::unexpected(kept.error());
  }
  return 0;
}

}  // namespace
}  // namespace onggi::pages

int main(int argc, char** argv) {
  onggi::pages::AttractArguments a;
  return onggi::pages::run_page_program(
      {.name = "onggi_page_attract",
       .help = "Look at every pot that attract throws, every few seconds",
       .examples = "Example: build/release/bin/onggi_page_attract --out /tmp/attract\n"
                   "It takes minutes without a GPU.",
       .options =
           {{.name = "--out", .field = &a.out, .help = "Folder for the pictures", .required = true},
            {"--vessel", &a.vessel, "Only this vessel [all]"},
            {"--every", &a.every, "Seconds between two pictures [5]"},
            {"--width", &a.width, "Pixels [1280]"},
            {"--height", &a.height, "Pixels [720]"},
            {"--config", &a.config, "The exhibit's TOML [config/exhibit.toml]"}},
       .run = [&a] { return onggi::pages::look_at_attract(a); }},
      argc, argv);
}
