#include "kiosk/program/setup/rights.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/program/setup/accounts.h"

namespace fs = std::filesystem;

namespace onggi::setup {

namespace {

constexpr int kDeepest = 32;
constexpr std::string_view kStore = "onggi.sqlite";

struct Rights {
  gid_t group;
  mode_t mode;
};
/// What a file or folder should have.
using Rule = std::function<Rights(const struct stat& now, const std::string& name)>;

struct CloseFolder {
  void operator()(DIR* folder) const { ::closedir(folder); }
};

/// Applies `rule` to what is at `name` in the open folder `at`, and beneath it. Counts the changes.
/// False, with errno: the system refused one.
bool walk(int at, const std::string& name, const Rule& rule, bool dry, int deep,
          std::size_t& changed) {
  // A pipe would make us wait; what has a second name may be somebody else's file.
  const files::Descriptor opened(
      ::openat(at, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat now {};
  if (!opened.open()) return errno == ELOOP || errno == ENXIO || errno == ENOENT;
  if (::fstat(opened.get(), &now) != 0) return false;
  const bool folder = S_ISDIR(now.st_mode);
  if (!folder && (!S_ISREG(now.st_mode) || now.st_nlink != 1)) return true;
  const Rights right = rule(now, name);
  const mode_t mode = now.st_mode & 07777;
  if (right.group != now.st_gid || right.mode != mode) {
    ++changed;
    // In this order: the group that it has now is given no right.
    if (!dry && ((right.group != now.st_gid &&
                  ::fchown(opened.get(), static_cast<uid_t>(-1), right.group) != 0) ||
                 ::fchmod(opened.get(), right.mode) != 0))
      return false;
  }
  if (!folder || deep == kDeepest) return true;
  const int own = ::dup(opened.get());
  const std::unique_ptr<DIR, CloseFolder> entries(own < 0 ? nullptr : ::fdopendir(own));
  if (!entries) return false;
  while (const dirent* entry = ::readdir(entries.get())) {
    const std::string below = entry->d_name;
    if (below != "." && below != ".." && !walk(opened.get(), below, rule, dry, deep + 1, changed))
      return false;
  }
  return true;
}

constexpr mode_t kFolder = S_ISGID | S_IRWXG, kFile = S_IRGRP | S_IWGRP;

Rule exhibit_of(gid_t group) {
  return [group](const struct stat& now, const std::string&) {
    return Rights{group, (now.st_mode & 07777) | (S_ISDIR(now.st_mode) ? kFolder : kFile)};
  };
}

Rule keepsakes_of(gid_t group, uid_t kiosk, bool& top) {
  return [group, kiosk, &top](const struct stat& now, const std::string& name) {
    const mode_t mode = now.st_mode & 07777;
    const bool shared = S_ISDIR(now.st_mode) && (top || now.st_uid == kiosk);
    top = false;
    if (shared) return Rights{group, mode | S_IRWXG};
    // The program that phones reach deletes keepsakes, and learns nothing of other visits.
    if (S_ISREG(now.st_mode) && name.starts_with(kStore))
      return Rights{now.st_gid, mode & static_cast<mode_t>(~07)};
    return Rights{now.st_gid, mode};
  };
}

Rule no_longer(gid_t group) {
  return [group](const struct stat& now, const std::string&) {
    const mode_t mode = now.st_mode & 07777;
    if (now.st_gid != group) return Rights{now.st_gid, mode};
    return Rights{0, mode & static_cast<mode_t>(~(S_ISGID | S_IWGRP))};
  };
}

Result<std::size_t> walk_all(const fs::path& folder, const Rule& rule, bool dry) {
  std::size_t changed = 0;
  if (!walk(AT_FDCWD, folder.string(), rule, dry, 0, changed))
    return tl::unexpected(files::disk_problem(folder, "change the rights of", errno));
  return changed;
}

}  // namespace

Result<Change> share(const Step& step, const System& system, bool dry) {
  const fs::path folder = system.at(step.to);
  const auto group = group_of(system, step.from.string());
  if (!group) return tl::unexpected(group.error());
  const std::string told = step.to.string() + ": " + step.why;
  struct stat now {};
  const bool there = ::stat(folder.c_str(), &now) == 0;
  if (!there && dry) return Change{true, told};
  if (!there)
    if (auto made = files::make_folder(folder); !made) return tl::unexpected(made.error());
  bool top = true;
  Rule rule = exhibit_of(*group);
  if (step.from == kKeepsakesGroup) {
    const auto kiosk = user_of(system, kKioskUser);
    if (!kiosk) return tl::unexpected(kiosk.error());
    rule = keepsakes_of(*group, kiosk->user, top);
  }
  const auto changed = walk_all(folder, rule, dry);
  if (!changed) return tl::unexpected(changed.error());
  return Change{!there || *changed > 0, told};
}

Result<Change> unshare(const Step& step, const System& system, bool dry) {
  if (step.from == kKeepsakesGroup)
    return Change{false, step.to.string() + ": stays open to the page for phones"};
  const auto group = group_of(system, step.from.string());
  if (!group) return Change{false, step.to.string() + ": stays, because its group is gone"};
  const auto changed = walk_all(system.at(step.to), no_longer(*group), dry);
  if (!changed) return tl::unexpected(changed.error());
  return Change{*changed > 0, step.to.string() + ": only root may change it"};
}

}  // namespace onggi::setup
