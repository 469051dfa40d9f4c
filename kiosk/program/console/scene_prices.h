#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "kiosk/program/console/onggi_process.h"

namespace onggi::console {

/// What the effects of scenes cost on this machine. `onggi lab prices` measures it once, while
/// nothing else wants the processor, and it is kept in a file for each text of a scene. One thread;
/// never waits for a measurement.
class ScenePrices {
 public:
  /// Files of so many scenes are kept, the newest.
  static constexpr std::size_t kKept = 60;

  /// `onggi`: the program beside this one. `folder`: of its own; made when it is needed.
  ScenePrices(std::filesystem::path onggi, std::filesystem::path folder)
      : measuring_(std::move(onggi)), folder_(std::move(folder)) {}

  /// The prices of the scene `file`, which holds `text`, as `onggi lab prices --json` prints them.
  /// None: not known yet. Where `wanted`, they are then measured next.
  std::optional<std::string> of(const std::filesystem::path& file, const std::string& text,
                                bool wanted);
  /// Forgets what is known of `text`, so that it is measured anew.
  void forget(const std::string& text);
  /// A measurement is under way.
  bool measuring() const { return measuring_.under_way(); }
  /// Why the newest measurement of `text` gave nothing; "": it did not fail.
  std::string trouble(const std::string& text) const;

 private:
  std::filesystem::path kept_in(const std::string& text) const;
  void take();

  OnggiProcess measuring_;
  std::filesystem::path folder_, file_;  // file_: that is measured,
  std::string text_;                     // and what it held when that began
  std::string failed_text_, trouble_;
};

}  // namespace onggi::console
