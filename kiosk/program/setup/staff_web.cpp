#include "kiosk/program/setup/staff_web.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "kiosk/program/setup/accounts.h"
#include "kiosk/program/setup/programs.h"
#include "kiosk/program/setup/step.h"

namespace fs = std::filesystem;

namespace onggi::setup {

namespace {

constexpr const char* kNginx = "/usr/sbin/nginx";
constexpr const char* kNginxUnit = "/etc/systemd/system/nginx.service";
constexpr const char* kConsoleEnvironment = "/etc/onggi/staff-web/console.env";
constexpr const char* kAddresses = "ADDRESSES=";
constexpr std::size_t kLongestName = 63;

bool there(const System& system, const char* path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(system.at(path), ignored));
}

/// The machine's names as a browser may write them: "kiosk.local", "kiosk". Empty if it has none.
std::vector<std::string> names_of(const System& system) {
  std::string name;
  std::getline(std::ifstream(system.at("/etc/hostname")) >> std::ws, name);
  name = name.substr(0, name.find_first_of(" \t.\r"));
  std::ranges::transform(name, name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  const bool good = !name.empty() && name.size() <= kLongestName && name.front() != '-' &&
                    std::ranges::all_of(name, [](char c) {
                      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
                    });
  if (!good || name == "localhost") return {};
  return {name + ".local", name};
}

/// Masked by setup, or not installed yet: in both cases Debian's page starts only if somebody wants
/// it.
bool nginx_is_ours(const System& system) {
  std::error_code none;
  return !there(system, kNginx) || fs::read_symlink(system.at(kNginxUnit), none) == "/dev/null";
}

std::string nginx_text(const StaffAddress& at, bool own) {
  std::string text = std::string(kMadeLine) + "\nlisten " + at.listen() +
                     " ssl;\nssl_certificate " + (own ? kOwnCertificate : kMadeCertificate) +
                     ";\nssl_certificate_key " + (own ? kOwnKey : kMadeKey) + ";\n";
  // A browser that was told so would refuse a certificate that setup makes anew.
  if (own) text += "add_header Strict-Transport-Security \"max-age=2592000\" always;\n";
  return text;
}

std::string console_text(const std::vector<std::string>& pages) {
  std::string text = std::string(kMadeLine) + "\nLISTEN=unix:" + kStaffSocket + '\n' + kAddresses;
  for (const std::string& page : pages) text += "--address " + page + ' ';
  text.back() = '\n';
  return text;
}

}  // namespace

bool has_own_certificate(const System& system) {
  return there(system, kOwnCertificate) && there(system, kOwnKey);
}

std::vector<Step> staff_web_steps(const StaffAddress& at, const System& system) {
  using Kind = Step::Kind;
  std::vector<std::string> pages{at.page()}, names;
  // An address first: it is the certificate's own name, and what setup prints.
  names.push_back("IP:" + at.address);
  for (const std::string& name : names_of(system)) {
    pages.push_back(at.page(name));
    names.push_back("DNS:" + name);
  }
  std::string subject;
  for (const std::string& name : names) subject += (subject.empty() ? "" : ",") + name;

  std::vector<Step> steps;
  if (nginx_is_ours(system))
    steps.push_back({Kind::mask, kNginxUnit, {}, "Debian's own page never starts at port 80"});
  steps.push_back({Kind::package, kNginx, "nginx", "serves the staff's page by HTTPS"});
  steps.push_back({Kind::package, "/usr/bin/openssl", "openssl", "makes its certificate"});
  const bool own = has_own_certificate(system);
  if (!own)
    steps.push_back({.kind = Kind::certificate,
                     .to = kMadeCertificate,
                     .from = kMadeKey,
                     .why = "the certificate of " + at.page(),
                     .text = subject});
  steps.push_back({.kind = Kind::file,
                   .to = fs::path(kStaffWeb) / "address.conf",
                   .why = at.page() + ", and no other address",
                   .text = nginx_text(at, own)});
  steps.push_back({.kind = Kind::file,
                   .to = kConsoleEnvironment,
                   .why = "the page's addresses",
                   .text = console_text(pages)});
  return steps;
}

std::vector<std::string> staff_pages(const System& system) {
  std::vector<std::string> pages;
  std::ifstream lines(system.at(kConsoleEnvironment));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(kAddresses)) continue;
    std::istringstream words(line.substr(std::string_view(kAddresses).size()));
    for (std::string word; words >> word;)
      if (word != "--address") pages.push_back(word);
  }
  return pages;
}

Result<void> start_console(const System& system) {
  if (!system.runs()) return {};
  std::vector<std::string> words{"restart", "onggi-console.service"};
  if (!staff_pages(system).empty()) words.emplace_back("onggi-staff-web.service");
  const auto status = systemctl(system, words);
  if (!status) return tl::unexpected(status.error());
  if (*status == 0) return {};
  return problem("onggi-console", "The staff's page does not start.",
                 "Look at: journalctl -b -u onggi-console -u onggi-staff-web", 1);
}

std::string staff_web_remark(const System& system) {
  if (nginx_is_ours(system)) return {};
  return "nginx.service: left alone, because this machine had nginx before. If nobody needs its "
         "pages: sudo systemctl disable --now nginx";
}

}  // namespace onggi::setup
