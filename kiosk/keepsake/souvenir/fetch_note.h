#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace onggi::souvenir {

/// A note that somebody opened a keepsake on a phone. The web server leaves the note in a folder,
/// and the visit counter collects it. It holds only the day. `id` is random and leads to no
/// keepsake; it prevents counting a note twice.
struct FetchNote {
  std::string id;   ///< 26 letters and digits.
  std::string day;  ///< The local day: "2026-05-04".
  friend bool operator==(const FetchNote&, const FetchNote&) = default;
};

/// True for 26 letters or digits.
bool is_fetch_id(std::string_view id);
/// Writes the note into `folder`, which is created if missing. An existing note with this id stays.
/// Whole or not there; does not wait for the disk, because a page waits for it: a power cut within
/// the next half minute may lose the note, and the next call writes it again. Problem: exit 1 if
/// the disk refuses, exit 2 if the id is invalid. Any thread, two with the same id not at once.
Result<void> leave_fetch_note(const std::filesystem::path& folder, const FetchNote& note);
/// The notes in `folder`, at most `most`; other files are ignored. Blocks; any thread.
std::vector<FetchNote> fetch_notes(const std::filesystem::path& folder, std::size_t most);
/// Removes a counted note. A note that cannot be removed is not counted again.
void remove_fetch_note(const std::filesystem::path& folder, const FetchNote& note);

}  // namespace onggi::souvenir
