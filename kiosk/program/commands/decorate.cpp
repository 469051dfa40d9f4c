#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/nearest_name.h"
#include "engine/base/plain_text.h"
#include "kiosk/collection/content/drawing.h"
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

struct DrawnVessel {
  fs::path folder, drawing;  ///< Named as somebody here would name them.
};

fs::path named_from_here(const fs::path& path) {
  std::error_code ignored;
  const fs::path near = fs::proximate(path, ignored);
  return near.empty() || *near.begin() == ".." ? path : near;
}

/// A vessel that was drawn: `vessel make` bakes no decoration into a scan.
Result<DrawnVessel> drawn_vessel(const settings::Exhibit& exhibit, const std::string& id) {
  std::error_code ignored;
  std::vector<std::string> ids;
  for (const auto& entry : fs::directory_iterator(exhibit.shelf, ignored))
    if (entry.is_directory(ignored)) ids.push_back(entry.path().filename().string());
  if (std::ranges::find(ids, id) == ids.end()) {
    const std::string nearest = nearest_name(id, ids);
    return problem(id, "There is no such vessel on the shelf " + exhibit.shelf.string() + ".",
                   nearest.empty() ? "Name a folder there, such as moon_jar."
                                   : "Did you mean " + nearest + "?");
  }
  const fs::path folder = named_from_here(exhibit.shelf / id), toml = folder / "vessel.toml";
  const content::PackRead read = content::read_pack(toml);
  if (!read.problems.empty()) return tl::unexpected(read.problems.front());
  if (read.pack.drawing.empty())
    return problem(toml.string(), "The vessel has no drawing, so it keeps its own colours.",
                   "Draw it first (kiosk/docs/draw_a_vessel.md), or name a drawn vessel.");
  const fs::path drawing = folder / read.pack.drawing;
  if (const auto good = content::read_drawing(drawing); !good) return tl::unexpected(good.error());
  return DrawnVessel{folder, drawing};
}

/// The file in which the steps are kept. It is made before the curator begins, so that the disk
/// takes it and nobody else has the name; if nothing comes of it, it goes again.
class StepsFile {
 public:
  static Result<StepsFile> make(const fs::path& file) {
    std::error_code ignored;
    const fs::path folder = file.parent_path().empty() ? "." : file.parent_path();
    if (!fs::is_directory(folder, ignored))
      return problem(folder.string(), "The folder does not exist.",
                     "Create it first, or name another: -o FILE.");
    if (fs::is_directory(file, ignored))
      return problem(file.string(), "It is a folder.", "Name a file in it.");
    const int made = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (made < 0 && errno == EEXIST)
      return problem(file.string(), "The file exists, so it is not overwritten.",
                     "Move it away, or name another: -o new_decoration.toml.");
    if (made < 0) return tl::unexpected(files::disk_problem(file, "write", errno));
    ::close(made);
    return StepsFile(file);
  }
  StepsFile(StepsFile&& other) noexcept : file_(std::exchange(other.file_, {})) {}
  StepsFile& operator=(StepsFile&&) = delete;
  ~StepsFile() {
    std::error_code ignored;
    if (!file_.empty() && fs::file_size(file_, ignored) == 0) fs::remove(file_, ignored);
  }

  /// Writes there, or, if somebody else has written there meanwhile, beside it. Gives the name.
  Result<fs::path> keep(const std::string& toml) {
    std::error_code ignored;
    fs::path file = file_;
    for (int n = 2; fs::exists(file, ignored) && fs::file_size(file, ignored) > 0; ++n)
      file.replace_filename(file_.stem().string() + "_" + std::to_string(n) +
                            file_.extension().string());
    if (auto good = files::write_durably(file, std::as_bytes(std::span(toml))); !good)
      return tl::unexpected(good.error());
    return file;
  }

 private:
  explicit StepsFile(fs::path file) : file_(std::move(file)) {}
  fs::path file_;
};

Result<void> check_words(const DecorateArguments& arguments) {
  for (const auto& [name, words] : {std::pair{"--sources", &arguments.sources},
                                    std::pair{"--simplified", &arguments.simplified}})
    if (words->find_first_not_of(" \t\r\n") == std::string::npos)
      return problem(name, "It is empty.",
                     "Say where the decoration is published, and what you left out of it.");
  return {};
}

/// As a shell reads it back.
std::string for_shell(const fs::path& path) {
  const std::string name = terminal::plain(path.string());
  const bool simple = std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 || c >= 0x80 ||
           std::string_view("_./+-=:@%").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (simple) return name;
  std::string out = "'";
  for (const char c : name) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// What was written, and how it gets onto the shelf.
void tell(const fs::path& file, const DrawnVessel& vessel, std::size_t steps) {
  std::error_code ignored;
  const fs::path& folder = vessel.folder;
  const bool beside =
      fs::equivalent(file.parent_path().empty() ? "." : file.parent_path(), folder, ignored);
  std::string name;
  for (const char c : terminal::plain(file.filename().string()))
    name += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  std::cout << terminal::plain(file.string()) << ": " << steps << (steps == 1 ? " step" : " steps")
            << "\n\nTo show it on the shelf:\n"
            << "1. onggi vessel make " << for_shell(vessel.drawing) << " --decoration "
            << for_shell(file) << " -o " << for_shell(folder / "vessel.glb") << "\n2. "
            << (beside ? std::string() : "Copy it into " + for_shell(folder) + ". ")
            << "Write into " << for_shell(folder / "vessel.toml") << ", above the first [label]:\n"
            << "   decoration = \"" << name << "\"\n3. onggi check " << for_shell(folder) << '\n';
}

Result<int> decorate(const DecorateArguments& arguments) {
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  const settings::ExhibitRead exhibit = settings::read_exhibit(*config);
  std::error_code ignored;
  if (!fs::exists(*config, ignored)) return tl::unexpected(exhibit.problems.front());
  const auto vessel = drawn_vessel(exhibit.exhibit, arguments.id);
  if (!vessel) return tl::unexpected(vessel.error());
  if (auto good = check_words(arguments); !good) return tl::unexpected(good.error());
  render::WindowOptions window;
  window.title = "Onggi: " + arguments.id;
  if (auto good = render::read_window_size(arguments.window, window); !good)
    return tl::unexpected(good.error());
  const fs::path file =
      arguments.out.empty() ? vessel->folder / "decoration.toml" : fs::path(arguments.out);
  auto place = StepsFile::make(file);
  if (!place) return tl::unexpected(place.error());

  const std::string language =
      arguments.language.empty() ? exhibit.exhibit.languages.front() : arguments.language;
  auto table = exhibit::CuratorsPot::open(*config, vessel->folder, language, window);
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
  const auto kept = place->keep(toml);
  if (!kept) {
    std::cout << toml << "\n# The file could not be written. Copy the lines above into one.\n";
    return tl::unexpected(kept.error());
  }
  if (const auto read = decoration::check_decoration(*kept); !read.problems.empty())
    return tl::unexpected(read.problems.front());
  tell(*kept, *vessel, drawn.steps.size());
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
