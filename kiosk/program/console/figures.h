#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "engine/base/result.h"
#include "kiosk/keepsake/store/anonymised_statistics.h"

namespace onggi::console {

/// What visitors did, as `onggi stats` counts it, small cells left out. Read anew at most every
/// kEvery seconds, and only if it has changed; a trouble too. One thread; blocks while the store is
/// copied.
class Figures {
 public:
  static constexpr std::int64_t kEvery = 10;

  /// Of the local days `from` .. `to`, "2026-05-01"; "" : open end. Problem, exit 2: a day is none;
  /// or the store's.
  Result<const store::AnonymisedStatistics*> of(const std::filesystem::path& keepsakes,
                                                const std::string& from, const std::string& to,
                                                std::int64_t now);

 private:
  std::string key_;
  std::int64_t read_at_ = 0;
  Result<store::AnonymisedStatistics> told_{};
};

}  // namespace onggi::console
