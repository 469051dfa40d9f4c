#include "kiosk/collection/archives/entry_names.h"

#include <algorithm>
#include <vector>

#include "engine/base/plain_text.h"

namespace onggi::archives {

namespace {

// Linux's own limits are 255 and 4096 bytes, and the folder's path comes first.
constexpr std::size_t kLongestPart = 255, kLongestName = 1024, kMostShown = 120;

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

/// The parts between the slashes of `name`; a slash at its end begins none.
std::vector<std::string_view> parts_of(std::string_view name) {
  if (name.ends_with('/')) name.remove_suffix(1);
  std::vector<std::string_view> parts;
  for (;;) {
    const auto slash = name.find('/');
    parts.push_back(name.substr(0, slash));
    if (slash == std::string_view::npos) return parts;
    name.remove_prefix(slash + 1);
  }
}

bool has_drive(std::string_view name) {
  return name.size() > 1 && name[1] == ':' &&
         ((name[0] >= 'a' && name[0] <= 'z') || (name[0] >= 'A' && name[0] <= 'Z'));
}

bool is_no_plain_path(std::string_view name) {
  if (name.find('\\') != std::string_view::npos || has_drive(name)) return true;
  return std::ranges::any_of(parts_of(name), [](std::string_view part) {
    return part.empty() || part == "." || part == "..";
  });
}

bool is_too_long(std::string_view name) {
  return name.size() > kLongestName ||
         std::ranges::any_of(parts_of(name), [](auto part) { return part.size() > kLongestPart; });
}

}  // namespace

std::string EntryNames::where(std::string_view name) const {
  return archive_ + ", " + terminal::plain(name.substr(0, kMostShown));
}

Result<void> EntryNames::check(std::string_view name) const {
  if (terminal::plain(name) != name)
    return problem(where(name), "this name is not UTF-8, or has control characters.",
                   "Rename the file with plain letters, and make the archive again.");
  if (is_no_plain_path(name))
    return problem(where(name), "this name is no plain path inside the archive.",
                   "Make the archive again from one folder, with this computer's own zip program.");
  if (is_too_long(name))
    return problem(where(name), "this name is too long.",
                   "Give the file a shorter name, and make the archive again.");
  if (parts_of(name).size() > depth_)
    return problem(where(name),
                   "this lies deeper than " + std::to_string(depth_) + " folders in each other.",
                   "Put the scan into a flat folder, and make the archive again.");
  return {};
}

Result<void> EntryNames::add(std::string_view name) {
  bool good = true;
  for (auto slash = name.find('/'); slash != std::string_view::npos;
       slash = name.find('/', slash + 1))
    good = good && take(std::string(name.substr(0, slash)), true);
  if (!name.ends_with('/')) good = good && take(std::string(name), false);
  if (good) return {};
  return problem(where(name),
                 "another file has this name, or the same with small and large letters changed.",
                 "Give each file a name of its own, and make the archive again.");
}

bool EntryNames::take(const std::string& name, bool folder) {
  const auto [at, is_new] = taken_.try_emplace(lower(name), Taken{name, folder});
  return is_new || (folder && at->second.folder && at->second.name == name);
}

bool is_litter(std::string_view name) {
  const std::vector<std::string_view> parts = parts_of(name);
  const std::string last = lower(parts.back());
  return parts.front() == "__MACOSX" || last == ".ds_store" || last.starts_with("._") ||
         last == "thumbs.db" || last == "desktop.ini";
}

}  // namespace onggi::archives
