#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace onggi::files {

/// That somebody opened a keepsake on a phone. Whoever answers phones leaves it, and whoever counts
/// visits takes it up: two programs that meet in a folder. It says which day and no more; `id` is
/// random, leads to no keepsake, and is there so that none is counted twice.
struct FetchNote {
  std::string id;   ///< 26 letters and digits.
  std::string day;  ///< Where the kiosk stands: "2026-05-04".
  friend bool operator==(const FetchNote&, const FetchNote&) = default;
};

/// Is `id` one that a note may have?
bool is_fetch_id(std::string_view id);
/// Leaves the note in `folder`, made where it is missing; one of this id that is there stays.
/// Problem (exit 1) where the disk refuses, exit 2 where that is no id. Blocks; any thread.
Result<void> leave_fetch_note(const std::filesystem::path& folder, const FetchNote& note);
/// The notes in `folder`, at most `most`; what is none is passed over. Blocks; any thread.
std::vector<FetchNote> fetch_notes(const std::filesystem::path& folder, std::size_t most);
/// Removes a note that has been counted. What cannot be removed is counted no second time.
void remove_fetch_note(const std::filesystem::path& folder, const FetchNote& note);

}  // namespace onggi::files
