#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kiosk/ground/files/files_read.h"
#include "kiosk/ground/files/output.h"
#include "kiosk/ground/files/printed.h"
#include "kiosk/ground/web/server.h"
#include "kiosk/keepsake/phone/answers.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/keepsake/souvenir/printed_pot.h"
#include "kiosk/program/console/served_at.h"
#include "kiosk/program/console/staff_answers.h"

namespace {

constexpr const char* kHelp =
    "onggi-console: the staff's page of a kiosk, or visitors' keepsakes for their phones.\n"
    "The kiosk plays without it.\n\n"
    "Usage: onggi-console --site DIR [--listen 127.0.0.1:8090]    the staff's page; DIR holds\n"
    "                     config/ and content/. It prints the address to open\n"
    "       onggi-console --site DIR --listen unix:SOCKET --address https://HOST[:PORT]\n"
    "                     the same behind a proxy, which serves it by HTTPS at each --address\n"
    "       onggi-console --site DIR --code    another way in, good once and for an hour\n"
    "       onggi-console --phone-only --keepsakes DIR [--listen 127.0.0.1:8080]\n"
    "                     [--languages content/languages]\n"
    "       onggi-console --pass DIR/VISIT [--hours 24]   prints the path of a new page\n"
    "       onggi-console --stl DIR/VISIT [--to pot.stl]  writes the pot for a 3D printer\n\n"
    "Example: onggi-console --site /srv/onggi\n"
    "         onggi-console --phone-only --keepsakes /srv/onggi/keepsakes --listen "
    "192.168.4.1:8080\n"
    "Exit: 0 success, 1 a fault of the machine, 2 a mistake in the input.\n";

struct Arguments {
  std::string site, state, screens, keepsakes, listen, pass, hours = "24", languages, stl,
                                                             to = "pot.stl";
  std::vector<std::string> addresses;
  bool phone_only = false, code = false, help = false;
  std::vector<std::string_view> given;  // options, without --help
};

onggi::Result<Arguments> read(int count, char** values) {
  Arguments a;
  for (int n = 1; n < count; ++n) {
    const std::string_view name = values[n];
    if (name == "--help" || name == "-h") {
      a.help = true;
      continue;
    }
    if (name == "--phone-only" || name == "--code") {
      (name == "--code" ? a.code : a.phone_only) = true;
      a.given.push_back(name);
      continue;
    }
    std::string address;
    std::string* field = name == "--keepsakes"   ? &a.keepsakes
                         : name == "--address"   ? &address
                         : name == "--site"      ? &a.site
                         : name == "--state"     ? &a.state
                         : name == "--screens"   ? &a.screens
                         : name == "--listen"    ? &a.listen
                         : name == "--pass"      ? &a.pass
                         : name == "--hours"     ? &a.hours
                         : name == "--languages" ? &a.languages
                         : name == "--stl"       ? &a.stl
                         : name == "--to"        ? &a.to
                                                 : nullptr;
    if (field == nullptr || n + 1 == count)
      return onggi::problem(
          std::string(name),
          field == nullptr ? "This option does not exist." : "This option needs a value.",
          "See onggi-console --help.");
    a.given.push_back(name);
    *field = values[++n];
    // Most often a shell's unset variable.
    if (field->empty())
      return onggi::problem(std::string(name), "It is empty.",
                            "Name something, or leave the option out.");
    if (field == &address) a.addresses.push_back(address);
  }
  return a;
}

/// Exactly one action, and no option that it does not see.
onggi::Result<void> fitting(const Arguments& a) {
  const std::string_view action = !a.site.empty()   ? "--site"
                                  : !a.pass.empty() ? "--pass"
                                  : !a.stl.empty()  ? "--stl"
                                  : a.phone_only    ? "--phone-only"
                                                    : "";
  if (action.empty())
    return onggi::problem("onggi-console", "The action is missing.",
                          "Use --site for the staff's page, --phone-only for visitors' phones.");
  constexpr std::pair<std::string_view, std::string_view> kSeen[] = {
      {"--hours", "--pass"},          {"--to", "--stl"},       {"--state", "--site"},
      {"--code", "--site"},           {"--screens", "--site"}, {"--listen", "--site"},
      {"--listen", "--phone-only"},   {"--address", "--site"}, {"--keepsakes", "--phone-only"},
      {"--languages", "--phone-only"}};
  for (const std::string_view name : a.given) {
    const bool seen =
        name == action || std::ranges::find(kSeen, std::pair(name, action)) != std::end(kSeen);
    if (!seen)
      return onggi::problem(std::string(name), "It has no effect with " + std::string(action) + ".",
                            "Leave out one of the two: see onggi-console --help.");
  }
  return {};
}

onggi::Result<int> give(const Arguments& a) {
  char* end = nullptr;
  const double hours = std::strtod(a.hours.c_str(), &end);
  if (end == a.hours.c_str() || *end != '\0' || !(hours * 3600.0 >= 1.0 && hours <= 24.0 * 365.0))
    return onggi::problem("--hours " + a.hours,
                          "This is not a number of hours from 0.0003 (a second) to 8760.",
                          "Write --hours 24 for a day.");
  const auto pass = onggi::souvenir::Passes::give_at_the_desk(a.pass, std::time(nullptr), hours);
  if (!pass) return tl::unexpected(pass.error());
  std::cout << "/k/" << pass->token << '\n';
  return 0;
}

onggi::Result<int> print(const Arguments& a) {
  const onggi::files::Output to(onggi::files::Output::Kind::stl, a.to);
  if (const auto good = to.check(); !good) {
    // This program has no --force.
    onggi::Problem problem = good.error();
    if (problem.remedy.find("--force") != std::string::npos) problem.remedy = "Name another file.";
    return tl::unexpected(problem);
  }
  const auto stl = onggi::souvenir::stl_of_visit(a.stl);
  if (!stl) return tl::unexpected(stl.error());
  if (stl->remark) std::cerr << onggi::to_text(*stl->remark) << '\n';
  if (const auto written = to.write(stl->bytes); !written) return tl::unexpected(written.error());
  if (!to.to_stdout()) std::cout << a.to << '\n';
  return 0;
}

std::filesystem::path this_program() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error);
}

/// The languages of the keepsakes' exhibit, else those beside or above the program, in the build
/// folder or where it is installed.
std::filesystem::path languages_for(const std::filesystem::path& keepsakes) {
  std::error_code error;
  for (auto folder :
       {std::filesystem::absolute(keepsakes, error).parent_path(), this_program().parent_path()})
    for (;; folder = folder.parent_path()) {
      if (const auto found = folder / "content/languages";
          std::filesystem::is_directory(found, error))
        return found;
      if (folder == folder.parent_path()) break;
    }
  return {};
}

onggi::Result<std::unique_ptr<onggi::web::Server>> listen_at(const onggi::web::Listening& at,
                                                             onggi::web::Answering& answers) {
  if (!at.file.empty()) return onggi::web::Server::listen(at.file, answers, {});
  return onggi::web::Server::listen(at.address, at.port, answers);
}

onggi::Result<int> serve(const Arguments& a) {
  const auto at = onggi::web::listening(a.listen.empty() ? "127.0.0.1:8080" : a.listen);
  if (!at) return tl::unexpected(at.error());
  std::error_code error;
  if (!std::filesystem::is_directory(a.keepsakes, error))
    return onggi::problem(
        "--keepsakes " + a.keepsakes,
        error ? "This folder cannot be opened: " + error.message() + "." : "This is not a folder.",
        "Name the exhibit's keepsake folder, and let the user who runs this "
        "program read it and all folders above it.");
  onggi::files::note_reads(false);  // it reads passes for months, and writes no output over them
  std::vector<onggi::Problem> remarks;
  onggi::phone::Answers answers(
      onggi::souvenir::OpenPasses(a.keepsakes),
      [] { return static_cast<std::int64_t>(std::time(nullptr)); },
      onggi::phone::PhoneLanguages::read(
          a.languages.empty() ? languages_for(a.keepsakes) : std::filesystem::path(a.languages),
          remarks));
  for (const onggi::Problem& remark : remarks) std::cerr << onggi::to_text(remark) << '\n';
  const auto server = listen_at(*at, answers);
  if (!server) return tl::unexpected(server.error());
  if (at->file.empty())
    std::cout << "listening at port " << (*server)->port() << std::endl;
  else
    std::cout << "listening at " << at->file.string() << std::endl;
  (*server)->run([&answers] { return answers.look_after(); });
  answers.end();
  return 0;
}

/// The program `onggi` beside this one.
std::filesystem::path onggi_program() { return this_program().parent_path() / "onggi"; }

/// Where the program keeps who may use the page of the exhibit `file`: systemd's folder, else one
/// of this user's, by the exhibit's path.
std::filesystem::path state_for(const Arguments& a, const std::filesystem::path& file) {
  if (!a.state.empty()) return a.state;
  const auto set = [](const char* name) {
    const char* value = std::getenv(name);
    return std::filesystem::path(value != nullptr ? value : "");
  };
  if (const auto given = set("STATE_DIRECTORY"); !given.empty()) return given;
  std::string own = file.parent_path().parent_path().string();
  std::replace(own.begin(), own.end(), '/', '_');
  const auto states = set("XDG_STATE_HOME");
  return (states.empty() ? set("HOME") / ".local/state" : states) / "onggi-console" / own;
}

/// Problem, exit 1, where the keepsakes are there and this user may not read them: the page would
/// say that the kiosk is off.
onggi::Result<void> may_read(const std::filesystem::path& keepsakes) {
  if (::access(keepsakes.c_str(), R_OK | X_OK) == 0 || errno != EACCES) return {};
  return onggi::problem(keepsakes.string(), "This user may not read the keepsakes.",
                        "Type sudo before the command.", 1);
}

/// Where the staff's page may listen: for this machine alone, or for a proxy.
onggi::Result<onggi::web::Listening> staff_listening(const Arguments& a) {
  auto at = onggi::web::listening(a.listen.empty() ? "127.0.0.1:8090" : a.listen);
  if (!at) return tl::unexpected(at.error());
  if (at->file.empty() && !a.addresses.empty())
    return onggi::problem("--address " + a.addresses.front(),
                          "Only a proxy serves the page at another address, and it asks by a Unix "
                          "socket.",
                          "Write --listen unix:/run/onggi-console/page.sock too.");
  if (at->address == "localhost") at->address = "127.0.0.1";
  if (at->file.empty() && at->address != "127.0.0.1" && at->address != "::1")
    return onggi::problem("--listen " + a.listen,
                          "The staff's page is for this machine alone: whoever reads along on a "
                          "network would see its code.",
                          "Write --listen 127.0.0.1:8090. From another computer: ssh -L "
                          "8090:127.0.0.1:8090 KIOSK, and open the printed address there. By "
                          "HTTPS: sudo onggi setup --console");
  return at;
}

/// The user whose `state` folder this is writes there: what root leaves in it, that user's program
/// could not change.
onggi::Result<void> become_owner_of(const std::filesystem::path& state) {
  struct stat info {};
  if (::geteuid() != 0 || ::stat(state.c_str(), &info) != 0 || info.st_uid == 0) return {};
  if (::setgroups(0, nullptr) == 0 && ::setgid(info.st_gid) == 0 && ::setuid(info.st_uid) == 0)
    return {};
  return onggi::problem(state.string(), "This program cannot become the user of this folder.",
                        "Type the command as that user.", 1);
}

/// Another way in, for the program that serves the page with this state folder. `pages`: its
/// addresses, where they are known.
onggi::Result<int> give_code(const std::filesystem::path& state, std::int64_t now,
                             const std::vector<std::string>& pages) {
  namespace console = onggi::console;
  if (auto became = become_owner_of(state); !became) return tl::unexpected(became.error());
  if (!console::Door::served(state))
    return onggi::problem(
        state.string(), "No page is served with this folder, so that a code would open nothing.",
        "Start it: sudo systemctl start onggi-console. Or, where somebody started it by hand, "
        "write the same user and --state.",
        1);
  const auto code = console::Door::give_code(state, now);
  if (!code) return tl::unexpected(code.error());
  if (pages.empty())
    std::cout << "Put this behind the page's address, within an hour. It opens once:\n  /?code="
              << *code << '\n';
  else
    std::cout << "Open this within an hour. It opens once:\n";
  for (const std::string& page : pages) std::cout << "  " << page << "/?code=" << *code << '\n';
  return 0;
}

/// The staff's page, for this machine alone or behind a proxy.
onggi::Result<int> serve_staff(const Arguments& a) {
  namespace console = onggi::console;
  const auto listening = staff_listening(a);
  if (!listening) return tl::unexpected(listening.error());
  const bool proxied = !listening->file.empty();
  onggi::Result<console::ServedAt> at = console::ServedAt{};
  if (proxied) at = console::served_by_proxy(a.addresses);
  if (!at) return tl::unexpected(at.error());
  auto site = console::Site::open(a.site);
  if (!site) return tl::unexpected(site.error());
  onggi::files::note_reads(false);  // it reads for days, and writes no output over what it read
  const std::filesystem::path file = site->file(), state = state_for(a, file);
  if (auto readable = may_read(site->exhibit().keepsake.folder); !readable)
    return tl::unexpected(readable.error());
  const auto clock = [] { return static_cast<std::int64_t>(std::time(nullptr)); };
  if (a.code) return give_code(state, clock(), at->pages);
  auto people = console::People::open(state);
  if (!people) return tl::unexpected(people.error());
  std::vector<onggi::Problem> remarks;
  const console::PageWords words(console::PageWords::folder_of(this_program()), remarks);
  for (const onggi::Problem& remark : remarks) std::cerr << onggi::to_text(remark) << '\n';
  console::StaffAnswers staff({.site = std::move(*site),
                               .check = console::FileCheck(onggi_program(), file),
                               .onggi = onggi_program(),
                               .people = std::move(*people),
                               .changes = console::ChangeLog(state),
                               .prices = state / "prices",
                               .scans = state / "scans",
                               .sheets = state / "sheets",
                               .trial = state / "trial",
                               .screens = a.screens,
                               .words = words,
                               .clock = clock});
  const auto server = listen_at(*listening, staff);
  if (!server) return tl::unexpected(server.error());
  const onggi::files::Descriptor serving = console::Door::serve(state);
  // The port may be any free one.
  if (!proxied) *at = console::served_here(listening->address, (*server)->port());
  auto door = console::Door::make(at->cookie, state, clock());
  if (!door) return tl::unexpected(door.error());
  std::cout << "The staff's page of " << file.string() << '\n'
            << "  " << at->pages.front() << "/?code=" << door->code() << '\n'
            << "Open this address in a browser within an hour. It opens once; who has a name "
               "signs in without its code.\nCtrl+C ends the page; the kiosk goes on."
            << std::endl;
  staff.open(std::move(*door), at->hosts, at->https ? "https://" : "http://");
  (*server)->run([&staff] {
    staff.look_after();
    return false;
  });
  staff.end();
  return 0;
}

}  // namespace

int main(int count, char** values) {
  const auto arguments = read(count, values);
  onggi::Result<int> done = 0;
  if (!arguments)
    done = tl::unexpected(arguments.error());
  else if (arguments->help || count == 1)
    std::cout << kHelp;
  else if (const auto good = fitting(*arguments); !good)
    done = tl::unexpected(good.error());
  else if (!arguments->site.empty())
    done = serve_staff(*arguments);
  else if (!arguments->pass.empty())
    done = give(*arguments);
  else if (!arguments->stl.empty())
    done = print(*arguments);
  else
    done = serve(*arguments);
  if (const auto printed = onggi::files::all_printed(); done && !printed)
    done = tl::unexpected(printed.error());
  if (done) return *done;
  std::cerr << onggi::to_text(done.error()) << '\n';
  return done.error().exit_code;
}
