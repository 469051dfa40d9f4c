#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/exhibit/rehearsal/scripted_visitor.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/virtual_display.h"
#include "kiosk/picture/encoding/encode.h"
#include "tests/pages/page_program.h"

namespace fs = std::filesystem;

namespace onggi::pages {

namespace {

constexpr int kTicks = 20;             // of 1 ms: 50 frames a second
constexpr int kAcross = 10;            // tiles of the sheet
constexpr double kLongestVisit = 600;  // s
constexpr int kCools = 300;            // frames until the pot is out of the fire,
constexpr int kSettles = 60;           // and until the next visitor

struct DecoratedArguments {
  std::string config, out, vessel;
  int pots = 50, first = 1;
  double seconds = 60.0;
};

/// Half the width and height: a mean of four pixels.
view::Image halved(const view::Image& image) {
  view::Image out;
  out.width = image.width / 2, out.height = image.height / 2;
  out.rgba.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) * 4);
  const auto at = [&](int x, int y, int k) {
    return image.rgba[(static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(x)) *
                          4 +
                      static_cast<std::size_t>(k)];
  };
  std::size_t n = 0;
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      for (int k = 0; k < 4; ++k)
        out.rgba[n++] =
            static_cast<std::uint8_t>((at(2 * x, 2 * y, k) + at(2 * x + 1, 2 * y, k) +
                                       at(2 * x, 2 * y + 1, k) + at(2 * x + 1, 2 * y + 1, k) + 2) /
                                      4);
  return out;
}

/// The part of a screen beside its words.
view::Image beside_words(const view::Image& image) {
  view::Image out;
  out.height = image.height, out.width = std::min(image.height, image.width);
  const int from = image.width - out.width;
  for (int y = 0; y < out.height; ++y) {
    const auto row = image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + from);
    out.rgba.insert(out.rgba.end(), row, row + 4 * static_cast<std::ptrdiff_t>(out.width));
  }
  return out;
}

void lay(view::Image& sheet, const view::Image& tile, int column, int row) {
  for (int y = 0; y < tile.height; ++y) {
    const auto from = tile.rgba.begin() + 4 * static_cast<std::ptrdiff_t>(y) * tile.width;
    std::copy(
        from, from + 4 * static_cast<std::ptrdiff_t>(tile.width),
        sheet.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(row * tile.height + y) * sheet.width +
                                  column * tile.width));
  }
}

Result<void> keep(const fs::path& file, const view::Image& image) {
  auto bytes = encoding::encode(image, encoding::Format::jpeg, {file.stem().string(), "", ""});
  if (!bytes) return tl::unexpected(bytes.error());
  return files::write_durably(file, *bytes);
}

/// One visitor until the pot is out of the fire: its picture. Nothing is kept.
Result<view::Image> visit(exhibit::Kiosk& kiosk, rehearsal::ScriptedVisitor::Plan plan,
                          double& now) {
  bool burns = false;
  rehearsal::ScriptedVisitor visitor(
      kiosk, plan, [&](const std::string& name) { burns = burns || name == "kiln_fire"; });
  const auto frame = [&] {
    kiosk.advance(kTicks);
    kiosk.frame(now += 1e-3 * kTicks, false);
  };
  for (const double begun = now; !burns && now - begun < kLongestVisit;) {
    frame();
    if (auto good = visitor.step(now); !good) return tl::unexpected(good.error());
  }
  if (!burns)
    return problem("the visit", "No pot came into the kiln within ten minutes.",
                   "Give the exhibit's scene a [kiln].", 1);
  for (int n = 0; n < kCools; ++n) frame();
  view::Image image = kiosk.picture();
  kiosk.visit().close(now);
  for (int n = 0; n < kSettles; ++n) frame();
  return image;
}

Result<int> look_at_decorated(const DecoratedArguments& arguments) {
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  const fs::path out = arguments.out;
  if (auto made = files::make_folder(out); !made) return tl::unexpected(made.error());
  exhibit::KioskOptions options;
  options.config = *config;
  options.stepped = true;
  options.devices = false;
  options.keepsakes = out / "keepsakes";
  options.window = {.width = 1280, .height = 720, .visible = false};
  auto display = files::VirtualDisplay::ensure(options.window.width, options.window.height);
  if (!display) return tl::unexpected(display.error());
  auto opened = exhibit::Kiosk::open(options);
  if (!opened) return tl::unexpected(opened.error());
  exhibit::Kiosk& kiosk = **opened;
  kiosk.renderer().set_full_quality(true);
  kiosk.shelf().wait();
  std::vector<int> cards;
  for (int n = 0; n < static_cast<int>(kiosk.shelf().cards().size()); ++n)
    if (const auto& card = kiosk.shelf().cards()[static_cast<std::size_t>(n)];
        card.wheel.kiln && card.wheel.way != nullptr &&
        (arguments.vessel.empty() || card.vessel->id == arguments.vessel))
      cards.push_back(n);
  if (cards.empty())
    return problem("--vessel " + arguments.vessel, "No such vessel can be decorated and fired.",
                   "Name one of the shelf, or leave --vessel out.");
  double now = 0;
  view::Image sheet;
  for (int n = 0; n < arguments.pots; ++n) {
    rehearsal::ScriptedVisitor::Plan plan;
    plan.seed = static_cast<std::uint64_t>(arguments.first + n);
    plan.card = cards[static_cast<std::size_t>(arguments.first + n) % cards.size()];
    plan.decorate = true;
    plan.clumsy = arguments.seconds;
    plan.linger = 1.2;
    const auto& card = kiosk.shelf().cards()[static_cast<std::size_t>(plan.card)];
    plan.glaze = card.wheel.kiln->order.front();
    auto image = visit(kiosk, plan, now);
    if (!image) return tl::unexpected(image.error());
    const view::Image whole = beside_words(*image), tile = halved(halved(whole));
    if (sheet.rgba.empty()) {
      sheet.width = std::min(kAcross, arguments.pots) * tile.width;
      sheet.height = (arguments.pots + kAcross - 1) / kAcross * tile.height;
      sheet.rgba.assign(
          static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height) * 4, 255);
    }
    lay(sheet, tile, n % kAcross, n / kAcross);
    char name[16];
    std::snprintf(name, sizeof name, "%03d_", arguments.first + n);
    if (auto kept = keep(out / (name + card.vessel->id + ".jpg"), whole); !kept)
      return tl::unexpected(kept.error());
    std::fprintf(stderr, "%s%s\n", name, card.vessel->id.c_str());
  }
  if (auto kept = keep(out / "sheet.jpg", sheet); !kept) return tl::unexpected(kept.error());
  return 0;
}

}  // namespace
}  // namespace onggi::pages

int main(int argc, char** argv) {
  onggi::pages::DecoratedArguments a;
  return onggi::pages::run_page_program(
      {.name = "onggi_page_decorated",
       .help = "Look at pots that clumsy visitors decorate",
       .examples = "Example: build/release/bin/onggi_page_decorated --out /tmp/decorated\n"
                   "One vessel of the shelf after the other, a seed each: NNN_VESSEL.jpg, and "
                   "sheet.jpg with all. It takes 5 s a pot without a GPU.",
       .options =
           {{.name = "--out", .field = &a.out, .help = "Folder for the pictures", .required = true},
            {.name = "--pots", .field = &a.pots, .help = "How many [50]", .least = 1, .most = 500},
            {.name = "--first", .field = &a.first, .help = "Seed of the first [1]", .least = 0},
            {.name = "--seconds",
             .field = &a.seconds,
             .help = "How long each decorates [60]",
             .least = 5,
             .most = 600},
            {"--vessel", &a.vessel, "Only this vessel [all]"},
            {"--config", &a.config, "The exhibit's TOML [config/exhibit.toml]"}},
       .run = [&a] { return onggi::pages::look_at_decorated(a); }},
      argc, argv);
}
