#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/base/plain_text.h"
#include "kiosk/ground/files/child_process.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/keepsake/souvenir/printed_pot.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/program/desk/kept.h"

namespace onggi::commands {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNewest = 20;           // listed where nobody names one
constexpr std::size_t kMostTaken = 1u << 28;  // bytes; more than onggi writes
constexpr auto kPatience = std::chrono::seconds(60);
/// What a visitor takes home.
constexpr std::array kTaken{souvenir::kPostcard, souvenir::kPotGlb, souvenir::kTurning,
                            souvenir::kRollout,  souvenir::kSheet,  souvenir::kPostcardPng,
                            souvenir::kPotStl};
/// What is printed: the first of these that is there. The first two have the visitor's code.
constexpr std::array kPrinted{souvenir::kPrint, souvenir::kPostcardPng, souvenir::kPostcard};

struct KeepsakeArguments {
  std::string name, to, printer, language, keepsakes, config;
};

/// "2026-05-04 14:15:03  quiet blue heron  moon_jar"
std::string line_of(const desk::Kept& kept, const souvenir::NamedVisit& one) {
  return terminal::plain(desk::day_of(one.visit) + ' ' + desk::time_of(one.visit) + "  " +
                         kept.said(one) + "  " + desk::vessel_of(one.visit));
}

Result<souvenir::NamedVisit> only(const desk::Kept& kept, const std::string& typed) {
  const auto found = kept.called(typed);
  if (found.size() == 1) return found.front();
  if (found.empty())
    return problem(typed, "No keepsake here has this name.",
                   "Look for a word of it, or for its time: onggi keepsake find.");
  return problem(typed, std::to_string(found.size()) + " keepsakes have this in their name.",
                 "Write all three words, or the date and time: onggi keepsake find \"" + typed +
                     "\" lists them.");
}

Result<desk::Kept> open_kept(const KeepsakeArguments& arguments) {
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  std::vector<Problem> remarks;
  auto kept = desk::open_kept({*config, arguments.keepsakes, arguments.language}, remarks);
  for (const Problem& p : remarks) std::cerr << to_text(p) << '\n';
  return kept;
}

Result<int> find(const KeepsakeArguments& arguments) {
  const auto kept = open_kept(arguments);
  if (!kept) return tl::unexpected(kept.error());
  auto found = arguments.name.empty() ? kept->visits : kept->called(arguments.name);
  if (found.empty() && !arguments.name.empty())
    return tl::unexpected(only(*kept, arguments.name).error());
  if (arguments.name.empty() && found.size() > kNewest) found.resize(kNewest);
  for (const souvenir::NamedVisit& one : found) std::cout << line_of(*kept, one) << '\n';
  if (found.empty()) std::cout << "Nobody has kept anything yet.\n";
  return 0;
}

Result<int> copy(const KeepsakeArguments& arguments) {
  const auto kept = open_kept(arguments);
  if (!kept) return tl::unexpected(kept.error());
  const auto one = only(*kept, arguments.name);
  if (!one) return tl::unexpected(one.error());
  std::error_code error;
  if (!fs::is_directory(arguments.to, error))
    return problem(arguments.to, "There is no such folder.",
                   "Plug in the stick, and name the folder that it is opened as.");
  if (files::is_within(arguments.to, kept->folder))
    return problem(arguments.to, "This folder lies among the keepsakes.",
                   "Name a folder elsewhere, such as that of a stick.");
  const fs::path to = fs::path(arguments.to) / (one->spoken.empty() ? one->visit : one->spoken);
  if (auto made = files::make_folder(to); !made) return tl::unexpected(made.error());
  for (const char* name : kTaken) {
    const auto bytes = files::read_beneath(kept->folder / one->visit, name, kMostTaken);
    if (!bytes && bytes.error().kind == files::ReadFault::Kind::missing) continue;
    if (!bytes)
      return problem((kept->folder / one->visit / name).string(),
                     "The file cannot be read. " + bytes.error().reason,
                     "Type sudo before the command.", 1);
    if (auto put = files::write_durably(to / name, std::as_bytes(std::span(*bytes))); !put)
      return tl::unexpected(put.error());
  }
  const fs::path stl = to / souvenir::kPotStl;
  if (fs::exists(to / souvenir::kPotGlb, error) && !fs::exists(stl, error)) {
    const auto print = souvenir::stl_of_visit(kept->folder / one->visit);
    if (!print) return tl::unexpected(print.error());
    if (print->remark) std::cerr << to_text(*print->remark) << '\n';
    if (auto made = files::write_durably(stl, print->bytes); !made)
      return tl::unexpected(made.error());
  }
  std::cout << "Copied to " << terminal::plain(to.string()) << '\n';
  return 0;
}

Result<int> print(const KeepsakeArguments& arguments) {
  const auto kept = open_kept(arguments);
  if (!kept) return tl::unexpected(kept.error());
  const auto one = only(*kept, arguments.name);
  if (!one) return tl::unexpected(one.error());
  std::vector<std::string> words{"-t", kept->said(*one), "-o", "print-scaling=fit"};
  if (!arguments.printer.empty()) words.insert(words.end(), {"-d", arguments.printer});
  const fs::path visit = kept->folder / one->visit;
  std::error_code error;
  const auto printed = std::ranges::find_if(
      kPrinted, [&](const char* name) { return fs::is_regular_file(visit / name, error); });
  if (printed == kPrinted.end())
    return problem(visit.string(), "There is no postcard here.", "Name another keepsake.");
  words.insert(words.end(), {"--", (visit / *printed).string()});
  std::cout.flush();
  auto lp = files::ChildProcess::start("lp", words, {-1, 1, 2});
  if (!lp)
    return problem("lp",
                   lp.error() == ENOENT ? "This machine has no printing system."
                                        : "The printing system could not be started.",
                   "Install it with sudo apt install cups, and add the printer at "
                   "http://localhost:631; or take the postcard to another machine: onggi keepsake "
                   "copy.",
                   1);
  const bool ended = lp->wait_until(files::ChildProcess::Clock::now() + kPatience);
  if (!ended || lp->status() != 0)
    return problem("lp", "The postcard was not printed.",
                   "lpstat -p -d lists the printers. Name one: --printer NAME.", 1);
  return 0;
}

Result<int> remove(const KeepsakeArguments& arguments) {
  const auto kept = open_kept(arguments);
  if (!kept) return tl::unexpected(kept.error());
  const auto one = only(*kept, arguments.name);
  if (!one) return tl::unexpected(one.error());
  // What a word or a day happens to mean today is not enough to delete for good.
  constexpr std::size_t kWholeTime = 17;  // "2026-05-04_141503"
  const std::string stamp = desk::stamp_of(arguments.name);
  const bool by_time = stamp.size() >= kWholeTime && one->visit.starts_with(stamp);
  if (!by_time && !kept->names.is_called(one->spoken, arguments.name))
    return problem(arguments.name, "This is not a whole name: " + line_of(*kept, *one) + ".",
                   "Write all three words, or the date and time, to delete it.");
  if (auto gone = souvenir::remove_visit(kept->folder / one->visit); !gone)
    return tl::unexpected(gone.error());
  souvenir::Passes(kept->folder).take_back_all(one->visit);
  std::cout << "Deleted: " << line_of(*kept, *one) << '\n';
  return 0;
}

using Arguments = std::shared_ptr<KeepsakeArguments>;

cli::Command desk_command(const Arguments& a, const char* name, const char* help,
                          const char* example, std::vector<cli::Option> own,
                          Result<int> (*run)(const KeepsakeArguments&)) {
  own.push_back({"--keepsakes", &a->keepsakes, "Their folder [the exhibit's]"});
  own.push_back({"--config", &a->config, "The exhibit's TOML [config/exhibit.toml]"});
  own.push_back({"--language", &a->language, "Say names in it [the exhibit's first]"});
  return {
      .name = name, .help = help, .examples = example, .options = std::move(own), .run = [a, run] {
        return run(*a);
      }};
}

cli::Option name_of(const Arguments& a, bool required) {
  return {
      .name = "name",
      .field = &a->name,
      .help = "Its three words in quotes, in any language; or one of them, or its date and time",
      .required = required};
}

}  // namespace

cli::Command keepsake_command() {
  const auto a = std::make_shared<KeepsakeArguments>();
  return {
      .name = "keepsake",
      .help = "For the desk: find, copy, print or delete what a visitor kept",
      .examples =
          "Example: onggi keepsake find \"quiet blue heron\"\n"
          "         onggi keepsake print \"quiet blue heron\"",
      .commands = {
          desk_command(a, "find", "List keepsakes by name; without a name the newest 20",
                       "Example: onggi keepsake find heron", {name_of(a, false)}, find),
          desk_command(a, "copy", "Copy a keepsake to a folder or a stick",
                       "Example: onggi keepsake copy \"quiet blue heron\" /media/stick",
                       {name_of(a, true),
                        {.name = "to", .field = &a->to, .help = "A folder", .required = true}},
                       copy),
          desk_command(a, "print", "Print a postcard, where this machine has a printer",
                       "Example: onggi keepsake print \"quiet blue heron\"",
                       {name_of(a, true), {"--printer", &a->printer, "A printer [the usual one]"}},
                       print),
          desk_command(a, "delete", "Delete a keepsake for good",
                       "Example: onggi keepsake delete \"quiet blue heron\"", {name_of(a, true)},
                       remove)}};
}

}  // namespace onggi::commands
