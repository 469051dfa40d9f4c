#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "engine/base/nearest_name.h"
#include "engine/base/plain_text.h"
#include "kiosk/collection/content/pack.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/exhibit/editing/edit.h"
#include "kiosk/exhibit/rehearsal/screen_tour.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/passing_folder.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/virtual_display.h"
#include "kiosk/ground/toml/stand_in.h"
#include "kiosk/picture/encoding/encode.h"
#include "kiosk/picture/render/window_size.h"
#include "kiosk/program/commands/card_on_shelf.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/program/commands/screen_asked.h"
#include "kiosk/program/commands/typed_changes.h"

namespace fs = std::filesystem;

namespace onggi::commands {

namespace {

struct ScreenArguments {
  std::string screen, vessel, language, comfort, sizes = "1280x720,1080x1920", out = ".", config,
                                                 of, without;
  std::vector<std::string> words;
  bool page = false, asked = false;
};

std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream from(list);
  for (std::string part; std::getline(from, part, ',');) parts.push_back(part);
  return parts;
}

/// `name` is one of `names`, else a Problem with the nearest one.
Result<void> be_one_of(const std::string& name, const std::vector<std::string>& names,
                       const std::string& where, const char* what) {
  if (std::ranges::find(names, name) != names.end()) return {};
  const std::string nearest = nearest_name(name, names);
  return problem(where + name, std::string("There is no such ") + what + ".",
                 (nearest.empty() ? "" : "Did you mean " + nearest + "? ") +
                     ("There are: " + joined(names) + "."));
}

struct Size {
  int width = 0, height = 0;
};
constexpr int kLargestSide = 4096;  // pixels: Renderer::draw_offscreen()

Result<std::vector<Size>> sizes_of(const std::string& list) {
  std::vector<Size> sizes;
  for (const std::string& size : parts_of(list)) {
    render::WindowOptions read;
    if (auto good = render::read_window_size(size.empty() ? "?" : size, read); !good) {
      good.error().where = "--sizes " + size;
      good.error().remedy = "For example: --sizes 1280x720,1080x1920.";
      return tl::unexpected(good.error());
    }
    if (read.width > kLargestSide || read.height > kLargestSide)
      return problem("--sizes " + size, "A picture has at most 4096 pixels a side.",
                     "For example: --sizes 3840x2160.");
    sizes.push_back({read.width, read.height});
  }
  if (sizes.empty())
    return problem("--sizes", "No size is named.", "For example: --sizes 1280x720,1080x1920.");
  return sizes;
}

/// The file of --of as it would be, for as long as this lives.
Result<std::unique_ptr<toml::StandIn>> changed(const ScreenArguments& arguments) {
  const auto changes = typed_changes(arguments.words, arguments.without, "onggi screen");
  if (!changes) return tl::unexpected(changes.error());
  if (changes->empty()) return std::unique_ptr<toml::StandIn>();
  if (arguments.of.empty())
    return problem("onggi screen " + arguments.screen,
                   "It is not said whose key " + changes->front().key + " is.",
                   "Name the file: --of config/exhibit.toml.");
  const auto draft = editing::with_changes(arguments.of, *changes);
  if (!draft) return tl::unexpected(draft.error());
  return std::make_unique<toml::StandIn>(arguments.of, draft->text);
}

/// The folder of the vessel `id`, if visitors do not see it yet or any more: a shelf of its own.
std::optional<fs::path> unseen_vessel(const fs::path& config, const std::string& id) {
  if (id.empty()) return std::nullopt;
  const settings::Exhibit exhibit = settings::read_exhibit(config).exhibit;
  const fs::path folder = exhibit.shelf / id;
  const bool hidden = std::ranges::find(exhibit.hidden, id) != exhibit.hidden.end();
  std::error_code gone;
  if (!fs::exists(folder / "vessel.toml", gone)) return std::nullopt;
  return hidden || content::is_unfinished(folder) ? std::optional(folder) : std::nullopt;
}

struct Drawn {
  std::string language;
  std::vector<view::Image> pictures;
};

Result<Drawn> draw(const ScreenArguments& arguments, const std::vector<Size>& sizes) {
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  if (arguments.screen.empty())
    return problem("onggi screen", "No screen is named.", "For example: onggi screen attract.");
  std::vector<std::string> known;
  for (const std::string_view one : rehearsal::toured_screens()) known.emplace_back(one);
  if (auto good = be_one_of(arguments.screen, known, "onggi screen ", "screen"); !good)
    return tl::unexpected(good.error());
  const std::vector<std::string> choices = parts_of(arguments.comfort);
  for (const std::string& choice : choices)
    if (auto good = be_one_of(choice, rehearsal::comfort_choices(), "--comfort ", "choice"); !good)
      return tl::unexpected(good.error());
  // A keepsake is kept there on the way to its screen. Made before there are threads.
  const auto keepsakes = files::PassingFolder::make("screen");
  if (!keepsakes) return tl::unexpected(keepsakes.error());
  if (arguments.page) be_idle_until_left();
  const auto stand_in = changed(arguments);
  if (!stand_in) return tl::unexpected(stand_in.error());

  exhibit::KioskOptions options;
  options.config = *config;
  options.stepped = true;
  options.devices = false;
  options.language = arguments.language;
  options.keepsakes = keepsakes->path();
  options.shelf = unseen_vessel(*config, arguments.vessel);
  options.window = {.width = sizes.front().width, .height = sizes.front().height, .visible = false};
  auto display = files::VirtualDisplay::ensure(options.window.width, options.window.height);
  if (!display) return tl::unexpected(display.error());
  auto opened = exhibit::Kiosk::open(options);
  if (!opened) return tl::unexpected(opened.error());
  exhibit::Kiosk& kiosk = **opened;
  const auto card = card_on_shelf(kiosk.shelf(), kiosk.exhibit().shelf.string(), arguments.vessel);
  if (!card) return tl::unexpected(card.error());
  if (auto good = rehearsal::lead_to(kiosk, arguments.screen, *card); !good)
    return tl::unexpected(good.error());

  if (*stand_in && !(*stand_in)->was_read())
    return problem(arguments.of, "This exhibit does not use this file.",
                   "Nothing of it would be seen: name another, or let the exhibit use it first.");

  Drawn drawn;
  drawn.language = kiosk.visit().language();
  kiosk.show_as(rehearsal::with_comfort(kiosk.exhibit().screen, choices), drawn.language);
  for (const Size& size : sizes)
    drawn.pictures.push_back(
        kiosk.renderer().draw_offscreen(kiosk.visit().frame(size.width, size.height)));
  return drawn;
}

Result<std::vector<std::vector<std::byte>>> encoded(const Drawn& drawn, encoding::Format format,
                                                    const std::string& screen) {
  std::vector<std::vector<std::byte>> files;
  for (const view::Image& image : drawn.pictures) {
    auto bytes = encoding::encode(image, format, {"Onggi: " + screen, "", ""});
    if (!bytes) return tl::unexpected(bytes.error());
    files.push_back(std::move(*bytes));
  }
  return files;
}

Result<int> to_files(const ScreenArguments& arguments, const Drawn& drawn) {
  const auto files = encoded(drawn, encoding::Format::png, arguments.screen);
  if (!files) return tl::unexpected(files.error());
  if (auto made = files::make_folder(arguments.out); !made) return tl::unexpected(made.error());
  for (std::size_t n = 0; n < files->size(); ++n) {
    const view::Image& image = drawn.pictures[n];
    const fs::path file = fs::path(arguments.out) / (arguments.screen + '_' + drawn.language + '_' +
                                                     std::to_string(image.width) + 'x' +
                                                     std::to_string(image.height) + ".png");
    if (auto written = files::write_durably(file, (*files)[n]); !written)
      return tl::unexpected(written.error());
    std::cout << terminal::plain(file.string()) << '\n';
  }
  return 0;
}

Result<int> to_page(const ScreenArguments& arguments, const Result<std::vector<Size>>& sizes) {
  const auto drawn = sizes ? draw(arguments, *sizes) : tl::unexpected(sizes.error());
  auto files = drawn ? encoded(*drawn, encoding::Format::jpeg, arguments.screen)
                     : tl::unexpected(drawn.error());
  return answer_page(std::move(files), drawn ? drawn->pictures : std::vector<view::Image>());
}

Result<int> screen(const ScreenArguments& arguments) {
  if (arguments.asked) return become_asked();
  const auto sizes = sizes_of(arguments.sizes);
  if (arguments.page) return to_page(arguments, sizes);
  if (!sizes) return tl::unexpected(sizes.error());
  const auto drawn = draw(arguments, *sizes);
  return drawn ? to_files(arguments, *drawn) : tl::unexpected(drawn.error());
}

}  // namespace

cli::Command screen_command() {
  const auto a = std::make_shared<ScreenArguments>();
  std::string names, choices;
  for (const std::string_view one : rehearsal::toured_screens())
    names += (names.empty() ? "" : ", ") + std::string(one);
  for (const std::string& choice : rehearsal::comfort_choices())
    choices += (choices.empty() ? "" : ", ") + choice;
  return {
      .name = "screen",
      .help = "Draw a screen as visitors see it, or would see it after a change",
      .examples =
          "Example: onggi screen attract --language ko\n"
          "         onggi screen label --vessel moon_jar --comfort larger_text --out /tmp\n"
          "         onggi screen attract --of config/exhibit.toml title.en 'A pot of your own'\n"
          "Nothing is changed. It takes 5 to 20 s without a graphics card.",
      .options =
          {{.name = "screen", .field = &a->screen, .help = "Which: " + names},
           {.name = "KEY VALUE ...",
            .field = &a->words,
            .help = "As it would be with these values, as onggi set takes them; with --of"},
           {"--of", &a->of, "The file whose keys they are"},
           {"--without", &a->without, "As it would be without these keys; commas between them"},
           {"--vessel", &a->vessel, "A vessel of the shelf [the first]"},
           {"--language", &a->language, "A language of the exhibit [its first]"},
           {"--comfort", &a->comfort,
            "With these choices of Comfort, commas between them: " + choices},
           {.name = "--sizes",
            .field = &a->sizes,
            .help = "WIDTHxHEIGHT, commas between them",
            .shows_default = true},
           {"--out", &a->out, "Folder for the PNGs [this one]"},
           {"--config", &a->config, "The exhibit's TOML [config/exhibit.toml]"},
           {.name = "--page", .field = &a->page, .help = "For the staff's page", .hidden = true},
           {.name = "--asked", .field = &a->asked, .help = "Likewise", .hidden = true}},
      .run = [a] { return screen(*a); }};
}

}  // namespace onggi::commands
