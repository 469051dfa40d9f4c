#include "kiosk/program/watch/last_good.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <vector>

#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/file_stamps.h"
#include "kiosk/ground/files/read_file.h"

namespace fs = std::filesystem;

namespace onggi::watch {

namespace {

constexpr const char* kName = "last_good";
constexpr const char* kList = "files.txt";  // written last: a copy without it is incomplete
constexpr const char* kKeepsakes = "keepsakes.txt";
constexpr std::size_t kMostOfAList = 16u << 20;
constexpr std::size_t kMostFiles = 50'000;  // of an exhibit

struct Listed {
  fs::path file;  // relative to the site
  std::string line;
};

/// Sorted.
Result<std::vector<Listed>> list(const fs::path& site) {
  std::vector<Listed> files;
  std::error_code error;
  for (const char* half : {"config", "content"}) {
    const auto follow = fs::directory_options::follow_directory_symlink;
    std::vector<struct stat> above(1);  // the folders that hold this one: a link may lead back
    if (::stat((site / half).c_str(), &above.front()) != 0) above.front() = {};
    for (fs::recursive_directory_iterator it(site / half, follow, error), end; !error && it != end;
         it.increment(error)) {
      if (struct stat info{}; ::stat(it->path().c_str(), &info) == 0 && S_ISDIR(info.st_mode)) {
        above.resize(static_cast<std::size_t>(it.depth()) + 1);
        if (std::ranges::any_of(above, [&info](const struct stat& one) {
              return one.st_dev == info.st_dev && one.st_ino == info.st_ino;
            }))
          it.disable_recursion_pending();
        above.push_back(info);
        continue;
      }
      if (files.size() > kMostFiles)
        return problem((site / half).string(),
                       "There are more than " + std::to_string(kMostFiles) + " files here.",
                       "Take away links that lead out of the exhibit.", 1);
      if (const auto stamp = files::stamp_of(it->path())) {
        const fs::path file = it->path().lexically_relative(site);
        files.push_back({file, file.string() + ' ' + *stamp + '\n'});
      }
    }
    if (error) return tl::unexpected(files::disk_problem(site / half, "read", error.value()));
  }
  std::sort(files.begin(), files.end(),
            [](const Listed& a, const Listed& b) { return a.file < b.file; });
  return files;
}

std::string lines_of(const std::vector<Listed>& files) {
  std::string text;
  for (const Listed& file : files) text += file.line;
  return text;
}

std::string text_of(const fs::path& file) {
  const auto bytes = files::read_file(file, kMostOfAList);
  return bytes ? std::string(bytes->begin(), bytes->end()) : std::string();
}

/// One sync for thousands of small files is faster than one for each.
Result<void> sync_disk_of(const fs::path& folder) {
  const files::Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.get() < 0 || ::syncfs(opened.get()) != 0)
    return tl::unexpected(files::disk_problem(folder, "write", errno));
  return {};
}

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

std::string absolute_text(const fs::path& path) {
  return fs::absolute(path).lexically_normal().string() + '\n';
}

}  // namespace

Result<std::string> files_of(const fs::path& site) {
  const auto listed = list(site);
  if (!listed) return tl::unexpected(listed.error());
  return lines_of(*listed);
}

Result<bool> keep_last_good(const fs::path& site, const std::string& files,
                            const fs::path& keepsakes, const fs::path& folder) {
  const auto listed = list(site);
  if (!listed) return tl::unexpected(listed.error());
  if (lines_of(*listed) != files) return false;
  const std::string text = absolute_text(keepsakes) + files;
  const fs::path kept = folder / kName;
  if (text == text_of(kept / kList)) return true;

  const fs::path fresh = folder / (std::string(kName) + ".new");
  std::error_code error;
  fs::remove_all(fresh, error);
  for (const Listed& file : *listed) {
    const fs::path to = fresh / file.file;
    fs::create_directories(to.parent_path(), error);
    if (!error) fs::copy_file(site / file.file, to, error);
    if (error) {
      const Problem reason = files::disk_problem(to, "copy", error.value());
      fs::remove_all(fresh, error);
      return tl::unexpected(reason);
    }
  }
  // If files changed during the copy, it is not what visitors saw.
  if (const auto now = files_of(site); !now || *now != files) {
    fs::remove_all(fresh, error);
    return false;
  }
  if (auto synced = sync_disk_of(fresh); !synced) return tl::unexpected(synced.error());
  if (auto written = files::write_durably(fresh / kList, bytes_of(text)); !written)
    return tl::unexpected(written.error());
  // Between the two steps there is no copy; the program's own exhibit would then be used.
  fs::remove_all(kept, error);
  if (auto moved = files::rename_durably(fresh, kept); !moved) return tl::unexpected(moved.error());
  return true;
}

std::optional<LastGood> last_good(const fs::path& folder) {
  const fs::path kept = folder / kName;
  const std::string text = text_of(kept / kList);
  if (text.empty()) return {};
  return LastGood{kept / "config" / "exhibit.toml", text.substr(0, text.find('\n'))};
}

Result<void> remember_keepsakes(const fs::path& keepsakes, const fs::path& folder) {
  const std::string text = absolute_text(keepsakes);
  if (text == text_of(folder / kKeepsakes)) return {};
  return files::write_durably(folder / kKeepsakes, bytes_of(text));
}

std::optional<fs::path> remembered_keepsakes(const fs::path& folder) {
  const std::string text = text_of(folder / kKeepsakes);
  if (text.empty()) return {};
  return text.substr(0, text.find('\n'));
}

}  // namespace onggi::watch
