#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "engine/base/nearest_name.h"
#include "engine/base/plain_text.h"
#include "kiosk/collection/content/address.h"
#include "kiosk/collection/content/language.h"
#include "kiosk/collection/content/translation_tables.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/virtual_display.h"
#include "kiosk/keepsake/souvenir/poster.h"
#include "kiosk/picture/encoding/encode.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/program/commands/commands.h"

namespace fs = std::filesystem;

namespace onggi::commands {

namespace {

struct PosterArguments {
  std::string config, vessel, language, address;
  files::Output out{files::Output::Kind::png, "poster.png"};
};

/// The pictured vessel: `wanted`, else the first of the shelf's order.
Result<content::Vessel> vessel_of(const settings::Exhibit& exhibit, const std::string& wanted) {
  std::error_code ignored;
  std::vector<std::string> ids;
  for (const auto& entry : fs::directory_iterator(exhibit.shelf, ignored))
    if (entry.is_directory(ignored)) ids.push_back(entry.path().filename().string());
  const std::string id = !wanted.empty()          ? wanted
                         : !exhibit.order.empty() ? exhibit.order.front()
                                                  : std::string();
  if (std::ranges::find(ids, id) == ids.end()) {
    const std::string nearest = nearest_name(id, ids);
    return problem("--vessel " + id,
                   "There is no such vessel on the shelf " + exhibit.shelf.string() + ".",
                   nearest.empty() ? "Name a folder there, such as --vessel moon_jar."
                                   : "Did you mean " + nearest + "?");
  }
  content::LoadOptions options;
  options.limits = exhibit.reader;
  options.for_screen = true;
  return content::load_vessel(exhibit.shelf / id, options);
}

std::string joined_by_comma(const content::Label& label) {
  std::string all;
  for (const std::string& part : {label.title, label.culture, label.date})
    if (!part.empty()) all += (all.empty() ? "" : ", ") + part;
  return all;
}

Result<view::Image> draw(const souvenir::PosterWords& words, const content::Vessel& vessel) {
  const auto display = files::VirtualDisplay::ensure(640, 480);
  if (!display) return tl::unexpected(display.error());
  auto renderer = render::Renderer::create({640, 480, false, "Onggi"});
  if (!renderer) return tl::unexpected(renderer.error());
  const view::PictureId pot = (*renderer)->draw_picture(
      *(*renderer)->prepare_picture(vessel.mesh, vessel.color, vessel.coloring,
                                    souvenir::kPosterPotWidth, souvenir::kPosterPotHeight));
  return (*renderer)->draw_offscreen(souvenir::compose_poster(words, pot, (*renderer)->measure()));
}

Result<int> poster(const PosterArguments& arguments) {
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  const settings::Exhibit exhibit = settings::read_exhibit(*config).exhibit;
  const std::string code =
      arguments.language.empty() ? exhibit.languages.front() : arguments.language;
  const fs::path languages = files::language_folder(*config);
  const auto language = content::Language::read(languages / (code + ".toml"));
  if (!language) return tl::unexpected(language.error());
  if (!arguments.address.empty())
    if (const std::string fault = content::fault_of_address(arguments.address); !fault.empty())
      return problem("--address " + arguments.address, fault,
                     "Write the web page that a phone should open: https://museum.org.");
  auto vessel = vessel_of(exhibit, arguments.vessel);
  if (!vessel) return tl::unexpected(vessel.error());
  content::translate(*vessel, content::read_translations(languages, {code}));

  const content::Label label = vessel->label(code);
  souvenir::PosterWords words;
  const auto title = exhibit.title.find(code);
  words.title = title != exhibit.title.end() ? title->second : language->say("attract.title");
  words.lead = language->say("attract.lead");
  words.vessel = joined_by_comma(label);
  words.credit = label.credit.empty() ? vessel->credit : label.credit;
  words.museum = exhibit.credit;
  words.address = arguments.address;
  words.address_words = content::short_address(arguments.address);
  words.language = code;
  words.right_to_left = language->right_to_left();
  const auto image = draw(words, *vessel);
  if (!image) return tl::unexpected(image.error());
  const auto png =
      encoding::encode(*image, encoding::Format::png, {words.title, exhibit.credit, words.vessel});
  if (!png) return tl::unexpected(png.error());
  if (auto good = arguments.out.write(*png); !good) return tl::unexpected(good.error());
  if (!arguments.out.to_stdout())
    std::cout << terminal::plain(arguments.out.where())
              << ": a poster, A4 upright at 300 dots an inch\n";
  return 0;
}

}  // namespace

cli::Command poster_command() {
  const auto a = std::make_shared<PosterArguments>();
  return {.name = "poster",
          .help = "Draw a poster that invites visitors: the exhibit's title and a vessel",
          .examples =
              "Example: onggi poster -o poster.png --vessel moon_jar --address https://museum.org\n"
              "It is A4 upright at 300 dots an inch. The words are the exhibit's own.",
          .options = {{"-o,--out", &a->out, "Write the PNG there [poster.png]"},
                      {"--vessel", &a->vessel, "The pictured vessel [the first of `order`]"},
                      {"--language", &a->language, "The words' language [the exhibit's first]"},
                      {"--address", &a->address, "A web page, as a code for phones [none]"},
                      {"--config", &a->config, "The exhibit's TOML [config/exhibit.toml]"}},
          .run = [a] { return poster(*a); }};
}

}  // namespace onggi::commands
