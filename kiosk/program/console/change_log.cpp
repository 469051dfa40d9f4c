#include "kiosk/program/console/change_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>

#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/read_file.h"

namespace onggi::console {

namespace {

constexpr std::size_t kMostOfChanges = 64u << 20;  // some 400,000 changes
constexpr std::string_view kBegins = "{\"at\":";

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::vector<std::string> lines;
  const auto bytes = files::read_file(file, kMostOfChanges);
  if (!bytes) return lines;
  std::istringstream in(std::string(bytes->begin(), bytes->end()));
  // A line that a power cut tore is none.
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(kBegins) && nlohmann::json::accept(line)) lines.push_back(std::move(line));
  return lines;
}

std::int64_t time_of(const std::string& line) {
  std::int64_t at = 0;
  std::from_chars(line.data() + kBegins.size(), line.data() + line.size(), at);
  return at;
}

}  // namespace

Result<void> ChangeLog::add(const Change& c) const {
  using files::Json;
  std::string line =
      Json::object(
          {{"at", c.at}, {"who", c.who}, {"from", c.from}, {"did", c.did}, {"what", c.what}})
          .text(-1) +
      '\n';
  files::Descriptor file(
      ::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0600));
  const off_t end = file.open() ? ::lseek(file.get(), 0, SEEK_END) : -1;
  if (end < 0) return tl::unexpected(files::disk_problem(file_, "write", errno));
  // Behind a line that a power cut tore, this one is whole.
  char last = '\n';
  if (end > 0 && ::pread(file.get(), &last, 1, end - 1) == 1 && last != '\n')
    line.insert(0, 1, '\n');
  if (!files::write_all(file.get(), std::as_bytes(std::span(line)))) {
    const int error = errno;
    static_cast<void>(::ftruncate(file.get(), end) == 0);
    return tl::unexpected(files::disk_problem(file_, "write", error));
  }
  if (!file.close()) return tl::unexpected(files::disk_problem(file_, "write", errno));
  return {};
}

std::vector<std::string> ChangeLog::newest(std::size_t most) const {
  std::vector<std::string> lines = lines_of(file_);
  return {lines.rbegin(),
          lines.rbegin() + static_cast<std::ptrdiff_t>(std::min(most, lines.size()))};
}

Result<void> ChangeLog::forget(std::int64_t now) const {
  std::vector<std::string> lines = lines_of(file_);
  if (std::erase_if(lines, [now](const std::string& line) {
        return now - time_of(line) > kDays * 24 * 3600;
      }) == 0)
    return {};
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return files::write_durably(file_, std::as_bytes(std::span(text)));
}

}  // namespace onggi::console
