#pragma once

#include <cstdint>
#include <filesystem>

namespace onggi::exhibit {

/// What a curator's TOML file is.
enum class FileKind : std::uint8_t {
  exhibit,
  scene,
  device,
  rubric,
  language,
  vessel,
  drawing,
  decoration,
  way,
  glazes,
  names,
  lesson,
  missions,
  staff_page  ///< What the staff's page says in another language.
};

/// The kind of `file`, by keys that one kind alone has, and by its folder. An exhibit where nothing
/// else fits, also where the file cannot be read.
FileKind kind_of_toml(const std::filesystem::path& file);

}  // namespace onggi::exhibit
