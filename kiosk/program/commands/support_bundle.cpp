#include "kiosk/program/commands/support_bundle.h"

#include <sys/utsname.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <ctime>
#include <iterator>
#include <sstream>
#include <thread>

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/composition/check_exhibit.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/helper_process.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/keepsake/store/figures_report.h"
#include "kiosk/keepsake/store/statistics.h"
#include "kiosk/keepsake/store/store_copy.h"

namespace fs = std::filesystem;

namespace onggi::commands {

namespace {

constexpr std::size_t kMostOfAFile = 1u << 20;
constexpr std::size_t kMostOfALog = 16u << 20;
constexpr const char* kLogLines = "5000";
constexpr const char* kFolder = "onggi-report";

std::string text_or_why(const fs::path& file) {
  const auto bytes = files::read_file(file, kMostOfAFile);
  if (!bytes) return file.string() + " could not be read.\n";
  return {bytes->begin(), bytes->end()};
}

std::string of_helper(const files::Helper& helper) {
  const auto said = files::run_helper(helper);
  if (!said) return to_text(said.error()) + "\n";
  if (said->empty()) return helper.program + " printed nothing: run sudo onggi report.\n";
  return {reinterpret_cast<const char*>(said->data()), said->size()};
}

/// The lines of a file that begin with one of `wanted`.
std::string lines_of(const fs::path& file, const std::vector<std::string>& wanted) {
  std::istringstream in(text_or_why(file));
  std::string out;
  for (std::string line; std::getline(in, line);)
    for (const std::string& start : wanted)
      if (line.starts_with(start)) out += line + '\n';
  return out;
}

std::string machine_text() {
  std::ostringstream out;
  out << "onggi " ONGGI_VERSION "\nwritten "
      << files::local_time(std::time(nullptr), "%Y-%m-%d %H:%M:%S %Z") << '\n';
  utsname system{};
  if (uname(&system) == 0)
    out << system.sysname << ' ' << system.release << ' ' << system.machine << '\n';
  out << lines_of("/etc/os-release", {"PRETTY_NAME="});
  // The first processor is enough.
  std::istringstream processors(lines_of("/proc/cpuinfo", {"model name"}));
  std::string first;
  std::getline(processors, first);
  out << first << "\nprocessors: " << std::thread::hardware_concurrency() << '\n'
      << lines_of("/proc/meminfo", {"MemTotal", "MemAvailable"}) << "load "
      << text_or_why("/proc/loadavg") << "seconds up " << text_or_why("/proc/uptime");
  return out.str();
}

/// Every TOML directly in the exhibit's folder, where a museum's own files are.
void add_configuration(const fs::path& config, std::vector<BundlePart>& parts) {
  std::error_code error;
  std::vector<fs::path> all;
  const fs::path folder = config.parent_path().empty() ? fs::path(".") : config.parent_path();
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    // Do not go deeper: keepsakes or other things may lie below.
    if (at->is_directory(error) &&
        (at.depth() >= 2 || files::begins_like(at->path().filename().string(), "9999-99-99_")))
      at.disable_recursion_pending();
    if (at->path().extension() == ".toml" && at->is_regular_file(error)) all.push_back(at->path());
  }
  std::sort(all.begin(), all.end());
  for (const fs::path& file : all)
    parts.push_back({"config/" + file.lexically_relative(folder).string(), text_or_why(file)});
}

std::string check_text(const fs::path& config) {
  const auto report = exhibit::check_path("", config.string());
  if (!report) return to_text(report.error()) + "\n";
  std::string out;
  for (const Problem& p : report->problems) out += to_text(p) + '\n';
  for (const auto& file : report->files) out += "checked " + file.string() + '\n';
  return out + report->summary() + '\n';
}

std::string disk_text(const fs::path& keepsakes) {
  std::error_code error;
  std::uintmax_t folders = 0;
  for (fs::directory_iterator at(keepsakes, error), end; !error && at != end; at.increment(error))
    if (at->is_directory(error)) ++folders;
  std::ostringstream out;
  out << "folders of keepsakes: " << folders << '\n';
  const fs::space_info space = fs::space(keepsakes, error);
  if (error)
    out << keepsakes.string() << ": " << error.message() << '\n';
  else
    out << "bytes free: " << space.available << " of " << space.capacity << '\n';
  return out.str();
}

std::string counts_text(const fs::path& keepsakes) {
  const auto counted = store::read_statistics(files::store_file(keepsakes).string(), "", "");
  if (!counted) return to_text(counted.error()) + "\n";
  return store::words_of(store::publish(*counted));
}

/// Length of a keepsake's name at `at` of `line`; 0: there is none.
std::size_t keepsake_at(const std::string& line, std::size_t at) {
  static constexpr std::string_view kShape = "9999-99-99_999999";
  if (!files::begins_like(std::string_view(line).substr(at), kShape)) return 0;
  std::size_t end = at + kShape.size();
  const auto goes_on = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  };
  while (end < line.size() && goes_on(line[end])) ++end;
  return end - at;
}

}  // namespace

std::string without_visitors(const std::string& text) {
  std::istringstream in(text);
  std::string out;
  for (std::string line; std::getline(in, line);) {
    line += '\n';
    std::string told;
    bool keepsake = false;
    for (std::size_t at = 0; at < line.size();) {
      const std::size_t name = keepsake_at(line, at);
      if (name == 0) {
        told += line[at++];
        continue;
      }
      keepsake = true;
      told += "KEEPSAKE";
      at += name;
    }
    // Leave out the line's time, which would tell when the keepsake was made.
    if (keepsake && line.find("Kept ") != std::string::npos) continue;
    out += told;
  }
  return out;
}

std::vector<BundlePart> gather_bundle(const BundleSources& sources,
                                      const std::function<void(const std::string&)>& step) {
  std::vector<BundlePart> parts;
  parts.push_back({"machine.txt", machine_text()});
  step("the exhibit's configuration");
  add_configuration(sources.config, parts);
  const fs::path keepsakes = settings::read_exhibit(sources.config).exhibit.keepsake.folder;
  step("onggi check");
  parts.push_back({"check.txt", check_text(sources.config)});
  step("health, crashes and disk");
  parts.push_back({"health.txt", text_or_why(sources.health)});
  parts.push_back({"crashes.txt", text_or_why(sources.state / "runs")});
  parts.push_back({"disk.txt", disk_text(keepsakes)});
  step("the log");
  parts.push_back(
      {"log.txt", of_helper({.program = "journalctl",
                             .arguments = {"--no-pager", "-q", "-o", "short-iso", "-n", kLogLines,
                                           "-u", "onggi", "-u", "onggi-display"},
                             .most_bytes = kMostOfALog,
                             .answer = "log"})});
  step("counts of visits");
  parts.push_back({"stats.txt", counts_text(keepsakes)});
  for (BundlePart& part : parts) part.text = without_visitors(part.text);
  return parts;
}

Result<std::vector<std::byte>> pack_bundle(const std::vector<BundlePart>& parts) {
  const store::CopyFolder folder;
  if (folder.path().empty())
    return problem("onggi report", "No temporary folder could be made.",
                   "Check that /tmp is writable and not full.", 1);
  for (const BundlePart& part : parts) {
    const fs::path file = folder.path() / kFolder / part.name;
    if (auto made = files::make_folder(file.parent_path()); !made)
      return tl::unexpected(made.error());
    if (auto written = files::write_durably(file, std::as_bytes(std::span(part.text))); !written)
      return tl::unexpected(written.error());
  }
  return files::run_helper(
      {.program = "tar",
       .arguments = {"--create", "--gzip", "--owner=0", "--group=0", "--sort=name", "--directory",
                     folder.path().string(), kFolder},
       .timeout_s = 60.0,
       .most_bytes = 2 * kMostOfALog,
       .answer = "archive"});
}

}  // namespace onggi::commands
