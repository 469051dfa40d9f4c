#include "kiosk/keepsake/souvenir/pass_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <memory>
#include <sstream>

#include "kiosk/keepsake/souvenir/visit_folder.h"

namespace fs = std::filesystem;

namespace onggi::souvenir {

namespace {

constexpr std::size_t kMostOfAPass = 1024;
constexpr std::size_t kLongestCode = 16;
constexpr std::int64_t kClockBack = 24 * 3600;  // s

std::string beneath(const std::string& name) { return std::string(kPassFolder) + '/' + name; }

struct CloseFolder {
  void operator()(DIR* folder) const { ::closedir(folder); }
};

}  // namespace

bool in_time(const Pass& pass, std::int64_t now) {
  return now < pass.until && now > pass.from - kClockBack;
}

bool is_token(std::string_view text) {
  return text.size() == kTokenLetters &&
         text.find_first_not_of(kTokenAlphabet) == std::string_view::npos;
}

bool is_language_code(std::string_view text) {
  return text.size() <= kLongestCode &&
         text.find_first_not_of(
             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_") ==
             std::string_view::npos;
}

bool operator==(const FolderStamp& a, const FolderStamp& b) {
  return a.there == b.there && a.device == b.device && a.inode == b.inode &&
         a.changed.tv_sec == b.changed.tv_sec && a.changed.tv_nsec == b.changed.tv_nsec;
}

FolderStamp stamp_of_passes(const fs::path& keepsakes) {
  struct stat found {};
  if (::lstat((keepsakes / kPassFolder).c_str(), &found) != 0 || !S_ISDIR(found.st_mode)) return {};
  return {found.st_dev, found.st_ino, found.st_mtim, true};
}

std::vector<std::string> tokens_of(const fs::path& keepsakes) {
  std::vector<std::string> tokens;
  const int opened =
      ::open((keepsakes / kPassFolder).c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (opened < 0) return tokens;
  const std::unique_ptr<DIR, CloseFolder> folder(::fdopendir(opened));
  if (!folder) return tokens;
  while (const dirent* entry = ::readdir(folder.get()))
    if (is_token(entry->d_name)) tokens.emplace_back(entry->d_name);
  std::sort(tokens.begin(), tokens.end());
  return tokens;
}

tl::expected<std::optional<Pass>, files::ReadFault> read_pass(const fs::path& keepsakes,
                                                              const std::string& token) {
  const auto bytes = files::read_beneath(keepsakes, beneath(token), kMostOfAPass);
  if (!bytes) return tl::unexpected(bytes.error());
  std::istringstream in(std::string(bytes->begin(), bytes->end()));
  Pass pass;
  pass.token = token;
  if (!std::getline(in, pass.visit) || !(in >> pass.from >> pass.until)) return std::nullopt;
  // Files of an older onggi end here.
  std::string rest;
  std::getline(in, rest);
  if (!std::getline(in, pass.language) || !is_language_code(pass.language)) pass.language.clear();
  if (!std::getline(in, pass.counted) || !is_token(pass.counted)) pass.counted.clear();
  if (!is_visit_name(pass.visit) || visit_name(pass.visit) != pass.visit) return std::nullopt;
  return pass;
}

std::string text_of(const Pass& pass) {
  return pass.visit + '\n' + std::to_string(pass.from) + '\n' + std::to_string(pass.until) + '\n' +
         pass.language + '\n' + pass.counted + '\n';
}

}  // namespace onggi::souvenir
