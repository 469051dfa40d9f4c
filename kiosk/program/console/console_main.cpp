#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <iterator>
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
#include "kiosk/program/console/staff_answers.h"

namespace {

constexpr const char* kHelp =
    "onggi-console: the staff's page of a kiosk, or visitors' keepsakes for their phones.\n"
    "The kiosk plays without it.\n\n"
    "Usage: onggi-console --site DIR [--listen 127.0.0.1:8090]    the staff's page; DIR holds\n"
    "                     config/ and content/. It prints the address to open\n"
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
  std::string site, state, keepsakes, listen, pass, hours = "24", languages, stl, to = "pot.stl";
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
    std::string* field = name == "--keepsakes"   ? &a.keepsakes
                         : name == "--site"      ? &a.site
                         : name == "--state"     ? &a.state
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
      {"--hours", "--pass"},           {"--to", "--stl"},
      {"--state", "--site"},           {"--code", "--site"},
      {"--listen", "--site"},          {"--listen", "--phone-only"},
      {"--keepsakes", "--phone-only"}, {"--languages", "--phone-only"}};
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

/// The languages of the keepsakes' exhibit, else those beside or above the program, in the build
/// folder or where it is installed.
std::filesystem::path languages_for(const std::filesystem::path& keepsakes) {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (auto folder : {std::filesystem::absolute(keepsakes, error).parent_path(), program})
    for (;; folder = folder.parent_path()) {
      if (const auto found = folder / "content/languages";
          std::filesystem::is_directory(found, error))
        return found;
      if (folder == folder.parent_path()) break;
    }
  return {};
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
  const auto server = onggi::web::Server::listen(at->address, at->port, answers);
  if (!server) return tl::unexpected(server.error());
  std::cout << "listening at port " << (*server)->port() << std::endl;
  (*server)->run([&answers] { return answers.look_after(); });
  answers.end();
  return 0;
}

/// The program `onggi` beside this one.
std::filesystem::path onggi_program() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "onggi";
}

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

/// The Host fields by which this server is asked.
std::vector<std::string> hosts_of(const std::string& address, std::uint16_t port) {
  const bool v6 = address.find(':') != std::string::npos;
  std::vector<std::string> hosts{v6 ? '[' + address + ']' : address};
  if (address == "127.0.0.1" || address == "::1") hosts.emplace_back("localhost");
  // A browser leaves the usual port out.
  if (port != 80)
    for (std::string& host : hosts) host += ':' + std::to_string(port);
  return hosts;
}

/// Problem, exit 1, where the keepsakes are there and this user may not read them: the page would
/// say that the kiosk is off.
onggi::Result<void> may_read(const std::filesystem::path& keepsakes) {
  if (::access(keepsakes.c_str(), R_OK | X_OK) == 0 || errno != EACCES) return {};
  return onggi::problem(keepsakes.string(), "This user may not read the keepsakes.",
                        "Type sudo before the command.", 1);
}

/// The staff's page. Until there are names and passwords, only this machine reaches it.
onggi::Result<int> serve_staff(const Arguments& a) {
  namespace console = onggi::console;
  auto at = onggi::web::listening(a.listen.empty() ? "127.0.0.1:8090" : a.listen);
  if (!at) return tl::unexpected(at.error());
  if (at->address == "localhost") at->address = "127.0.0.1";
  if (at->address != "127.0.0.1" && at->address != "::1")
    return onggi::problem("--listen " + a.listen,
                          "The staff's page is for this machine alone: whoever reads along on a "
                          "network would see its code.",
                          "Write --listen 127.0.0.1:8090. From another computer: ssh -L "
                          "8090:127.0.0.1:8090 KIOSK, and open the printed address there.");
  auto site = console::Site::open(a.site);
  if (!site) return tl::unexpected(site.error());
  onggi::files::note_reads(false);  // it reads for days, and writes no output over what it read
  const std::filesystem::path file = site->file(), state = state_for(a, file);
  if (auto readable = may_read(site->exhibit().keepsake.folder); !readable)
    return tl::unexpected(readable.error());
  auto people = console::People::open(state);
  if (!people) return tl::unexpected(people.error());
  const auto clock = [] { return static_cast<std::int64_t>(std::time(nullptr)); };
  if (a.code) {
    if (!console::Door::served(state))
      return onggi::problem(
          state.string(), "No page is served with this folder, so that a code would open nothing.",
          "Start it: sudo systemctl start onggi-console. Or, where somebody started it by hand, "
          "write the same user and --state.",
          1);
    const auto code = console::Door::give_code(state, clock());
    if (!code) return tl::unexpected(code.error());
    std::cout << "Put this behind the page's address, within an hour. It opens once:\n  /?code="
              << *code << '\n';
    return 0;
  }
  console::StaffAnswers staff({.site = std::move(*site),
                               .check = console::FileCheck(onggi_program(), file),
                               .onggi = onggi_program(),
                               .people = std::move(*people),
                               .changes = console::ChangeLog(state),
                               .clock = clock});
  const auto server = onggi::web::Server::listen(at->address, at->port, staff);
  if (!server) return tl::unexpected(server.error());
  const onggi::files::Descriptor serving = console::Door::serve(state);
  // The port may be any free one.
  const std::uint16_t port = (*server)->port();
  auto door = console::Door::make("onggi_staff_" + std::to_string(port), state, clock());
  if (!door) return tl::unexpected(door.error());
  const auto hosts = hosts_of(at->address, port);
  std::cout << "The staff's page of " << file.string() << '\n'
            << "  http://" << hosts.front() << "/?code=" << door->code() << '\n'
            << "Open this address in a browser within an hour. It opens once; who has a name "
               "signs in without its code.\nCtrl+C ends the page; the kiosk goes on."
            << std::endl;
  staff.open(std::move(*door), hosts);
  (*server)->run([&staff] {
    staff.look_after();
    return false;
  });
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
