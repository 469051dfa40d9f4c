#include "kiosk/lab/measure/soak_troubles.h"

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

namespace fs = std::filesystem;

namespace onggi::measure {

namespace {

using Kind = SoakTroubles::Kind;

constexpr rlim_t kFull = 4096;  // bytes: too little for a picture or for the store

const char* words_of(Kind kind) {
  switch (kind) {
    case Kind::none:
      break;
    case Kind::helper_killed:
      return "the helper that writes pictures was killed at work";
    case Kind::helper_hangs:
      return "it hung";
    case Kind::disk_full:
      return "the disk took nothing for a visit";
    case Kind::folder_removed:
      return "the folder of keepsakes was removed";
    case Kind::exhibit_changed:
      return "the exhibit was changed, and opened anew";
    case Kind::exhibit_broken:
      return "the exhibit was broken, and stayed as it was";
    case Kind::exhibit_mended:
      return "and mended";
  }
  return "";
}

Kind kind_of(int n) {
  if (n == 14) return Kind::helper_hangs;
  switch (n % SoakTroubles::kEvery) {
    case 4:
      return Kind::helper_killed;
    case 9:
      return Kind::disk_full;
    case 13:
      return Kind::folder_removed;
    case 16:
      return Kind::exhibit_changed;
    case 19:
      return Kind::exhibit_broken;
    case 21:
      return Kind::exhibit_mended;
    default:
      return Kind::none;
  }
}

void let_files_grow(bool grow) {
  rlimit limit{};
  if (getrlimit(RLIMIT_FSIZE, &limit) != 0) return;
  limit.rlim_cur = grow ? limit.rlim_max : kFull;
  setrlimit(RLIMIT_FSIZE, &limit);
}

std::string read(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

}  // namespace

SoakTroubles::SoakTroubles(fs::path exhibit, fs::path keepsakes)
    : exhibit_(std::move(exhibit)), keepsakes_(std::move(keepsakes)), good_text_(read(exhibit_)) {
  // A full disk gives an error, and so does a limit on the file size.
  std::signal(SIGXFSZ, SIG_IGN);
}

SoakTroubles::~SoakTroubles() { let_files_grow(true); }

void SoakTroubles::write_exhibit(const std::string& text) const {
  std::ofstream(exhibit_, std::ios::trunc) << text;
}

bool SoakTroubles::signal_helper(int which) const {
  // Children of this process, from /proc/PID/stat: "PID (name) state parent ...".
  const long own = static_cast<long>(getpid());
  std::error_code none;
  for (const auto& entry : fs::directory_iterator("/proc", none)) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::string stat = read(entry.path() / "stat");
    const auto end = stat.rfind(')');
    if (end == std::string::npos || stat.find("(onggi-encode") == std::string::npos) continue;
    char state = 0;
    long parent = 0;
    std::istringstream(stat.substr(end + 1)) >> state >> parent;
    if (parent == own) return kill(static_cast<pid_t>(std::atol(name.c_str())), which) == 0;
  }
  return false;
}

void SoakTroubles::before(int n) {
  kind_ = kind_of(n);
  done_ = true;
  switch (kind_) {
    case Kind::folder_removed: {
      std::error_code none;
      fs::remove_all(keepsakes_, none);
      break;
    }
    case Kind::exhibit_changed:
      good_text_ += "# changed before visit " + std::to_string(n) + "\n";
      write_exhibit(good_text_);
      break;
    case Kind::exhibit_broken:
      write_exhibit(good_text_ + "[nonsense\n");
      break;
    case Kind::exhibit_mended:
      write_exhibit(good_text_);
      break;
    case Kind::disk_full:
      let_files_grow(false);
      break;
    default:
      done_ = false;
  }
  if (done_) ++count_[kind_];
}

void SoakTroubles::during(bool saving) {
  if (done_ || !saving) return;
  if (kind_ == Kind::helper_killed || kind_ == Kind::helper_hangs)
    done_ = signal_helper(kind_ == Kind::helper_killed ? SIGKILL : SIGSTOP);
  if (done_) ++count_[kind_];
}

void SoakTroubles::after() {
  if (kind_ == Kind::disk_full) let_files_grow(true);
  kind_ = Kind::none;
}

bool SoakTroubles::may_refuse() const { return kind_ == Kind::disk_full; }

std::vector<std::string> SoakTroubles::told() const {
  std::vector<std::string> lines;
  for (const auto& [kind, times] : count_)
    lines.push_back(std::to_string(times) + " x " + words_of(kind));
  return lines;
}

}  // namespace onggi::measure
