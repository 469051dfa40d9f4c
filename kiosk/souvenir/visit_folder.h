#pragma once

#include <string>
#include <string_view>

namespace onggi::souvenir {

/// The files of a visit's folder.
inline constexpr const char* kPostcardPng = "postcard.png";
inline constexpr const char* kPostcardJpeg = "postcard.jpg";
inline constexpr const char* kPotGlb = "pot.glb";
inline constexpr const char* kPotStl = "pot.stl";
inline constexpr const char* kReplay = "visit.onggi";
inline constexpr const char* kSmall = "small.jpg";  ///< The pot alone, for the gallery,
inline constexpr const char* kShown = "pot.txt";    ///< and what is said of it there.

/// Behind the name of a folder that is being written or removed.
inline constexpr const char* kPartial = ".partial";

/// Does `name` begin as visits do: "2026-05-04_141503_" and at least one character more?
bool is_visit_name(std::string_view name);

/// `wanted` as a folder's name: letters, digits, '.', '-' and '_' stay, all else becomes '_'; 120
/// bytes at most. "" if it does not begin as visits do.
std::string visit_name(std::string_view wanted);

}  // namespace onggi::souvenir
