#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

#include "engine/base/result.h"
#include "kiosk/keepsake/souvenir/pass_file.h"

namespace onggi::souvenir {

/// Gives and takes back the passes to the keepsakes of one folder, each a small file in its
/// subfolder `phone`. The kiosk writes them, and the web process reads them (OpenPasses); they
/// share only the folder. Any thread; each call reads the disk.
class Passes {
 public:
  static constexpr std::size_t kTokenLetters = souvenir::kTokenLetters;

  explicit Passes(std::filesystem::path keepsakes) : keepsakes_(std::move(keepsakes)) {}

  /// A new token, without a pass yet. Problem, exit 1: no randomness.
  static Result<std::string> new_token();
  /// Creates a pass to `visit` for `hours`, with `token` (empty: a new one) and the visitor's
  /// `language`. The visit's folder may come later. Problem: exit 1 if the disk refuses, exit 2 for
  /// an invalid visit name or token.
  Result<Pass> give(const std::string& visit, std::int64_t now, double hours,
                    const std::string& language = {}, std::string token = {}) const;
  /// The same for the visit in the folder `visit`, which must be there and be no link; its passes
  /// lie beside it. Problem, exit 2, else.
  static Result<Pass> give_at_the_desk(const std::filesystem::path& visit, std::int64_t now,
                                       double hours);
  /// Removes a pass whose keepsake was not saved.
  void take_back(const Pass& pass) const;
  /// Removes every pass to `visit`. Reads each pass.
  void take_back_all(const std::string& visit) const;
  /// The visits whose page is promised to somebody: their pass is not over at `now` (PassAges). One
  /// that a clock gave which was ahead by over a year promises nothing. Reads each pass.
  std::set<std::string> promised(std::int64_t now) const;
  /// The folder of phones' notes (fetch_notes()).
  std::filesystem::path fetched() const { return folder() / "fetched"; }
  /// True if OpenPasses::serve() was called less than kSilent seconds ago, so that phones get an
  /// answer.
  bool served(std::int64_t now) const;
  static constexpr std::int64_t kSilent = 150;
  /// The file whose time says so.
  static constexpr const char* kServed = ".served";

 private:
  std::filesystem::path folder() const { return keepsakes_ / kPassFolder; }
  std::filesystem::path keepsakes_;
};

}  // namespace onggi::souvenir
