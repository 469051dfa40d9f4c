#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace onggi::souvenir {

/// The files of a visit's folder.
inline constexpr const char* kPostcardPng = "postcard.png";
inline constexpr const char* kPostcardJpeg = "postcard.jpg";
inline constexpr const char* kPotGlb = "pot.glb";
inline constexpr const char* kPotStl = "pot.stl";
inline constexpr const char* kReplay = "visit.onggi";
inline constexpr const char* kSmall = "small.jpg";  ///< The pot alone, for the gallery,
inline constexpr const char* kShown = "pot.txt";    ///< and what is said of it there.

/// The pot from all round; comes after the others, or not at all.
inline constexpr const char* kTurning = "turning.gif";

/// Behind the name of a folder that is being written or removed.
inline constexpr const char* kPartial = ".partial";

/// Does `name` begin as visits do: "2026-05-04_141503_" and at least one character more?
bool is_visit_name(std::string_view name);

/// `wanted` as a folder's name: letters, digits, '.', '-' and '_' stay, all else becomes '_'; 120
/// bytes at most. "" if it does not begin as visits do.
std::string visit_name(std::string_view wanted);

/// A folder that goes away with everything in it unless it is kept.
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
