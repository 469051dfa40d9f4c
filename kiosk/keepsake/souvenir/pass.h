#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace onggi::souvenir {

/// A visitor's way to a keepsake by phone, for a time.
struct Pass {
  std::string token;       ///< kTokenLetters letters that nobody guesses.
  std::string visit;       ///< The folder of the keepsake.
  std::int64_t from = 0;   ///< s since 1970, by this machine's clock,
  std::int64_t until = 0;  ///< and not at it any more.
  std::string language{};  ///< Code of the visit's; "": not known.
  bool whole = true;       ///< Its keepsake; false: being written, or being removed.
  std::string counted{};   ///< Under what its fetching is counted: files::FetchNote::id.
};

/// The passes to the keepsakes of one folder, a small file each in `phone` below it. They are files
/// so that whoever gives them (the kiosk) and whoever takes them (a process that a network reaches)
/// need not know each other. Any thread; each call reads the disk.
class Passes {
 public:
  /// 128 bits of the system's randomness, five to a letter; none that is mistaken for another.
  static constexpr std::size_t kTokenLetters = 26;

  explicit Passes(std::filesystem::path keepsakes) : keepsakes_(std::move(keepsakes)) {}

  /// What a token is made of, before anybody has a pass of it. Problem, exit 1: no randomness.
  static Result<std::string> new_token();
  /// A new pass to `visit` for `hours`, of `token` (none: a new one), for somebody who speaks
  /// `language`. Problem, exit 1, where the disk refuses; exit 2 where that is no visit's name or
  /// no token.
  Result<Pass> give(const std::string& visit, std::int64_t now, double hours,
                    const std::string& language = {}, std::string token = {}) const;
  /// What find() did, for tests.
  struct Work {
    std::size_t letters = 0;  ///< Compared,
    std::size_t files = 0;    ///< and read.
    friend bool operator==(const Work&, const Work&) = default;
  };
  /// The pass of this token that is good at `now`. The same work is done for every token: all
  /// passes are compared, each letter of each, and one is read, be it that of another token. A
  /// clock that was set back by more than a day ends a pass too.
  std::optional<Pass> find(std::string_view token, std::int64_t now, Work* work = nullptr) const;
  /// A file of its keepsake, one of souvenir's; nothing where it is not there.
  std::optional<std::string> file_of(const Pass& pass, const char* name) const;
  /// It is there. It may come later than the others.
  bool has_file(const Pass& pass, const char* name) const;
  /// Removes the keepsake, all of it, and every pass to it. Problem, exit 1, where some is left:
  /// then the pass is good, and it may be asked for again.
  Result<void> remove_all_of(const Pass& pass) const;
  /// A visitor opened the page: it is left in fetched() for whoever counts, once a keepsake.
  void note_fetched(const Pass& pass, std::int64_t now) const;
  /// The folder of those notes (files::fetch_notes()).
  std::filesystem::path fetched() const { return folder() / "fetched"; }
  /// Takes back a pass that was given for nothing.
  void take_back(const Pass& pass) const;
  /// Whoever answers phones says so here at least once a minute, and that it ends.
  void serve() const;
  void end_serving() const;
  /// It said so less than kSilent seconds ago: phones find somebody.
  bool served(std::int64_t now) const;
  static constexpr std::int64_t kSilent = 150;
  /// Removes the passes that are good no more, and those whose keepsake has gone; not of one that
  /// is just being written.
  void forget(std::int64_t now) const;

 private:
  std::filesystem::path folder() const { return keepsakes_ / "phone"; }
  std::optional<Pass> read(const std::string& token) const;
  std::filesystem::path keepsakes_;
};

}  // namespace onggi::souvenir
