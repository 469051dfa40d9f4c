#include "kiosk/keepsake/souvenir/small_pot.h"

#include <sys/stat.h>

#include <algorithm>
#include <sstream>
#include <system_error>

#include "kiosk/ground/files/local_time.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"

namespace onggi::souvenir {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostWords = 256, kMostOfAPicture = 1u << 20;  // bytes
constexpr int kMostStars = 5;

std::string revision_of(const fs::path& picture) {
  struct stat file {};
  if (::lstat(picture.c_str(), &file) != 0 || !S_ISREG(file.st_mode)) return {};
  return std::to_string(file.st_size) + ' ' + std::to_string(file.st_mtim.tv_sec) + '.' +
         std::to_string(file.st_mtim.tv_nsec);
}

}  // namespace

std::string text_of(const SmallPot& pot) {
  return pot.vessel + '\n' + std::to_string(std::clamp(pot.stars, 0, kMostStars)) + '\n';
}

std::vector<KeptPot> pots_of_today(const fs::path& folder, std::time_t now, std::size_t most) {
  const std::string today = files::local_time(now, files::kDay) + '_';
  std::vector<std::string> visits;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with(today) && is_visit_name(name) && visit_name(name) == name &&
        !name.ends_with(kPartial))
      visits.push_back(name);
  }
  std::sort(visits.rbegin(), visits.rend());
  std::vector<KeptPot> pots;
  for (const std::string& visit : visits) {
    if (pots.size() == most) break;
    const auto words = files::read_beneath(folder / visit, kShown, kMostWords);
    KeptPot pot{visit, {}, 0, revision_of(folder / visit / kSmall)};
    if (!words || pot.revision.empty()) continue;
    std::istringstream in(std::string(words->begin(), words->end()));
    if (!std::getline(in, pot.vessel) || !(in >> pot.stars)) continue;
    if (pot.vessel.empty() || pot.stars < 0 || pot.stars > kMostStars) continue;
    pots.push_back(std::move(pot));
  }
  return pots;
}

std::optional<files::Bytes> picture_of(const fs::path& folder, const KeptPot& pot) {
  auto bytes = files::read_beneath(folder / pot.visit, kSmall, kMostOfAPicture);
  if (!bytes) return std::nullopt;
  return std::move(*bytes);
}

}  // namespace onggi::souvenir
