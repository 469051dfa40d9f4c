#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace onggi::souvenir {

/// A visitor's temporary access to a keepsake by phone.
struct Pass {
  std::string token;       ///< kTokenLetters letters that cannot be guessed.
  std::string visit;       ///< The folder of the keepsake.
  std::int64_t from = 0;   ///< Valid in [from, until), Unix seconds by this machine's clock:
  std::int64_t until = 0;  ///< not valid any more at `until`.
  std::string language{};  ///< Language code of the visit; "": not known.
  bool whole = true;       ///< Its keepsake is complete; false: being written or removed.
  std::string counted{};   ///< Id under which a fetch is counted: FetchNote::id.
};

/// The passes to the keepsakes of one folder, each a small file in the subfolder `phone`. The kiosk
/// writes them and the web process reads them; they share only the folder. Any thread; each call
/// reads the disk.
class Passes {
 public:
  /// 128 bits of the system's randomness, five a letter; similar letters are not used.
  static constexpr std::size_t kTokenLetters = 26;

  explicit Passes(std::filesystem::path keepsakes) : keepsakes_(std::move(keepsakes)) {}

  /// A new token, without a pass yet. Problem, exit 1: no randomness.
  static Result<std::string> new_token();
  /// Creates a pass to `visit` for `hours`, with `token` (empty: a new one) and the visitor's
  /// `language`. Problem: exit 1 if the disk refuses, exit 2 for an invalid visit name or token.
  Result<Pass> give(const std::string& visit, std::int64_t now, double hours,
                    const std::string& language = {}, std::string token = {}) const;
  /// The work of find(), for tests.
  struct Work {
    std::size_t letters = 0;  ///< Letters compared,
    std::size_t files = 0;    ///< and files read.
    friend bool operator==(const Work&, const Work&) = default;
  };
  /// The pass of this token if it is valid at `now`. Every token causes the same work: all letters
  /// of all passes are compared, and one pass is read, perhaps that of another token. A pass also
  /// ends if the clock was set back by more than a day.
  std::optional<Pass> find(std::string_view token, std::int64_t now, Work* work = nullptr) const;
  /// A file of its keepsake, one of souvenir's; nothing if it is missing.
  std::optional<std::string> file_of(const Pass& pass, const char* name) const;
  /// True if the file exists. It may come later than the others.
  bool has_file(const Pass& pass, const char* name) const;
  /// Removes the whole keepsake and every pass to it. Problem, exit 1, if some of it is left; the
  /// pass is then still valid, so the visitor can try again.
  Result<void> remove_all_of(const Pass& pass) const;
  /// Records in fetched() that a visitor opened the page, once a keepsake, for the visit counter.
  void note_fetched(const Pass& pass, std::int64_t now) const;
  /// The folder of those notes (fetch_notes()).
  std::filesystem::path fetched() const { return folder() / "fetched"; }
  /// Removes a pass whose keepsake was not saved.
  void take_back(const Pass& pass) const;
  /// The web process calls this at least once a minute, and when it ends.
  void serve() const;
  void end_serving() const;
  /// True if serve() was called less than kSilent seconds ago, so that phones get an answer.
  bool served(std::int64_t now) const;
  static constexpr std::int64_t kSilent = 150;
  /// Removes expired passes and those without a keepsake, except for a keepsake that is being
  /// written.
  void forget(std::int64_t now) const;

 private:
  std::filesystem::path folder() const { return keepsakes_ / "phone"; }
  std::optional<Pass> read(const std::string& token) const;
  std::filesystem::path keepsakes_;
};

}  // namespace onggi::souvenir
