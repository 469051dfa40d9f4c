#include <sys/wait.h>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "kiosk/ground/files/child_process.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/program/setup/machine_setup.h"
#include "kiosk/program/setup/staff_parts.h"
#include "kiosk/program/setup/staff_web.h"

namespace onggi::commands {

namespace {

struct SetupArguments {
  std::string root = "/";
  std::string console;
  bool undo = false, dry = false, replace_desktop = false, code = false, rights = false;
};

void tell(const char* head, const std::vector<std::string>& lines) {
  if (!lines.empty()) std::cout << head << '\n';
  for (const std::string& line : lines) std::cout << "  " << line << '\n';
}

Result<int> undo(const setup::System& system, bool dry) {
  const auto report = setup::undo_setup(system, dry);
  if (!report) return tl::unexpected(report.error());
  tell(dry ? "Would undo:" : "Undone:", report->changed);
  tell(dry ? "Would keep:" : "Kept:", report->stayed);
  if (dry) return 0;
  std::cout << "This machine is no longer a kiosk.\n";
  return 0;
}

/// Another way into the staff's page, by the program that serves it.
Result<int> give_code() {
  std::error_code error;
  const auto program =
      std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "onggi-console";
  std::cout.flush();
  std::vector<std::string> words{"--site", setup::kSite, "--state", setup::kConsoleState, "--code"};
  if (const auto pages = setup::staff_pages({}); !pages.empty()) {
    words.insert(words.end(), {"--listen", std::string("unix:") + setup::kStaffSocket});
    for (const std::string& page : pages) words.insert(words.end(), {"--address", page});
  }
  auto child = files::ChildProcess::start(program.string(), words, {-1, 1, 2});
  if (!child)
    return problem(program.string(), "It could not be started.", "Install the package again.", 1);
  constexpr auto kAMinute = std::chrono::seconds(60);
  if (!child->wait_until(files::ChildProcess::Clock::now() + kAMinute))
    return problem(program.string(), "It does not end.", "Try again.", 1);
  return WIFEXITED(child->status()) ? WEXITSTATUS(child->status()) : 1;
}

/// What somebody has to know before the page is open.
Result<void> tell_of_console(const SetupArguments& arguments) {
  const setup::System system{arguments.root};
  if (auto started = setup::start_console(system); !started) return started;
  const auto pages = setup::staff_pages(system);
  if (const std::string remark = setup::staff_web_remark(system); !pages.empty() && !remark.empty())
    std::cout << remark << '\n';
  std::cout << "The staff's page starts with the machine too, at:\n";
  for (const std::string& page : pages) std::cout << "  " << page << '\n';
  if (pages.empty()) std::cout << "  http://127.0.0.1:8090, on this machine alone\n";
  std::cout << "The first way in: sudo onggi setup --code\n";
  if (pages.empty()) return {};
  std::error_code none;
  const std::filesystem::path made = system.at(setup::kMadeCertificate);
  // The museum's own, where it is used, needs no comparing.
  if (setup::has_own_certificate(system) || !std::filesystem::exists(made, none)) return {};
  std::cout << "A browser warns of the certificate once. Compare its SHA-256 fingerprint there "
               "with this one:\n  "
            << std::flush;
  return setup::tell_fingerprint(made);
}

Result<int> set_up(const SetupArguments& arguments) {
  if (arguments.code) return give_code();
  const setup::System system{arguments.root};
  if (arguments.undo) return undo(system, arguments.dry);
  setup::SetupOptions options{.system = system,
                              .dry = arguments.dry,
                              .console = arguments.console,
                              .addresses = setup::machine_addresses(),
                              .replace_desktop = arguments.replace_desktop};
  const auto report = arguments.rights ? setup::renew_rights(options) : setup::set_up(options);
  if (!report) return tl::unexpected(report.error());
  tell(arguments.dry ? "Would change:" : "Changed:", report->changed);
  tell("Unchanged:", report->stayed);
  if (arguments.dry || arguments.rights) return 0;
  std::cout << "The exhibit is " << setup::kSite << "/config/exhibit.toml; after a change: cd "
            << setup::kSite << " && onggi check\n"
            << "The kiosk starts with the machine; at once: sudo systemctl start onggi\n";
  if (!arguments.console.empty())
    if (auto told = tell_of_console(arguments); !told) return tl::unexpected(told.error());
  std::cout << "To undo all of this: sudo onggi setup --undo\n";
  return 0;
}

}  // namespace

cli::Command setup_command() {
  const auto a = std::make_shared<SetupArguments>();
  return {.name = "setup",
          .help =
              "Turn this machine into a kiosk (Debian 13 or 12, from the package), and list what "
              "changed",
          .examples =
              "Example: sudo onggi setup\n"
              "         onggi setup --dry-run\n"
              "         sudo onggi setup --console\n"
              "         sudo onggi setup --console 192.168.1.20\n"
              "         sudo onggi setup --undo",
          .options = {{"--dry-run", &a->dry,
                       "List what would be changed or undone, and change nothing"},
                      {"--undo", &a->undo, "Undo what an earlier setup changed"},
                      {.name = "--console",
                       .field = &a->console,
                       .help = "Serve the staff's page by HTTPS at this address of the machine "
                               "(192.168.1.20 or 192.168.1.20:8443), or at its only one",
                       .alone = setup::kChoose},
                      {.name = "--rights",
                       .field = &a->rights,
                       .help = "Only renew the rights of the programs' users",
                       .hidden = true},
                      {.name = "--code",
                       .field = &a->code,
                       .help = "Only print a way into the staff's page, good once and for an hour"},
                      {"--replace-desktop", &a->replace_desktop,
                       "Start the kiosk instead of the machine's desktop"},
                      {.name = "--root",
                       .field = &a->root,
                       .help = "The folder of a system's image, instead of this system",
                       .shows_default = true}},
          .run = [a] { return set_up(*a); }};
}

}  // namespace onggi::commands
