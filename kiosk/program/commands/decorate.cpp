#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/base/nearest_name.h"
#include "engine/base/plain_text.h"
#include "kiosk/collection/content/pack.h"
#include "kiosk/collection/decoration/write_decoration.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/composition/curators_pot.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/picture/render/window_size.h"
#include "kiosk/program/commands/commands.h"

namespace fs = std::filesystem;

namespace onggi::commands {

namespace {

volatile std::sig_atomic_t drawing_ends = 0;

struct DecorateArguments {
  std::string id, sources, simplified, out, config, language, window = "1280x720";
};

/// The folder of a vessel that was drawn: `vessel make` bakes no decoration into a scan.
Result<fs::path> folder_of(const settings::Exhibit& exhibit, const std::string& id) {
  std::error_code ignored;
  std::vector<std::string> ids;
  for (const auto& entry : fs::directory_iterator(exhibit.shelf, ignored))
    if (fs::exists(entry.path() / "vessel.toml", ignored))
      ids.push_back(entry.path().filename().string());
  if (std::ranges::find(ids, id) == ids.end()) {
    const std::string nearest = nearest_name(id, ids);
    return problem(id, "There is no such vessel on the shelf " + exhibit.shelf.string() + ".",
                   nearest.empty() ? "Name a folder there, such as moon_jar."
                                   : "Did you mean " + nearest + "?");
  }
  // Named as somebody here would name it.
  const fs::path folder = fs::proximate(exhibit.shelf / id, ignored), toml = folder / "vessel.toml";
  const content::PackRead read = content::read_pack(toml);
  if (!read.problems.empty()) return tl::unexpected(read.problems.front());
  if (read.pack.drawing.empty())
    return problem(toml.string(), "The vessel has no drawing, so it keeps its own colours.",
                   "Draw it first (kiosk/docs/draw_a_vessel.md), or name a drawn vessel.");
  return folder;
}

/// Looks before the curator begins whether what they draw can be kept.
Result<void> check_place(const fs::path& file) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(file, ignored)))
    return problem(file.string(), "The file exists, so it is not overwritten.",
                   "Move it away, or name another: -o new_decoration.toml.");
  fs::path folder = file.parent_path();
  if (folder.empty()) folder = ".";
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    return tl::unexpected(files::disk_problem(folder, "write into", errno));
  return {};
}

Result<void> check_words(const DecorateArguments& arguments) {
  for (const auto& [name, words] : {std::pair{"--sources", &arguments.sources},
                                    std::pair{"--simplified", &arguments.simplified}})
    if (words->find_first_not_of(" \t\r\n") == std::string::npos)
      return problem(name, "It is empty.",
                     "Say where the decoration is published, and what you left out of it.");
  return {};
}

/// What was written, and how it gets onto the shelf.
void tell(const fs::path& file, const fs::path& folder, const decoration::Decoration& drawn,
          const std::string& drawing) {
  std::error_code ignored;
  const auto plain = [](const fs::path& path) { return terminal::plain(path.string()); };
  const bool beside =
      fs::equivalent(file.parent_path().empty() ? "." : file.parent_path(), folder, ignored);
  std::cout << plain(file) << ": " << drawn.steps.size()
            << (drawn.steps.size() == 1 ? " step" : " steps") << "\n\nTo show it on the shelf:\n"
            << "1. onggi vessel make " << plain(folder / drawing) << " --decoration " << plain(file)
            << " -o " << plain(folder / "vessel.glb") << "\n2. "
            << (beside ? std::string() : "Copy it into " + plain(folder) + ". ") << "Write into "
            << plain(folder / "vessel.toml") << ", above the first [label]:\n"
            << "   decoration = \"" << plain(file.filename()) << "\"\n3. onggi check "
            << plain(folder) << '\n';
}

Result<int> decorate(const DecorateArguments& arguments) {
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  const settings::Exhibit exhibit = settings::read_exhibit(*config).exhibit;
  const auto folder = folder_of(exhibit, arguments.id);
  if (!folder) return tl::unexpected(folder.error());
  const fs::path file =
      arguments.out.empty() ? *folder / "decoration.toml" : fs::path(arguments.out);
  if (auto good = check_words(arguments); !good) return tl::unexpected(good.error());
  if (auto good = check_place(file); !good) return tl::unexpected(good.error());
  render::WindowOptions window;
  window.title = "Onggi: " + arguments.id;
  if (auto good = render::read_window_size(arguments.window, window); !good)
    return tl::unexpected(good.error());

  const std::string language =
      arguments.language.empty() ? exhibit.languages.front() : arguments.language;
  auto table = exhibit::CuratorsPot::open(*config, *folder, language, window);
  if (!table) return tl::unexpected(table.error());
  std::cout << "Decorate the pot in the window. The button Save, or closing the window, writes "
            << terminal::plain(file.string()) << "." << std::endl;
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { drawing_ends = 1; });
  while (drawing_ends == 0 && (*table)->frame(files::monotonic_seconds())) {
  }
  decoration::Decoration drawn = (*table)->decoration();
  if (drawn.steps.empty()) {
    std::cout << "Nothing was drawn, so no file was written.\n";
    return 0;
  }
  drawn.sources = arguments.sources;
  drawn.simplified = arguments.simplified;
  const std::string toml = decoration::to_toml(drawn);
  if (auto good = files::write_durably(file, std::as_bytes(std::span(toml))); !good)
    return tl::unexpected(good.error());
  if (const auto read = decoration::check_decoration(file); !read.problems.empty())
    return tl::unexpected(read.problems.front());
  tell(file, *folder, drawn, content::read_pack(*folder / "vessel.toml").pack.drawing);
  return 0;
}

}  // namespace

cli::Command decorate_command() {
  const auto a = std::make_shared<DecorateArguments>();
  return {
      .name = "decorate",
      .help = "Decorate a drawn vessel by hand, in a window, and save its steps",
      .examples =
          "Example: onggi vessel decorate maebyeong -o lotus.toml\n"
          "           --sources \"Museum, number, page\" --simplified \"Leaves without veins.\"\n"
          "The tools are those that visitors have: `way` in vessel.toml.",
      .options = {{.name = "id",
                   .field = &a->id,
                   .help = "The vessel: its folder's name on the shelf",
                   .required = true},
                  {.name = "--sources",
                   .field = &a->sources,
                   .help = "Where it is published how such a vessel was decorated",
                   .required = true},
                  {.name = "--simplified",
                   .field = &a->simplified,
                   .help = "What your drawing leaves out of it",
                   .required = true},
                  {"-o,--out", &a->out, "Write the steps there [the vessel's decoration.toml]"},
                  {"--window", &a->window, "Its size, WIDTHxHEIGHT pixels [1280x720]"},
                  {"--language", &a->language, "The window's language [the exhibit's first]"},
                  {"--config", &a->config, "The exhibit's TOML [config/exhibit.toml]"}},
      .run = [a] { return decorate(*a); }};
}

}  // namespace onggi::commands
