#include "kiosk/keepsake/souvenir/fetch_note.h"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <span>
#include <system_error>

#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/ground/files/shared_folder.h"

namespace fs = std::filesystem;

namespace onggi::souvenir {

namespace {

constexpr std::size_t kIdLetters = 26, kDayLetters = 10;

bool is_day(const std::string& text) {
  return text.size() == kDayLetters && files::begins_like(text + ' ', "9999-99-99");
}

}  // namespace

bool is_fetch_id(std::string_view id) {
  return id.size() == kIdLetters && std::all_of(id.begin(), id.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
         });
}

Result<void> leave_fetch_note(const fs::path& folder, const FetchNote& note) {
  if (!is_fetch_id(note.id))
    return problem(note.id, "This is not a valid note id.", "Report this with the log.");
  const fs::path file = folder / note.id, part = folder / ('.' + note.id + ".part");
  std::error_code error;
  // A power cut may have left the name without its day.
  if (const auto size = fs::file_size(file, error); !error && size > 0) return {};
  if (auto made = files::make_folder(folder); !made) return made;
  files::share_as_above(folder);
  files::Descriptor written(::open(
      part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0644));
  if (written.open() && files::write_all(written.get(), std::as_bytes(std::span(note.day))) &&
      written.close() && ::rename(part.c_str(), file.c_str()) == 0)
    return {};
  const int fault = errno;
  fs::remove(part, error);
  return tl::unexpected(files::disk_problem(file, "write", fault));
}

std::vector<FetchNote> fetch_notes(const fs::path& folder, std::size_t most) {
  std::vector<FetchNote> notes;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end && notes.size() < most;
       at.increment(error)) {
    FetchNote note;
    note.id = at->path().filename().string();
    if (!is_fetch_id(note.id)) continue;
    const auto bytes = files::read_beneath(folder, note.id, kDayLetters);
    if (!bytes) continue;
    note.day.assign(bytes->begin(), bytes->end());
    if (is_day(note.day)) notes.push_back(std::move(note));
  }
  return notes;
}

void remove_fetch_note(const fs::path& folder, const FetchNote& note) {
  std::error_code error;
  if (is_fetch_id(note.id)) fs::remove(folder / note.id, error);
}

}  // namespace onggi::souvenir
