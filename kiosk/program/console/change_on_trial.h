#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "engine/base/result.h"

namespace onggi::console {

/// A change that is tried on the kiosk for some minutes, and then taken back by itself. It stands
/// in a file, so that it ends in time though this program was killed or the machine switched off.
/// One thread; blocks on the disk.
class ChangeOnTrial {
 public:
  static constexpr std::int64_t kLasts = 300;  ///< s

  /// What is tried.
  struct Tried {
    std::string revision;    ///< Of the change, as `onggi undo --if` takes it.
    std::int64_t until = 0;  ///< s since 1970.
    std::string what;        ///< In words.
  };

  /// `file`: of its own, in the program's state folder. Reads it.
  explicit ChangeOnTrial(std::filesystem::path file);

  const std::optional<Tried>& now() const { return now_; }
  bool is_due(std::int64_t now) const { return now_ && now >= now_->until; }
  /// Begins one, or corrects what is known of it. Problem, exit 1: it cannot be kept; then there is
  /// none.
  Result<void> set(Tried tried);
  void end();

 private:
  std::filesystem::path file_;
  std::optional<Tried> now_;
};

}  // namespace onggi::console
