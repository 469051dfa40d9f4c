#include "kiosk/program/setup/machine_setup.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/program/setup/accounts.h"
#include "kiosk/program/setup/staff_web.h"

namespace fs = std::filesystem;

namespace onggi::setup {

namespace {

constexpr std::size_t kMostOfChanges = 1u << 20;
constexpr std::array<const char*, 11> kKinds = {"folder", "tree",    "link",       "unlink",
                                                "enable", "disable", "share",      "file",
                                                "mask",   "package", "certificate"};
constexpr const char* kDesktop = "/etc/systemd/system/display-manager.service";

std::string line_of(const Step& step) {
  return std::string(kKinds.at(static_cast<std::size_t>(step.kind))) + '\t' + step.to.string() +
         '\t' + step.from.string() + '\n';
}

/// Ignore unknown lines: their changes cannot be undone.
std::vector<Step> remembered(const System& system) {
  std::vector<Step> steps;
  const auto bytes = files::read_file(system.at(kChanges), kMostOfChanges);
  if (!bytes) return steps;
  std::istringstream lines(std::string(bytes->begin(), bytes->end()));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string kind, to, from;
    std::getline(fields, kind, '\t');
    std::getline(fields, to, '\t');
    std::getline(fields, from, '\t');
    const auto at = std::find(kKinds.begin(), kKinds.end(), kind);
    if (at != kKinds.end() && !to.empty())
      steps.push_back({static_cast<Step::Kind>(at - kKinds.begin()), to, from});
  }
  return steps;
}

Result<void> remember(const std::vector<Step>& steps, const System& system) {
  std::string text;
  for (const Step& step : steps) text += line_of(step);
  const fs::path file = system.at(kChanges);
  if (auto made = files::make_folder(file.parent_path()); !made) return made;
  return files::write_durably(file, std::as_bytes(std::span(text)));
}

Result<void> may_change(const System& system) {
  if (::geteuid() == 0 || system.root != "/") return {};
  return problem("onggi setup", "Only root may change what starts with this machine.",
                 "Run: sudo onggi setup", 1);
}

Step keepsake_rights() {
  return {Step::Kind::share, fs::path(kSite) / "keepsakes", kKeepsakesGroup,
          "the pages for phones and for staff may delete there"};
}

/// Whoever serves the staff's page may change the exhibit; the kiosk may not.
std::vector<Step> site_rights() {
  std::vector<Step> steps;
  for (const char* folder : {"config", "content", "revisions"})
    steps.push_back({Step::Kind::share, fs::path(kSite) / folder, kSiteGroup,
                     "the staff's page may change it"});
  return steps;
}

Result<SetupReport> make(const std::vector<Step>& steps, const SetupOptions& options) {
  SetupReport report;
  std::vector<Step> changed = remembered(options.system);
  for (const Step& step : steps) {
    const bool given = std::any_of(changed.begin(), changed.end(), [&](const Step& before) {
      return before.kind == Step::Kind::tree && step.kind == before.kind && step.to == before.to;
    });
    if (given) {
      report.stayed.push_back(step.to.string() + ": unchanged, because it is the museum's own");
      continue;
    }
    const auto change = apply(step, options.system, options.dry);
    if (!change) return tl::unexpected(change.error());
    (change->changed ? report.changed : report.stayed).push_back(change->told);
    // A tree that was already there now belongs to the museum too.
    if (options.dry || !(change->changed || step.kind == Step::Kind::tree)) continue;
    // A change that was made again, as a certificate is, is undone once.
    if (std::ranges::any_of(changed, [&step](const Step& before) {
          return before.kind == step.kind && before.to == step.to;
        }))
      continue;
    changed.push_back(step);
    if (auto good = remember(changed, options.system); !good) return tl::unexpected(good.error());
  }
  return report;
}

}  // namespace

Result<std::vector<Step>> kiosk_steps(const SetupOptions& options) {
  using Kind = Step::Kind;
  const fs::path site = kSite, config = options.data / "config", content = options.data / "content",
                 files = options.data / "system";
  std::vector<Step> steps = {
      {Kind::tree, site / "config", config, "the exhibit, its scenes and devices, yours to change"},
      {Kind::tree, site / "content/vessels", content / "vessels", "the shelf, yours too"},
      {Kind::tree, site / "content/lessons", content / "lessons", "what the first minute teaches"},
      {Kind::tree, site / "content/ways", content / "ways", "how visitors decorate their pots"},
      {Kind::tree, site / "content/glazes.toml", content / "glazes.toml", "the kiln's glazes"},
      {Kind::tree, site / "content/missions.toml", content / "missions.toml",
       "what else visitors may be asked to do"},
      {Kind::folder, site / "keepsakes", {}, "what visitors made"},
      keepsake_rights(),
      {Kind::link, "/etc/X11/xorg.conf.d/90-onggi.conf", files / "90-onggi.conf",
       "the screen stays on, and no keys leave it"},
      {Kind::link, "/etc/systemd/journald.conf.d/onggi.conf", files / "journald.conf",
       "the log takes 64 MB at most"},
      {Kind::link, "/var/lib/prometheus/node-exporter/onggi.prom", "/run/onggi/onggi.prom",
       "the kiosk's health, for node_exporter", true},
      {Kind::disable, "getty@tty1.service", {}, "the login on the first screen is turned off"}};
  std::error_code none;
  if (const fs::path desktop = fs::read_symlink(options.system.at(kDesktop), none);
      !desktop.empty()) {
    if (!options.replace_desktop)
      return problem(desktop.filename().string(),
                     "A desktop starts with this machine and would hold its screen.",
                     "Run: sudo onggi setup --replace-desktop", 1);
    // Debian starts its desktops only through this name, because most of their units cannot be
    // enabled.
    steps.push_back({Kind::unlink, kDesktop, desktop, "the kiosk replaces the desktop"});
  }
  steps.push_back({Kind::enable, "onggi-display.service", {}, "the screen"});
  steps.push_back({Kind::enable, "onggi.service", {}, "the kiosk"});
  if (options.console.empty()) return steps;
  for (Step& step : site_rights()) steps.push_back(std::move(step));
  const auto at = staff_address(options.console, options.addresses, options.system);
  if (!at) return tl::unexpected(at.error());
  if (at->is_loop() && !staff_pages(options.system).empty())
    return problem("--console " + options.console, "The page is served by HTTPS already.",
                   "Run: sudo onggi setup --undo, and then this again.");
  if (!at->is_loop())
    for (Step& step : staff_web_steps(*at, options.system)) steps.push_back(std::move(step));
  steps.push_back({Kind::enable, "onggi-console.service", {}, "the staff's page"});
  if (!at->is_loop())
    steps.push_back({Kind::enable, "onggi-staff-web.service", {}, "the staff's page, by HTTPS"});
  return steps;
}

Result<SetupReport> set_up(const SetupOptions& options) {
  if (!options.dry)
    if (auto may = may_change(options.system); !may) return tl::unexpected(may.error());
  const auto steps = kiosk_steps(options);
  if (!steps) return tl::unexpected(steps.error());
  return make(*steps, options);
}

Result<SetupReport> renew_rights(const SetupOptions& options) {
  if (auto may = may_change(options.system); !may) return tl::unexpected(may.error());
  const std::vector<Step> before = remembered(options.system);
  const auto was_made = [&before](Step::Kind kind, const fs::path& to) {
    return std::ranges::any_of(
        before, [&](const Step& step) { return step.kind == kind && step.to == to; });
  };
  std::vector<Step> steps;
  std::error_code ignored;
  if (fs::is_directory(options.system.at(keepsake_rights().to), ignored))
    steps.push_back(keepsake_rights());
  if (was_made(Step::Kind::enable, "onggi-console.service"))
    for (Step& step : site_rights()) steps.push_back(std::move(step));
  return make(steps, options);
}

Result<SetupReport> undo_setup(const System& system, bool dry) {
  if (!dry)
    if (auto may = may_change(system); !may) return tl::unexpected(may.error());
  std::vector<Step> steps = remembered(system);
  if (steps.empty())
    return problem(system.at(kChanges).string(), "There is no setup to take back.",
                   "onggi setup makes a kiosk of this machine.");
  SetupReport report;
  while (!steps.empty()) {
    const auto change = take_back(steps.back(), system, dry);
    if (!change) return tl::unexpected(change.error());
    (change->changed ? report.changed : report.stayed).push_back(change->told);
    steps.pop_back();
    if (dry) continue;
    if (auto good = remember(steps, system); !good) return tl::unexpected(good.error());
  }
  if (dry) return report;
  std::error_code ignored;
  fs::remove_all(system.at(kChanges).parent_path(), ignored);
  return report;
}

}  // namespace onggi::setup
