#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/base/result.h"

namespace onggi::souvenir {

/// The files of a visit's folder.
inline constexpr const char* kPostcard = "postcard.jpg";
inline constexpr const char* kPrint = "print.jpg";  ///< With the code of the visitor's page.
inline constexpr const char* kPotGlb = "pot.glb";
inline constexpr const char* kReplay = "visit.onggi";
inline constexpr const char* kRollout = "rollout.jpg";  ///< A decorated pot's outside, unrolled.
inline constexpr const char* kSheet = "sheet.jpg";      ///< It drawn, with section and view.
inline constexpr const char* kRelief = "relief.onggi";  ///< What its STL is made of.
inline constexpr const char* kSmall = "small.jpg";      ///< The pot alone, for the gallery,
inline constexpr const char* kShown = "pot.txt";        ///< and its facts for the gallery.

/// The id of the three words that its visitor remembers it by.
inline constexpr const char* kSpoken = "name.txt";
/// Only onggi before 2026-12 wrote these; the STL is made when it is asked for.
inline constexpr const char* kPostcardPng = "postcard.png";
inline constexpr const char* kPotStl = "pot.stl";

/// The pot from all sides; added later than the others, or not at all.
inline constexpr const char* kTurning = "turning.gif";

/// Ending of a folder that is being written or removed.
inline constexpr const char* kPartial = ".partial";

/// A kept visit, and the size of its files.
struct VisitOnDisk {
  std::filesystem::path folder;
  std::uintmax_t bytes = 0;
};

/// The whole visits in `folder` that hold save()'s files only, by name, so by time. Follows no
/// link.
std::vector<VisitOnDisk> visits_in(const std::filesystem::path& folder);

/// True if `name` begins like a visit's: "2026-05-04_141503_" and at least one more character.
bool is_visit_name(std::string_view name);

/// `wanted` as a folder name: letters, digits, '.', '-' and '_' stay, everything else becomes '_';
/// at most 120 bytes. "" if it does not begin like a visit's name.
std::string visit_name(std::string_view wanted);

/// A whole visit in a folder of keepsakes.
struct NamedVisit {
  std::string visit;   ///< Its folder's name.
  std::string spoken;  ///< The id of its name; "" if it has none.
};
/// Every whole visit in `folder`, newest first, also one with files of the museum beside ours.
/// Links are not followed. Blocks on the disk.
std::vector<NamedVisit> named_visits(const std::filesystem::path& folder);

/// Removes a visit: renames it first, so that a power cut leaves a leftover and not half a visit.
/// Problem, exit 1. Blocks.
Result<void> remove_visit(const std::filesystem::path& visit);

/// A folder that is removed with its content unless it is kept.
class PartialFolder {
 public:
  explicit PartialFolder(std::filesystem::path path) : path_(std::move(path)) {}
  ~PartialFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  PartialFolder(const PartialFolder&) = delete;
  PartialFolder& operator=(const PartialFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  void keep() { path_.clear(); }

 private:
  std::filesystem::path path_;
};

}  // namespace onggi::souvenir
