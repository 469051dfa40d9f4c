#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/descriptor.h"
#include "kiosk/keepsake/souvenir/pass_ages.h"
#include "kiosk/keepsake/souvenir/pass_file.h"
#include "kiosk/keepsake/souvenir/stl.h"

namespace onggi::souvenir {

/// A file of a keepsake, opened: only the pieces that are read are in memory.
struct KeepsakeFile {
  files::Descriptor file;
  std::uint64_t size = 0;  ///< Bytes when it was opened.
  std::string tag;         ///< The same for the same bytes, another for others; 16 letters.
  /// `file` is the pot's relief or model, and its STL is what was asked for.
  std::optional<StlOfPot> stl;
  std::optional<Problem> remark;  ///< Why the STL is made without the relief, for the staff.
};

/// The passes as the web process knows them (Passes has those who give them). The tokens are kept
/// in memory, and listed anew when the folder has changed. One thread; what the disk says counts.
class OpenPasses {
 public:
  explicit OpenPasses(std::filesystem::path keepsakes) : keepsakes_(std::move(keepsakes)) {}

  /// The work of a call, for tests.
  struct Work {
    std::size_t letters = 0;  ///< Letters compared,
    std::size_t files = 0;    ///< passes read,
    std::size_t lists = 0;    ///< and times the folder was listed.
    friend bool operator==(const Work&, const Work&) = default;
  };
  /// The pass of this token if it is valid at `now`. Every token causes the same work: all letters
  /// of all passes are compared, and one pass is read, perhaps that of another token. The folder is
  /// listed if it changed since the last listing, or so shortly before that its time may be the
  /// same. A pass also ends if the clock was set back by more than a day.
  std::optional<Pass> find(std::string_view token, std::int64_t now, Work* work = nullptr);
  /// A file of its keepsake, one of souvenir's; nothing if it is missing, a link, or larger than
  /// 256 MiB. A folder that is a link is not followed.
  std::optional<KeepsakeFile> open_file(const Pass& pass, const char* name) const;
  /// True if the file exists. It may come later than the others.
  bool has_file(const Pass& pass, const char* name) const;
  /// Removes the whole keepsake and every pass to it. Problem, exit 1, if some of it is left; the
  /// pass is then still valid, so the visitor can try again. Reads the passes that are its own and
  /// those that forget_some() has not looked at yet.
  Result<void> remove_all_of(const Pass& pass, Work* work = nullptr);
  /// Records that a visitor opened the page, once a keepsake, for the visit counter
  /// (Passes::fetched()).
  void note_fetched(const Pass& pass, std::int64_t now) const;
  /// Says that phones are answered (Passes::served()): the web process calls this at least once a
  /// minute. Writes a time, and only the first call a file.
  void serve() const;
  void end_serving() const;
  /// Passes that one call of forget_some() looks at.
  static constexpr std::size_t kAtATurn = 16;
  /// Looks at the next kAtATurn passes, each read once, and removes those that are over (PassAges,
  /// by the dates that the rounds before have read) and those without a keepsake, except for a
  /// keepsake that is being written. A pass that cannot be read stays. True while this round has
  /// passes left; the call after that begins another round.
  bool forget_some(std::int64_t now, Work* work = nullptr);

 private:
  /// A token, padded with zeros, so that all are compared in whole words.
  using Slot = std::array<std::uint64_t, 4>;
  /// What forget_some() has read of a token's pass.
  struct Known {
    std::string visit{};  // "": not looked at yet
    std::int64_t from = 0;
  };
  enum class Keepsake { gone, partial, whole, unknown };

  static Slot slot_of(std::string_view token);
  void refresh(Work& work);
  Keepsake keepsake_of(const std::string& visit) const;
  std::filesystem::path folder() const { return keepsakes_ / kPassFolder; }

  std::filesystem::path keepsakes_;
  std::vector<std::string> tokens_;   // sorted
  std::vector<Slot> slots_;           // of tokens_
  std::vector<Known> known_;          // of tokens_
  std::vector<std::string> round_{};  // tokens that this round of forget_some() has left
  PassAges ages_{};                   // by what was known when it began
  FolderStamp listed_{};              // the folder when it was listed
  bool settled_ = false;              // false: it may have changed without another time
};

}  // namespace onggi::souvenir
