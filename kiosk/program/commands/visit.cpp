#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "engine/base/nearest_name.h"
#include "engine/script/script.h"
#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/exhibit/rehearsal/aided_walk.h"
#include "kiosk/exhibit/rehearsal/scripted_visitor.h"
#include "kiosk/exhibit/rehearsal/visit_report.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/virtual_display.h"
#include "kiosk/picture/drawing/put_report.h"
#include "kiosk/picture/encoding/encode.h"
#include "kiosk/picture/render/window_size.h"
#include "kiosk/program/commands/card_on_shelf.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/program/commands/visit_out.h"

namespace fs = std::filesystem;

namespace onggi::commands {

namespace {

// 25 frames a second of visit if a script moves the hands; 50 for strokes on the screen.
constexpr int kScriptTicks = 40, kStrokeTicks = 20;
constexpr double kTick = 0.001;       // s
constexpr double kFilmSeconds = 5.0;  // between the pictures of a film
constexpr const char *kNaive = "naive", *kBlind = "blind", *kSwitch = "switch", *kFollow = "follow";

struct VisitArguments {
  std::string config, script = kFollow, vessel, out, window = "1280x720", language, shelf, glaze,
                      hand = "script", film, pointer = "mouse", mission;
  files::Output json{files::Output::Kind::json};
  double seconds = 90, pace = 1.5, clumsy = 0;
  std::uint64_t seed = 1;
  bool realtime = false, decorate = false, no_screens = false;
};

/// Finds the named vessel: a file makes a shelf of one, an id is looked up on the exhibit's shelf.
struct Choice {
  std::optional<fs::path> shelf;
  std::string id;
};

Choice choose(const VisitArguments& arguments) {
  std::error_code ignored;
  if (fs::is_regular_file(arguments.vessel, ignored) ||
      fs::exists(fs::path(arguments.vessel) / "vessel.toml", ignored))
    return {arguments.vessel, ""};
  if (!arguments.shelf.empty()) return {arguments.shelf, arguments.vessel};
  return {std::nullopt, arguments.vessel};
}

/// Index among the missions that are on; -1: none is wanted.
Result<int> find_mission(const exhibit::Kiosk& kiosk, const std::string& id) {
  if (id.empty()) return -1;
  const auto& cards = kiosk.missions().cards();
  for (std::size_t n = 0; n < cards.size(); ++n)
    if (cards[n].mission->id == id) return static_cast<int>(n);
  const auto& file = kiosk.exhibit().missions;
  if (!file)
    return problem("--mission " + id, "The exhibit has no missions.",
                   "Write missions = \"FILE\" in " + kiosk.exhibit().file.string() + ".");
  std::vector<std::string> ids;
  for (const settings::Mission& one : settings::read_missions(*file).missions)
    ids.push_back(one.id);
  const std::string nearest = nearest_name(id, ids);
  return problem("--mission " + id, "No mission with this id can be played.",
                 (nearest.empty() || nearest == id ? "" : "Did you mean " + nearest + "? ") +
                     "In " + file->string() + " there are: " + joined(ids) + ". Try onggi check.");
}

/// Without an id: the vessel's own.
Result<int> find_glaze(const exhibit::Kiosk& kiosk, const screens::ShelfCard& card,
                       const std::string& id) {
  std::vector<std::string> ids;
  for (const content::Glaze& glaze : kiosk.glazes()) ids.push_back(glaze.id);
  if (id.empty()) return card.wheel.kiln ? card.wheel.kiln->order.front() : 0;
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found != ids.end()) return static_cast<int>(found - ids.begin());
  return problem("--glaze " + id, "The exhibit has no such glaze.",
                 ids.empty() ? "Its scene has no kiln, or its glazes could not be read."
                             : "There are: " + joined(ids) + ".");
}

/// Collects the pictures of the passed screens, and encodes them after the visit.
class ScreenAlbum {
 public:
  ScreenAlbum(exhibit::Kiosk& kiosk, fs::path folder, bool wanted = true)
      : kiosk_(kiosk), folder_(std::move(folder)), wanted_(wanted) {}

  void take(const std::string& name) {
    if (wanted_) pages_.push_back({name, kiosk_.picture()});
  }

  Result<std::vector<fs::path>> write() const {
    std::vector<fs::path> written;
    if (pages_.empty()) return written;
    if (auto good = files::make_folder(folder_); !good) return tl::unexpected(good.error());
    for (std::size_t i = 0; i < pages_.size(); ++i) {
      const std::string number = (i < 9 ? "0" : "") + std::to_string(i + 1);
      const fs::path file = folder_ / (number + "_" + pages_[i].name + ".png");
      auto bytes = encoding::encode(pages_[i].image, encoding::Format::png,
                                    {"Onggi: " + pages_[i].name, kiosk_.exhibit().credit, ""});
      if (!bytes) return tl::unexpected(bytes.error());
      if (auto good = files::write_durably(file, *bytes); !good)
        return tl::unexpected(good.error());
      written.push_back(file);
    }
    return written;
  }

 private:
  struct Page {
    std::string name;
    view::Image image;
  };
  exhibit::Kiosk& kiosk_;
  fs::path folder_;
  bool wanted_;
  std::vector<Page> pages_;
};

/// Runs frames until the visitor is done; prints the progress of the throwing.
Result<void> walk(exhibit::Kiosk& kiosk, rehearsal::ScriptedVisitor& visitor, int ticks,
                  bool realtime, ScreenAlbum* film, int& first_tick) {
  const double begun = files::monotonic_seconds();
  const double step = ticks * kTick;
  int printed = -1;
  double filmed = -kFilmSeconds;
  for (int n = 0; !visitor.done(); ++n) {
    const double now = n * step;
    kiosk.advance(ticks);
    if (!kiosk.frame(now, realtime))
      return problem("the window", "It was closed during the visit.", "Leave it open.", 1);
    if (auto good = visitor.step(now); !good) return good;
    if (visitor.throwing()) {
      if (printed < 0)
        first_tick = (n + 1) * ticks - static_cast<int>(kiosk.wheel_host().status().ticks);
      if (film != nullptr && now - filmed >= kFilmSeconds) {
        film->take(std::to_string(static_cast<int>(now + 0.5)) + "_s");
        filmed = now;
      }
      const int tenth = static_cast<int>(visitor.progress() * 10);
      if (tenth != printed) std::cerr << "throwing: " << (printed = tenth) * 10 << " %\n";
    }
    // A save runs on a worker: give it wall time, or the visit's clock would run ahead of it.
    if (kiosk.doing().saving || kiosk.doing().turning)
      std::this_thread::sleep_for(std::chrono::duration<double>(step));
    if (realtime)
      std::this_thread::sleep_for(std::chrono::duration<double>(
          std::max(0.0, begun + now + step - files::monotonic_seconds())));
  }
  return {};
}

bool aided(const VisitArguments& arguments) {
  return arguments.script == kBlind || arguments.script == kSwitch;
}

/// A visitor without sight or with one switch; the spoken words go to OUT/said.txt.
Result<void> walk(exhibit::Kiosk& kiosk, const VisitArguments& arguments, int card, int mission,
                  int glaze, ScreenAlbum& album) {
  rehearsal::AidedWalk how;
  how.blind = arguments.script == kBlind;
  how.card = card;
  how.mission = mission;
  how.glaze = glaze;
  how.realtime = arguments.realtime;
  const auto said = walk_aided(kiosk, how, [&album](const std::string& name) { album.take(name); });
  if (!said) return tl::unexpected(said.error());
  std::string lines;
  for (const access::Utterance& one : *said)
    if (!one.text.empty()) lines += one.text + '\n';
  return files::write_durably(fs::path(arguments.out) / "said.txt",
                              std::as_bytes(std::span(lines)));
}

/// Checks the arguments before a visit of a minute begins.
Result<void> check(const VisitArguments& arguments) {
  if (arguments.vessel.empty() && arguments.mission.empty())
    return problem("--vessel", "It is missing.",
                   "Write --vessel moon_jar, say, or a --mission in its place.");
  if (!arguments.vessel.empty() && !arguments.mission.empty())
    return problem("--vessel", "Use --vessel or --mission, not both.",
                   "Remove one of the two options.");
  if (arguments.out.empty())
    return problem("--out", "It is empty.", "Name a folder for the keepsake and the pictures.");
  if (arguments.hand != "script" && arguments.hand != "mouse" && arguments.hand != "device")
    return problem("--hand " + arguments.hand, "Unknown --hand.", "Write script, mouse or device.");
  if (arguments.pointer != "mouse" && arguments.pointer != "finger")
    return problem("--pointer " + arguments.pointer, "Unknown --pointer.",
                   "Use --pointer mouse or --pointer finger.");
  if (!arguments.film.empty()) {
    std::error_code error;
    if (fs::create_directories(arguments.film, error); error || !fs::is_directory(arguments.film))
      return problem("--film " + arguments.film,
                     "This folder does not exist and cannot be created.",
                     "Name a writable folder.");
  }
  if (arguments.script == kNaive || aided(arguments)) return {};
  const auto names = script_names();
  if (std::find(names.begin(), names.end(), arguments.script) == names.end()) {
    // make_script has the message for it.
    auto script = make_script(arguments.script, {});
    if (!script) return tl::unexpected(script.error());
  }
  return {};
}

Result<int> visit(const VisitArguments& arguments) {
  if (auto good = check(arguments); !good) return tl::unexpected(good.error());
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  if (auto good = make_visit_out(arguments.out, *config); !good)
    return tl::unexpected(good.error());
  exhibit::KioskOptions options;
  options.config = *config;
  options.stepped = true;
  options.devices = arguments.hand == "device";
  options.seed = arguments.seed;
  options.language = arguments.language;
  options.scan_seconds = arguments.pace;
  options.keepsakes = fs::path(arguments.out);
  options.mission = arguments.mission;
  options.window.visible = arguments.realtime;
  if (auto good = render::read_window_size(arguments.window, options.window); !good)
    return tl::unexpected(good.error());
  const Choice choice = choose(arguments);
  options.shelf = choice.shelf;

  auto display = files::VirtualDisplay::ensure(options.window.width, options.window.height);
  if (!display) return tl::unexpected(display.error());
  auto opened = exhibit::Kiosk::open(options);
  if (!opened) return tl::unexpected(opened.error());
  exhibit::Kiosk& kiosk = **opened;
  const auto card = card_on_shelf(kiosk.shelf(),
                                  choice.shelf.value_or(kiosk.exhibit().shelf).string(), choice.id);
  if (!card) return tl::unexpected(card.error());

  const auto mission = find_mission(kiosk, arguments.mission);
  if (!mission) return tl::unexpected(mission.error());

  ScreenAlbum album(kiosk, fs::path(arguments.out) / "screens", !arguments.no_screens);
  rehearsal::ScriptedVisitor::Plan plan;
  plan.script = arguments.script;
  plan.card = *card;
  plan.mission = *mission;
  // A script leads both hands of one visitor.
  plan.two = *mission >= 0 && arguments.script == kFollow &&
             kiosk.missions().cards()[static_cast<std::size_t>(*mission)].mission->kind ==
                 settings::Mission::Kind::two_hands;
  plan.seed = arguments.seed;
  using Hand = rehearsal::ScriptedVisitor::Plan::Hand;
  plan.hand = arguments.hand == "mouse"    ? Hand::pointer
              : arguments.hand == "device" ? Hand::device
                                           : Hand::script;
  const auto glaze =
      find_glaze(kiosk, kiosk.shelf().cards()[static_cast<std::size_t>(*card)], arguments.glaze);
  if (!glaze) return tl::unexpected(glaze.error());
  plan.glaze = *glaze;
  plan.decorate = arguments.decorate || arguments.clumsy > 0;
  if (arguments.clumsy > 0) plan.clumsy = arguments.clumsy;
  const bool naive = arguments.script == kNaive;
  if (naive)
    plan.naive = {arguments.seconds, arguments.pointer == "finger"
                                         ? rehearsal::NaiveHands::Pointer::finger
                                         : rehearsal::NaiveHands::Pointer::mouse};
  rehearsal::ScriptedVisitor visitor(kiosk, plan,
                                     [&album](const std::string& name) { album.take(name); });
  int first_tick = 0;
  ScreenAlbum film(kiosk, arguments.film);
  const auto walked =
      aided(arguments)
          ? walk(kiosk, arguments, *card, *mission, *glaze, album)
          : walk(kiosk, visitor, naive || plan.two ? kStrokeTicks : kScriptTicks,
                 arguments.realtime, arguments.film.empty() ? nullptr : &film, first_tick);
  // Write the pictures also after a failure, when they are needed most.
  const auto pages = album.write();
  if (!walked) return tl::unexpected(walked.error());
  if (!pages) return tl::unexpected(pages.error());
  if (const auto frames = film.write(); !frames) return tl::unexpected(frames.error());

  files::Json report = rehearsal::visit_report(*kiosk.doing().kept, *pages, visitor.looks());
  report["first_tick"] = first_tick;
  if (!arguments.mission.empty()) report["mission"] = arguments.mission;
  const auto kept = drawing::put_report(
      report, files::Output(files::Output::Kind::json, fs::path(arguments.out) / "visit.json"));
  if (!kept) return tl::unexpected(kept.error());
  const auto free = drawing::put_report(report, arguments.json);
  if (!free) return tl::unexpected(free.error());
  if (*free) std::cout << rehearsal::visit_summary(*kiosk.doing().kept);
  return 0;
}

}  // namespace

cli::Command visit_command() {
  const auto a = std::make_shared<VisitArguments>();
  std::string scripts = std::string(kNaive) + ", " + kBlind + ", " + kSwitch;
  for (const std::string_view name : script_names()) scripts += ", " + std::string(name);
  return {
      .name = "visit",
      .help = "Run a whole visit without a person, and save its picture",
      .examples =
          "Example: onggi visit --script follow --vessel moon_jar --out /tmp/visit --json -\n"
          "         onggi visit --script naive --seed 3 --vessel moon_jar --out /tmp/visit --film "
          "/tmp/film",
      .options =
          {{"--script", &a->script, "What the hands do: " + scripts + " [follow]"},
           {.name = "--vessel",
            .field = &a->vessel,
            .help = "A vessel of the shelf, a pack, or a GLB/glTF file"},
           {"--mission", &a->mission, "A mission by its id, instead of a vessel"},
           {.name = "--out",
            .field = &a->out,
            .help = "Folder for the keepsake and the screens' pictures",
            .required = true},
           {.name = "--seed",
            .field = &a->seed,
            .help = "Unevenness of the scripted hands [1]",
            .least = 0},
           {"--hand", &a->hand,
            "Who moves the hand: script (in the loop), mouse (frame by frame) or device (a  "
            "plugged-in one; the script only turns the wheel) [script]"},
           {.name = "--seconds",
            .field = &a->seconds,
            .help = "How long naive hands throw [90]",
            .least = 5,
            .most = 600},
           {.name = "--pace",
            .field = &a->pace,
            .help = "Seconds from one item to the next for one switch [1.5]",
            .least = 0.5,
            .most = 5},
           {"--pointer", &a->pointer, "The pointer of naive hands: mouse or finger [mouse]"},
           {"--no-screens", &a->no_screens, "Save no pictures of the screens: half of the time"},
           {"--film", &a->film, "A folder for a picture of every five seconds' throwing"},
           {"--json", &a->json,
            "Write the result as JSON here (- for standard output), as well as to OUT/visit.json"},
           {"--realtime", &a->realtime, "At a visitor's speed, in a visible window"},
           {"--window", &a->window, "WIDTHxHEIGHT of the screens [1280x720]"},
           {"--glaze", &a->glaze, "A glaze of the exhibit [the vessel's own]"},
           {"--decorate", &a->decorate, "Decorate the pot as its makers did"},
           {.name = "--clumsy",
            .field = &a->clumsy,
            .help = "Seconds of clumsy strokes on it instead, by --seed",
            .least = 5,
            .most = 600},
           {"--language", &a->language, "A language of the exhibit [its first]"},
           {"--config", &a->config, "The exhibit's TOML [config/exhibit.toml]"},
           {"--shelf", &a->shelf, "A folder of vessels instead of the exhibit's"}},
      .run = [a] { return visit(*a); }};
}

}  // namespace onggi::commands
