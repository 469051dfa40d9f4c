#include "kiosk/program/setup/step.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/program/setup/accounts.h"
#include "kiosk/program/setup/programs.h"
#include "kiosk/program/setup/rights.h"
#include "kiosk/program/setup/staff_parts.h"

namespace fs = std::filesystem;

namespace onggi::setup {

namespace {

constexpr std::size_t kMostOfAFile = std::size_t{1} << 30;

Result<files::Bytes> bytes_of(const fs::path& file) {
  auto bytes = files::read_file(file, kMostOfAFile);
  if (bytes) return std::move(*bytes);
  return problem(file.string(), "It cannot be read: " + bytes.error().reason + ".",
                 "Install the package again, or run this as root.", 1);
}

Result<void> put_copy(const fs::path& from, const fs::path& to) {
  const auto bytes = bytes_of(from);
  if (!bytes) return tl::unexpected(bytes.error());
  if (auto made = files::make_folder(to.parent_path()); !made) return made;
  return files::write_durably(to, std::as_bytes(std::span(*bytes)));
}

Result<Change> make_folder(const Step& step, const System& system, bool dry) {
  const fs::path folder = system.at(step.to);
  const auto owner = user_of(system, kKioskUser);
  if (!owner) return tl::unexpected(owner.error());
  struct stat now {};
  const bool there = ::stat(folder.c_str(), &now) == 0 && S_ISDIR(now.st_mode);
  const bool theirs = there && now.st_uid == owner->user;
  const std::string told = step.to.string() + ": " + step.why +
                           (there && !theirs ? "; it is given to the user onggi" : "");
  if (theirs || dry) return Change{!theirs, told};
  if (auto made = files::make_folder(folder); !made) return tl::unexpected(made.error());
  if (::chown(folder.c_str(), owner->user, owner->group) != 0)
    return tl::unexpected(files::disk_problem(folder, "give to the user onggi", errno));
  return Change{true, told};
}

/// `from` itself if it is a file, else every regular file below it.
Result<std::vector<fs::path>> files_of(const fs::path& from) {
  std::error_code error;
  if (fs::is_regular_file(from, error)) return std::vector{from};
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator it(from, error), end; !error && it != end;
       it.increment(error))
    if (it->is_regular_file(error)) files.push_back(it->path());
  if (error) return tl::unexpected(files::disk_problem(from, "read", error.value()));
  std::sort(files.begin(), files.end());
  return files;
}

Result<Change> copy_tree(const Step& step, const System& system, bool dry) {
  std::size_t copied = 0, kept = 0;
  const fs::path from = system.at(step.from), to = system.at(step.to);
  const auto files = files_of(from);
  if (!files) return tl::unexpected(files.error());
  for (const fs::path& file : *files) {
    const fs::path target = file == from ? to : to / file.lexically_relative(from);
    std::error_code ignored;
    if (fs::exists(fs::symlink_status(target, ignored))) {
      ++kept;
      continue;
    }
    ++copied;
    if (dry) continue;
    if (auto good = put_copy(file, target); !good) return tl::unexpected(good.error());
  }
  std::string told = step.to.string() + ": " + step.why + "; " + std::to_string(copied) +
                     (copied == 1 ? " file" : " files");
  if (kept > 0) told += ", and " + std::to_string(kept) + " that were there stay as they are";
  return Change{copied > 0, told};
}

bool leads(const fs::path& link, const fs::path& to) {
  std::error_code none;
  return fs::read_symlink(link, none) == to;
}

Result<void> make_link(const fs::path& link, const fs::path& to) {
  if (auto made = files::make_folder(link.parent_path()); !made) return made;
  std::error_code error;
  fs::create_symlink(to, link, error);
  if (error) return tl::unexpected(files::disk_problem(link, "make", error.value()));
  return {};
}

Result<void> remove_link(const fs::path& link) {
  std::error_code error;
  fs::remove(link, error);
  if (error) return tl::unexpected(files::disk_problem(link, "remove", error.value()));
  return {};
}

Result<Change> put_link(const Step& step, const System& system, bool dry) {
  const fs::path link = system.at(step.to);
  std::error_code unknown;
  if (step.needs_folder && !fs::is_directory(link.parent_path(), unknown))
    return Change{false, step.to.string() + ": left out, because there is no " +
                             step.to.parent_path().string()};
  const std::string told = step.to.string() + ": " + step.why;
  if (leads(link, step.from)) return Change{false, told};
  if (fs::exists(fs::symlink_status(link, unknown)))
    return Change{false, step.to.string() + ": left as it is, because it is the machine's own"};
  if (dry) return Change{true, told};
  if (auto made = make_link(link, step.from); !made) return tl::unexpected(made.error());
  return Change{true, told};
}

Result<Change> take_link_away(const Step& step, const System& system, bool dry) {
  const fs::path link = system.at(step.to);
  const bool there = leads(link, step.from);
  if (there && !dry)
    if (auto gone = remove_link(link); !gone) return tl::unexpected(gone.error());
  return Change{there, step.to.string() + ": " + step.why};
}

Result<bool> enabled(const Step& step, const System& system) {
  const auto status = systemctl(system, {"--quiet", "is-enabled", step.to.string()});
  if (!status) return tl::unexpected(status.error());
  return *status == 0;
}

enum class Now { no, yes };  ///< Whether to start or stop the unit at once.

Result<Change> enable(const Step& step, const System& system, bool on, Now now, bool dry) {
  const auto is = enabled(step, system);
  if (!is) return tl::unexpected(is.error());
  const std::string told =
      step.to.string() + (on ? " starts with the machine" : " no longer starts with the machine") +
      (step.why.empty() ? "" : ": " + step.why);
  if (*is == on || dry) return Change{*is != on, told};
  std::vector<std::string> words = {"--quiet", on ? "enable" : "disable", step.to.string()};
  if (now == Now::yes) words.push_back("--now");
  const auto status = systemctl(system, words);
  if (!status) return tl::unexpected(status.error());
  if (*status != 0)
    return problem(
        step.to.string(), "systemctl refused.",
        std::string("Try: systemctl ") + (on ? "enable " : "disable ") + step.to.string(), 1);
  return Change{true, told};
}

Result<Change> remove_ours(const Step& step, const System& system, bool dry) {
  if (!leads(system.at(step.to), step.from))
    return Change{false, step.to.string() + ": stays, because it is no longer as setup made it"};
  if (!dry)
    if (auto gone = remove_link(system.at(step.to)); !gone) return tl::unexpected(gone.error());
  return Change{true, step.to.string() + ": removed"};
}

Result<Change> put_back(const Step& step, const System& system, bool dry) {
  const fs::path link = system.at(step.to);
  std::error_code unknown;
  if (fs::exists(fs::symlink_status(link, unknown)))
    return Change{false, step.to.string() + ": stays, because somebody put one there since"};
  if (!fs::exists(system.at(step.from), unknown))
    return Change{false, step.to.string() + ": stays away, because there is no " +
                             step.from.string() + " any more"};
  if (!dry)
    if (auto made = make_link(link, step.from); !made) return tl::unexpected(made.error());
  return Change{true, step.to.string() + ": put back"};
}

/// If a unit was removed with its package, undoing the rest continues.
Result<Change> take_unit_back(const Step& step, const System& system, bool on, bool dry) {
  const auto change = enable(step, system, on, system.runs() ? Now::yes : Now::no, dry);
  if (change || !on) return change;
  return Change{false, step.to.string() + ": stays as it is, because systemctl cannot enable it"};
}

}  // namespace

bool System::runs() const {
  std::error_code ignored;
  return root == "/" && fs::is_directory("/run/systemd/system", ignored);
}

Result<Change> apply(const Step& step, const System& system, bool dry) {
  switch (step.kind) {
    case Step::Kind::folder:
      return make_folder(step, system, dry);
    case Step::Kind::tree:
      return copy_tree(step, system, dry);
    case Step::Kind::link:
      return put_link(step, system, dry);
    case Step::Kind::unlink:
      return take_link_away(step, system, dry);
    case Step::Kind::enable:
      return enable(step, system, true, Now::no, dry);
    case Step::Kind::disable:
      return enable(step, system, false, Now::no, dry);
    case Step::Kind::share:
      return share(step, system, dry);
    case Step::Kind::file:
      return put_file(step, system, dry);
    case Step::Kind::mask:
      return mask(step, system, dry);
    case Step::Kind::package:
      return install(step, system, dry);
    case Step::Kind::certificate:
      return make_certificate(step, system, dry);
  }
  return Change{};
}

Result<Change> take_back(const Step& step, const System& system, bool dry) {
  switch (step.kind) {
    case Step::Kind::folder:
    case Step::Kind::tree:
      return Change{false, step.to.string() + ": stays, because it is the museum's own"};
    case Step::Kind::link:
      return remove_ours(step, system, dry);
    case Step::Kind::unlink:
      return put_back(step, system, dry);
    case Step::Kind::enable:
      return take_unit_back(step, system, false, dry);
    case Step::Kind::disable:
      return take_unit_back(step, system, true, dry);
    case Step::Kind::share:
      return unshare(step, system, dry);
    case Step::Kind::file:
    case Step::Kind::certificate:
      return remove_made(step, system, dry);
    case Step::Kind::mask:
      return unmask(step, system, dry);
    case Step::Kind::package:
      return Change{false, step.from.string() + ": stays installed. To remove it: sudo apt purge " +
                               step.from.string()};
  }
  return Change{};
}

}  // namespace onggi::setup
