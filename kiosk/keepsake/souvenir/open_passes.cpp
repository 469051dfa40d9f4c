#include "kiosk/keepsake/souvenir/open_passes.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <iomanip>
#include <span>
#include <sstream>
#include <system_error>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/ground/files/shared_folder.h"
#include "kiosk/keepsake/souvenir/fetch_note.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/keepsake/souvenir/printed_pot.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"

namespace fs = std::filesystem;

namespace onggi::souvenir {

namespace {

constexpr std::uint64_t kMostOfAKeepsake = 256u << 20;
// A change so soon after another may leave the folder the same time: the system's clock for files
// goes in steps of 10 ms at most, and some disks keep whole seconds, or every second one.
constexpr std::int64_t kFineStep = 100'000'000, kCoarseStep = 2'000'000'000;  // ns

std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// True if no change after `listed` can leave the folder the time `changed`.
bool is_settled(const timespec& changed, const timespec& listed) {
  const std::int64_t ago = nanoseconds(listed) - nanoseconds(changed);
  const std::int64_t step = changed.tv_nsec == 0 ? kCoarseStep : kFineStep;
  // A time from the future is no trouble: a change would set it to now.
  return ago > step || ago < -step;
}

}  // namespace

OpenPasses::Slot OpenPasses::slot_of(std::string_view token) {
  static_assert(kTokenLetters < sizeof(Slot));
  std::array<char, sizeof(Slot)> letters{};
  std::copy_n(token.begin(), std::min(token.size(), kTokenLetters), letters.begin());
  // No token has a letter there, so one of another length is like none.
  letters.back() = token.size() == kTokenLetters ? '\0' : '!';
  Slot slot;
  std::memcpy(slot.data(), letters.data(), sizeof slot);
  return slot;
}

void OpenPasses::refresh(Work& work) {
  const FolderStamp now = stamp_of_passes(keepsakes_);
  if (settled_ && now == listed_) return;
  timespec clock{};
  ::clock_gettime(CLOCK_REALTIME, &clock);
  std::vector<std::string> tokens = tokens_of(keepsakes_);
  ++work.lists;
  // What is known of a token stays known.
  std::vector<Known> known(tokens.size());
  std::size_t old = 0;
  for (std::size_t n = 0; n < tokens.size(); ++n) {
    while (old < tokens_.size() && tokens_[old] < tokens[n]) ++old;
    if (old < tokens_.size() && tokens_[old] == tokens[n]) known[n] = std::move(known_[old]);
  }
  tokens_ = std::move(tokens);
  known_ = std::move(known);
  slots_.resize(tokens_.size());
  std::transform(tokens_.begin(), tokens_.end(), slots_.begin(), slot_of);
  listed_ = now;
  settled_ = is_settled(now.changed, clock);
}

OpenPasses::Keepsake OpenPasses::keepsake_of(const std::string& visit) const {
  const fs::path path = keepsakes_ / visit;
  std::error_code error, other;
  const auto whole = fs::symlink_status(path, error).type();
  const auto partial = fs::symlink_status(fs::path(path) += kPartial, other).type();
  if (whole == fs::file_type::directory) return Keepsake::whole;
  if (partial == fs::file_type::directory) return Keepsake::partial;
  // The disk could not say.
  if (whole == fs::file_type::none || partial == fs::file_type::none) return Keepsake::unknown;
  return Keepsake::gone;
}

std::optional<Pass> OpenPasses::find(std::string_view token, std::int64_t now, Work* work) {
  Work done;
  refresh(done);
  const Slot asked = slot_of(token);
  // For a wrong token, read some pass, as for an expired one. It is always the same pass for the
  // same token, so that a second request finds it equally warm.
  std::size_t found = tokens_.empty() ? 0 : std::hash<std::string_view>{}(token) % tokens_.size();
  std::uint64_t right = 0;
  for (std::size_t n = 0; n < slots_.size(); ++n) {
    std::uint64_t differ = 0;
    for (std::size_t k = 0; k < asked.size(); ++k) differ |= slots_[n][k] ^ asked[k];
    // All ones where nothing differs: no branch, so that the time says nothing.
    const std::uint64_t same = ((differ | (0 - differ)) >> 63) - 1;
    right |= same;
    found = (found & ~same) | (n & same);
    done.letters += kTokenLetters;
  }
  std::optional<Pass> pass;
  if (!tokens_.empty()) {
    pass = read_pass(keepsakes_, tokens_[found]).value_or(std::nullopt);
    ++done.files;
  }
  const Keepsake keepsake = keepsake_of(pass ? pass->visit : Passes::kServed);
  if (work != nullptr) *work = done;
  const bool good = right != 0 && pass &&
                    (keepsake == Keepsake::whole || keepsake == Keepsake::partial) &&
                    in_time(*pass, now);
  if (!good) return {};
  pass->whole = keepsake == Keepsake::whole;
  return pass;
}

std::optional<KeepsakeFile> OpenPasses::open_file(const Pass& pass, const char* name) const {
  auto opened = files::open_beneath(keepsakes_, pass.visit + '/' + name);
  std::optional<StlOfPot> stl;
  std::optional<Problem> remark;
  // An STL is made of the relief or the model as it is sent. Only old keepsakes have one.
  if (!opened && std::string_view(name) == kPotStl) {
    auto pot = printed_pot(keepsakes_, pass.visit);
    if (!pot) return {};
    opened = std::move(pot->file);
    stl = std::move(pot->stl);
    remark = std::move(pot->remark);
  }
  if (!opened) return {};
  struct stat info {};
  if (::fstat(opened->get(), &info) != 0 || info.st_size < 0) return {};
  KeepsakeFile found{
      std::move(*opened), static_cast<std::uint64_t>(info.st_size), {}, {}, std::move(remark)};
  if (found.size > kMostOfAKeepsake) return {};
  std::ostringstream which, tag;
  if (stl) {
    found.size = stl->size();
    found.stl = std::move(stl);
    which << kPotStl << ' ';
  }
  which << info.st_ino << ' ' << info.st_size << ' ' << info.st_mtim.tv_sec << ' '
        << info.st_mtim.tv_nsec;
  tag << std::hex << std::setw(16) << std::setfill('0') << std::hash<std::string>{}(which.str());
  found.tag = tag.str();
  return found;
}

bool OpenPasses::has_file(const Pass& pass, const char* name) const {
  std::error_code error;
  return fs::symlink_status(keepsakes_ / pass.visit / name, error).type() == fs::file_type::regular;
}

Result<void> OpenPasses::remove_all_of(const Pass& pass, Work* work) {
  const fs::path visit = keepsakes_ / pass.visit;
  std::error_code error;
  // Rename first, so that a power cut leaves a leftover for tidying and not half a visit.
  fs::path going = visit;
  going += kPartial;
  if (fs::is_directory(going, error)) fs::remove_all(going, error);
  fs::rename(visit, going, error);
  if (!error || error == std::errc::no_such_file_or_directory) fs::remove_all(going, error);
  if (error)
    return problem(visit.string(),
                   "A visitor's keepsake could not be removed: " + error.message() + ".",
                   "Remove it, and make the folder writable.", 1);
  // Remove the passes last: until everything is gone the visitor can ask again.
  Work done;
  refresh(done);
  for (std::size_t n = 0; n < tokens_.size(); ++n) {
    if (!known_[n].visit.empty() && known_[n].visit != pass.visit) continue;
    const auto other = read_pass(keepsakes_, tokens_[n]).value_or(std::nullopt);
    ++done.files;
    if (other && other->visit == pass.visit) fs::remove(folder() / tokens_[n], error);
  }
  if (work != nullptr) *work = done;
  return {};
}

void OpenPasses::note_fetched(const Pass& pass, std::int64_t now) const {
  if (pass.counted.empty()) return;
  // If the disk refuses the note, the page is not counted, but the visitor has it.
  static_cast<void>(leave_fetch_note(
      Passes(keepsakes_).fetched(),
      {pass.counted, files::local_time(static_cast<std::time_t>(now), files::kDay)}));
}

void OpenPasses::serve() const {
  const fs::path said = folder() / Passes::kServed;
  if (::utimensat(AT_FDCWD, said.c_str(), nullptr, AT_SYMLINK_NOFOLLOW) == 0) return;
  const std::string text = "onggi-console answers phones\n";
  if (!files::make_folder(folder())) return;
  files::share_as_above(folder());
  static_cast<void>(files::write_durably(said, std::as_bytes(std::span(text))));
}

void OpenPasses::end_serving() const {
  std::error_code error;
  fs::remove(folder() / Passes::kServed, error);
}

bool OpenPasses::forget_some(std::int64_t now, Work* work) {
  Work done;
  if (round_.empty()) {
    refresh(done);
    round_ = tokens_;
    std::vector<std::int64_t> given;
    for (const Known& known : known_)
      if (!known.visit.empty()) given.push_back(known.from);
    ages_ = PassAges(std::move(given));
  }
  for (std::size_t n = 0; n < kAtATurn && !round_.empty(); ++n) {
    const std::string token = std::move(round_.back());
    round_.pop_back();
    const auto pass = read_pass(keepsakes_, token);
    ++done.files;
    if (!pass) continue;
    std::error_code error;
    if (!*pass || ages_.over(**pass, now) || keepsake_of((*pass)->visit) == Keepsake::gone) {
      fs::remove(folder() / token, error);
      continue;
    }
    // For the next round, and for remove_all_of(), which needs to read no other visit's pass.
    const auto at = std::lower_bound(tokens_.begin(), tokens_.end(), token);
    if (at != tokens_.end() && *at == token)
      known_[static_cast<std::size_t>(at - tokens_.begin())] = {(*pass)->visit, (*pass)->from};
  }
  if (work != nullptr) *work = done;
  return !round_.empty();
}

}  // namespace onggi::souvenir
