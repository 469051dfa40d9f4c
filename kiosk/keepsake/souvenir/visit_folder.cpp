#include "kiosk/keepsake/souvenir/visit_folder.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <set>
#include <system_error>
#include <vector>

#include "kiosk/ground/files/clock_jump.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/keepsake/souvenir/keepsake.h"
#include "kiosk/keepsake/souvenir/pass.h"

namespace onggi::souvenir {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 120;
constexpr auto kLeftoverAge = std::chrono::hours(1);
// The year of the first onggi: an earlier date comes from a wrong clock.
constexpr const char* kFirst = "2026";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_plain(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' || c == '-' ||
         c == '_';
}

/// True for files that save() writes, or parts of one that a power cut left
/// (".postcard.jpg.12-3.part").
bool is_ours(const std::string& file) {
  constexpr std::array<std::string_view, 13> names{
      kRollout, kRelief, kSheet,  kPostcard, kPrint,       kPotGlb, kReplay,
      kSmall,   kShown,  kSpoken, kTurning,  kPostcardPng, kPotStl};
  return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
    return file == name ||
           (file.starts_with("." + std::string(name) + ".") && file.ends_with(".part"));
  });
}

/// True if `folder` is a real folder (no link) with only our files; adds up `bytes`.
bool holds_only_ours(const fs::path& folder, std::uintmax_t& bytes) {
  std::error_code error;
  if (fs::symlink_status(folder, error).type() != fs::file_type::directory) return false;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const bool file = fs::symlink_status(entry->path(), error).type() == fs::file_type::regular;
    if (!file || !is_ours(entry->path().filename().string())) return false;
    bytes += fs::file_size(entry->path(), error);
  }
  return !error;
}

/// True if `folder` is a real folder (no link) with a file of ours.
bool holds_one_of_ours(const fs::path& folder) {
  std::error_code error;
  if (fs::symlink_status(folder, error).type() != fs::file_type::directory) return false;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    if (is_ours(entry->path().filename().string()) &&
        fs::symlink_status(entry->path(), error).type() == fs::file_type::regular)
      return true;
  return false;
}

/// The date from which the visit in `folder` ages, as in a name: its own date, or, if a wrong clock
/// gave it a date years back, the time when a tidying with a right clock first saw it. That tidying
/// leaves its time on the folder.
std::string begin_of(const fs::path& folder, std::time_t now) {
  const std::string name = folder.filename().string();
  if (name >= kFirst) return name;
  struct stat left {};
  if (::stat(folder.c_str(), &left) == 0) {
    const std::string met = files::local_time(left.st_mtime, files::kStamp);
    if (met >= kFirst) return met;
  }
  std::error_code ignored;
  fs::last_write_time(folder, fs::file_time_type::clock::now(), ignored);
  return files::local_time(now, files::kStamp);
}

/// Visits dated before this are older than `days`. "" if nothing may be removed by age: also after
/// a jump of the clock, until the clock is trusted again.
std::string oldest_begin(int days, const std::vector<VisitOnDisk>& visits, std::time_t now) {
  if (days <= 0) return {};
  std::vector<std::time_t> times;
  for (const VisitOnDisk& visit : visits)
    if (const auto at = files::time_of_stamp(begin_of(visit.folder, now))) times.push_back(*at);
  if (files::clock_jumped(times, now)) return {};
  constexpr std::time_t kDayLength = 24 * 3600;  // s
  return files::local_time(now - days * kDayLength, files::kStamp);
}

/// True for a .partial folder that no writer uses: over an hour old. One from the future (the clock
/// was set back) waits until the clock has caught up.
bool is_leftover(const fs::path& folder) {
  std::error_code error;
  const auto changed = fs::last_write_time(folder, error);
  return !error && fs::file_time_type::clock::now() - changed > kLeftoverAge;
}

void remove_leftovers(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> leftovers;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::uintmax_t bytes = 0;
    if (is_visit_name(name) && name.ends_with(kPartial) && holds_only_ours(entry->path(), bytes) &&
        is_leftover(entry->path()))
      leftovers.push_back(entry->path());
  }
  for (const fs::path& leftover : leftovers) fs::remove_all(leftover, error);
}

}  // namespace

Result<void> remove_visit(const fs::path& folder) {
  fs::path going = folder;
  going += kPartial;
  std::error_code error;
  // A power cut may have left a part of its turning picture there.
  std::uintmax_t bytes = 0;
  if (holds_only_ours(going, bytes)) fs::remove_all(going, error);
  fs::rename(folder, going, error);
  if (!error) fs::remove_all(going, error);
  if (!error) return {};
  return problem(folder.string(),
                 "A visit's old keepsakes could not be removed: " + error.message() + ".",
                 "Make the folder writable for onggi, or remove it.", 1);
}

std::vector<NamedVisit> named_visits(const fs::path& folder) {
  constexpr std::size_t kMostOfAName = 256;  // bytes
  std::vector<NamedVisit> visits;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!is_visit_name(name) || name.ends_with(kPartial) || !holds_one_of_ours(entry->path()))
      continue;
    NamedVisit visit{name, {}};
    if (const auto words = files::read_beneath(folder / name, kSpoken, kMostOfAName))
      for (const auto byte : *words)
        if (byte != '\n') visit.spoken += static_cast<char>(byte);
    visits.push_back(std::move(visit));
  }
  std::sort(visits.begin(), visits.end(),
            [](const NamedVisit& a, const NamedVisit& b) { return a.visit > b.visit; });
  return visits;
}

bool is_visit_name(std::string_view name) { return files::begins_like(name, "9999-99-99_999999_"); }

std::string visit_name(std::string_view wanted) {
  if (!is_visit_name(wanted)) return "";
  std::string name(wanted.substr(0, kLongestName));
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !is_plain(c); }, '_');
  // Never use the name of an unfinished folder.
  while (name.ends_with(kPartial)) name[name.size() - std::string_view(kPartial).size()] = '_';
  return name;
}

std::vector<VisitOnDisk> visits_in(const fs::path& folder) {
  std::vector<VisitOnDisk> visits;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    VisitOnDisk visit{entry->path()};
    if (is_visit_name(name) && !name.ends_with(kPartial) &&
        holds_only_ours(visit.folder, visit.bytes))
      visits.push_back(visit);
  }
  // Names begin with the time, so they sort by time.
  std::sort(visits.begin(), visits.end(),
            [](const VisitOnDisk& a, const VisitOnDisk& b) { return a.folder < b.folder; });
  return visits;
}

Result<void> tidy(const fs::path& folder, const KeepsakeLimits& limits, const std::string& keep,
                  std::time_t now) {
  remove_leftovers(folder);
  const std::vector<VisitOnDisk> visits = visits_in(folder);
  const std::set<std::string> promised = Passes(folder).promised(now);
  const std::string oldest = oldest_begin(limits.days, visits, now);
  const auto quota = static_cast<std::uintmax_t>(std::max(limits.quota_mb, 0)) * 1000000u;
  std::uintmax_t total = 0;
  for (const VisitOnDisk& visit : visits) total += visit.bytes;
  Result<void> good;
  for (const VisitOnDisk& visit : visits) {
    const std::string name = visit.folder.filename().string();
    const bool over = !oldest.empty() && begin_of(visit.folder, now) < oldest;
    const bool in_the_way = total > quota && !promised.contains(name);
    if (name == keep || (!in_the_way && !over)) continue;
    if (auto removed = remove_visit(visit.folder); removed)
      total -= visit.bytes;
    else if (good)
      good = removed;
  }
  return good;
}

}  // namespace onggi::souvenir
