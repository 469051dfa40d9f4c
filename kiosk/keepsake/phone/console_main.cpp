#include <cstdlib>
#include <ctime>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "kiosk/ground/files/files_read.h"
#include "kiosk/ground/files/output.h"
#include "kiosk/ground/files/printed.h"
#include "kiosk/keepsake/phone/answers.h"
#include "kiosk/keepsake/phone/server.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/keepsake/souvenir/printed_pot.h"

namespace {

constexpr const char* kHelp =
    "onggi-console: serves visitors' keepsakes to their phones. The kiosk plays without it.\n\n"
    "Usage: onggi-console --phone-only --keepsakes DIR [--listen 127.0.0.1:8080]\n"
    "                     [--languages content/languages]\n"
    "       onggi-console --pass DIR/VISIT [--hours 24]   prints the path of a new page\n"
    "       onggi-console --stl DIR/VISIT [--to pot.stl]  writes the pot for a 3D printer\n\n"
    "Example: onggi-console --phone-only --keepsakes /srv/onggi/keepsakes --listen "
    "192.168.4.1:8080\n"
    "Exit: 0 success, 1 a fault of the machine, 2 a mistake in the input.\n";

struct Arguments {
  std::string keepsakes, listen = "127.0.0.1:8080", pass, hours = "24", languages, stl,
                         to = "pot.stl";
  bool phone_only = false, help = false;
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
    if (name == "--phone-only") {
      a.phone_only = true;
      a.given.push_back(name);
      continue;
    }
    std::string* field = name == "--keepsakes"   ? &a.keepsakes
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
  const std::string_view action = !a.pass.empty()  ? "--pass"
                                  : !a.stl.empty() ? "--stl"
                                  : a.phone_only   ? "--phone-only"
                                                   : "";
  if (action.empty())
    return onggi::problem("onggi-console", "The action is missing.", "Use --phone-only.");
  for (const std::string_view name : a.given) {
    const std::string_view of = name == "--hours"                     ? "--pass"
                                : name == "--to"                      ? "--stl"
                                : name == "--pass" || name == "--stl" ? name
                                                                      : "--phone-only";
    if (of != action)
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
  const auto at = onggi::phone::listening(a.listen);
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
  const auto server = onggi::phone::Server::listen(at->address, at->port, answers);
  if (!server) return tl::unexpected(server.error());
  std::cout << "listening at port " << (*server)->port() << std::endl;
  (*server)->run([&answers] { return answers.look_after(); });
  answers.end();
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
