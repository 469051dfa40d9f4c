#include "kiosk/watch/last_good.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <vector>

#include "kiosk/files/descriptor.h"
#include "kiosk/files/durable_file.h"
#include "kiosk/files/read_file.h"

namespace fs = std::filesystem;

namespace onggi::watch {

namespace {

constexpr const char* kName = "last_good";
constexpr const char* kList = "files.txt";  // written last: a copy without it is not whole
constexpr std::size_t kMostOfAList = 16u << 20;

struct Listed {
  fs::path file;  // relative to the site
  std::string line;
};

/// Every file of config/ and content/, with size and time, in order.
Result<std::vector<Listed>> list(const fs::path& site) {
  std::vector<Listed> files;
  std::error_code error;
  for (const char* half : {"config", "content"}) {
    const auto follow = fs::directory_options::follow_directory_symlink;
    for (fs::recursive_directory_iterator it(site / half, follow, error), end; !error && it != end;
         it.increment(error)) {
      std::error_code gone;  // an editor's own files come and go
      if (!it->is_regular_file(gone)) continue;
      const fs::path file = it->path().lexically_relative(site);
      const auto size = fs::file_size(it->path(), gone);
      const auto time = fs::last_write_time(it->path(), gone).time_since_epoch().count();
      if (!gone)
        files.push_back(
            {file, std::to_string(size) + ' ' + std::to_string(time) + ' ' + file.string() + '\n'});
    }
    if (error) return tl::unexpected(files::disk_problem(site / half, "read", error.value()));
  }
  std::sort(files.begin(), files.end(),
            [](const Listed& a, const Listed& b) { return a.file < b.file; });
  return files;
}

std::string text_of(const fs::path& file) {
  const auto bytes = files::read_file(file, kMostOfAList);
  return bytes ? std::string(bytes->begin(), bytes->end()) : std::string();
}

/// Thousands of small files are on the disk sooner by one call than by one each.
Result<void> sync_disk_of(const fs::path& folder) {
  const files::Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.get() < 0 || ::syncfs(opened.get()) != 0)
    return tl::unexpected(files::disk_problem(folder, "write", errno));
  return {};
}

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

}  // namespace

Result<void> keep_last_good(const fs::path& site, const fs::path& keepsakes,
                            const fs::path& folder) {
  const auto listed = list(site);
  if (!listed) return tl::unexpected(listed.error());
  std::string text = fs::absolute(keepsakes).lexically_normal().string() + '\n';
  for (const Listed& file : *listed) text += file.line;
  const fs::path kept = folder / kName;
  if (text == text_of(kept / kList)) return {};

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
  if (auto synced = sync_disk_of(fresh); !synced) return synced;
  if (auto written = files::write_durably(fresh / kList, bytes_of(text)); !written) return written;
  // Between the two steps there is none: then the program's own exhibit stands in.
  fs::remove_all(kept, error);
  return files::rename_durably(fresh, kept);
}

std::optional<LastGood> last_good(const fs::path& folder) {
  const fs::path kept = folder / kName;
  const std::string text = text_of(kept / kList);
  if (text.empty()) return {};
  return LastGood{kept / "config" / "exhibit.toml", text.substr(0, text.find('\n'))};
}

}  // namespace onggi::watch
