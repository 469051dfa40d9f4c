#include <algorithm>
#include <cstdio>

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/virtual_display.h"
#include "tests/pages/contact_sheets.h"
#include "tests/pages/page_program.h"

namespace fs = std::filesystem;

namespace onggi::pages {

namespace {

struct ScreensArguments {
  std::string config, out, vessel = "moon_jar";
  bool full = false, missions = false;
};

void say_state(const std::string& state) { std::fprintf(stderr, "%s\n", state.c_str()); }

/// All languages beside the exhibit's own, the exhibit's first.
std::vector<std::string> all_languages(const std::vector<std::string>& own, const fs::path& words) {
  std::vector<std::string> rest;
  std::error_code error;
  for (fs::directory_iterator at(words, error), end; !error && at != end; at.increment(error))
    if (at->path().extension() == ".toml" &&
        std::find(own.begin(), own.end(), at->path().stem()) == own.end())
      rest.push_back(at->path().stem());
  std::sort(rest.rbegin(), rest.rend());
  std::vector<std::string> all = own;
  all.insert(all.end(), rest.begin(), rest.end());
  return all;
}

Result<void> look_at_vessel(exhibit::Kiosk& kiosk, const ScreensArguments& arguments,
                            const std::vector<SheetPlan>& plans) {
  int card = 0;
  const auto& cards = kiosk.shelf().cards();
  for (std::size_t i = 0; i < cards.size(); ++i)
    if (cards[i].vessel->id == arguments.vessel) card = static_cast<int>(i);
  if (cards.empty() || cards[static_cast<std::size_t>(card)].vessel->id != arguments.vessel)
    return problem("--vessel " + arguments.vessel, "The shelf has no vessel with this name.",
                   "Name a vessel in " + kiosk.exhibit().shelf.string() + ".");
  return draw_contact_sheets(
      kiosk, [&](const auto& see) { return look_at_every_screen(kiosk, card, see); }, plans,
      arguments.out, arguments.full, say_state);
}

Result<void> look_at_missions(exhibit::Kiosk& kiosk, const ScreensArguments& arguments,
                              const std::vector<SheetPlan>& plans) {
  return draw_contact_sheets(
      kiosk, [&](const auto& see) { return look_at_every_mission(kiosk, see); }, plans,
      fs::path(arguments.out) / "missions", arguments.full, say_state);
}

Result<int> look(const ScreensArguments& arguments) {
  std::error_code error;
  if (arguments.out.empty() || (fs::create_directories(arguments.out, error), error))
    return problem("--out " + arguments.out, "This folder does not exist and cannot be created.",
                   "Name a writable folder.");
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  exhibit::KioskOptions options;
  options.config = *config;
  options.stepped = true;
  options.devices = false;
  options.keepsakes = fs::path(arguments.out) / "keepsakes";
  options.window = {.width = 1280, .height = 720, .visible = false};
  options.languages = all_languages(settings::read_exhibit(*config).exhibit.languages,
                                    files::language_folder(*config));
  auto display = files::VirtualDisplay::ensure(options.window.width, options.window.height);
  if (!display) return tl::unexpected(display.error());
  const std::vector<SheetPlan> sheets = plans(options.languages);
  // First as the exhibit is, then with all options that a curator can turn on.
  for (const bool missions : {false, true}) {
    if (!missions && arguments.missions) continue;
    options.mission = missions ? exhibit::Missions::kEvery : "";
    auto opened = exhibit::Kiosk::open(options);
    if (!opened) return tl::unexpected(opened.error());
    const auto drawn = missions ? look_at_missions(**opened, arguments, sheets)
                                : look_at_vessel(**opened, arguments, sheets);
    if (!drawn) return tl::unexpected(drawn.error());
  }
  return 0;
}

}  // namespace
}  // namespace onggi::pages

int main(int argc, char** argv) {
  onggi::pages::ScreensArguments a;
  return onggi::pages::run_page_program(
      {.name = "onggi_page_screens",
       .help = "Draw every screen in every size, language and comfort setting",
       .examples =
           "Example: build/release/bin/onggi_page_screens --out /tmp/screens --full\n"
           "It takes minutes without a GPU, and 15 minutes with --full. It fails where words\n"
           "do not fit.",
       .options = {{.name = "--out",
                    .field = &a.out,
                    .help = "Folder for the contact sheets",
                    .required = true},
                   {"--full", &a.full, "Also write each picture, as OUT/SIGHT/NN_STATE.jpg"},
                   {"--missions", &a.missions, "Draw only the missions"},
                   {"--vessel", &a.vessel, "The vessel to throw, from the shelf [moon_jar]"},
                   {"--config", &a.config, "The exhibit's TOML [config/exhibit.toml]"}},
       .run = [&a] { return onggi::pages::look(a); }},
      argc, argv);
}
