#pragma once

#include <time.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kiosk/ground/files/read_file.h"

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

/// True while it opens its page: also not if the clock was set back by more than a day.
bool in_time(const Pass& pass, std::int64_t now);

/// 128 bits of the system's randomness, five a letter.
inline constexpr std::size_t kTokenLetters = 26;
/// The letters of a token; none looks like another.
inline constexpr std::string_view kTokenAlphabet = "abcdefghijkmnpqrstuvwxyz23456789";

/// The folder of the passes, beneath that of the keepsakes.
inline constexpr const char* kPassFolder = "phone";

bool is_token(std::string_view text);
/// True for a language code, or ""; anything else is not passed on.
bool is_language_code(std::string_view text);

/// A folder at one moment: another one, or a changed one, is unequal.
struct FolderStamp {
  dev_t device = 0;
  ino_t inode = 0;
  timespec changed{};  ///< Of its list of names.
  bool there = false;  ///< False: no folder, or a link, which is not followed.
  friend bool operator==(const FolderStamp& a, const FolderStamp& b);
};

/// The folder of the passes of `keepsakes` as it is now. Reads one inode.
FolderStamp stamp_of_passes(const std::filesystem::path& keepsakes);

/// The tokens of all passes of `keepsakes`, sorted. Lists the folder and opens no pass; follows no
/// link.
std::vector<std::string> tokens_of(const std::filesystem::path& keepsakes);

/// The pass of `token`; nothing if its file is no pass. A fault if it cannot be read: whoever
/// tidies leaves it then.
tl::expected<std::optional<Pass>, files::ReadFault> read_pass(
    const std::filesystem::path& keepsakes, const std::string& token);

/// The content of the pass's file.
std::string text_of(const Pass& pass);

}  // namespace onggi::souvenir
