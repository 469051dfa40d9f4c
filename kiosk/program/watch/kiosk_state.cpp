#include "kiosk/program/watch/kiosk_state.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <type_traits>

#include "engine/base/plain_text.h"
#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/files/json.h"

namespace onggi::watch {

namespace {

constexpr const char* kEnd = "end";
// Longer ones come from files of others.
constexpr std::size_t kMostOfAText = 1000;
constexpr std::size_t kMostDevices = 8;

std::string short_line(const std::string& text) {
  return terminal::plain(text).substr(0, kMostOfAText);
}

/// Calls `visit` with the key and a reference of each value that is a number or a truth.
template <class State, class Visit>
void each_number(State& s, Visit&& visit) {
  auto& h = s.health;
  visit("safe_mode", h.safe_mode);
  visit("dark", h.dark);
  visit("crashes", h.crashes);
  visit("running_s", h.running_s);
  visit("frames", h.frames);
  visit("wakes", h.wakes);
  visit("late", h.late);
  visit("overruns", h.overruns);
  visit("lost_ticks", h.lost_ticks);
  visit("worst_wake_s", h.worst_wake_s);
  visit("kept", h.kept);
  visit("not_kept", h.not_kept);
  visit("promised_bytes", h.promised_bytes);
  visit("quota_bytes", h.quota_bytes);
  visit("disk_writes", h.disk_writes);
  visit("stands_in", s.stands_in);
  visit("said", s.said);
  visit("open", s.open);
  visit("visitor", s.visitor);
  visit("ended", s.ended);
  visit("frames_a_second", s.frames_a_second);
  visit("way_in_until", s.way_in_until);
}

template <class Value>
void read_number(std::string_view text, Value& value) {
  if constexpr (std::is_same_v<Value, bool>)
    value = text == "true";
  else
    std::from_chars(text.data(), text.data() + text.size(), value);
  // Whatever somebody wrote there, it can be counted with: 1e12 s are 30,000 years.
  if constexpr (std::is_floating_point_v<Value>)
    value = value >= 0.0 && value <= 1e12 ? value : 0.0;
  else if constexpr (std::is_same_v<Value, std::int64_t>)
    value = std::clamp<std::int64_t>(value, 0, 1'000'000'000'000);
}

}  // namespace

std::string text_of(const KioskState& state) {
  std::string out;
  const auto line = [&out](const std::string& key, const std::string& value) {
    out += key + ' ' + value + '\n';
  };
  line("version", short_line(state.health.version));
  line("exhibit", short_line(state.exhibit));
  line("vessel", short_line(state.vessel));
  if (!state.way_in.empty()) line("way_in", short_line(state.way_in));
  each_number(state,
              [&](const char* key, const auto& value) { line(key, files::Json(value).text(-1)); });
  for (std::size_t n = 0; n < std::min(state.devices.size(), kMostDevices); ++n)
    line("device", short_line(state.devices[n]));
  if (state.trouble) {
    line("trouble_at", std::to_string(state.trouble->at));
    line("troubles", std::to_string(state.trouble->count));
    line("where", short_line(state.trouble->problem.where));
    line("what", short_line(state.trouble->problem.what));
    line("remedy", short_line(state.trouble->problem.remedy));
  }
  return out + kEnd + '\n';
}

std::optional<KioskState> state_of(std::string_view text) {
  KioskState state;
  const auto trouble = [&state]() -> files::Trouble& {
    return state.trouble ? *state.trouble : state.trouble.emplace();
  };
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    if (line == kEnd) return state;
    const std::size_t space = line.find(' ');
    if (space == std::string_view::npos) continue;
    const std::string_view key = line.substr(0, space), value = line.substr(space + 1);
    if (key == "version") state.health.version = value;
    if (key == "exhibit") state.exhibit = value;
    if (key == "vessel") state.vessel = value;
    if (key == "way_in") state.way_in = value;
    if (key == "device") state.devices.emplace_back(value);
    if (key == "trouble_at") read_number(value, trouble().at);
    if (key == "troubles") read_number(value, trouble().count);
    if (key == "where") trouble().problem.where = value;
    if (key == "what") trouble().problem.what = value;
    if (key == "remedy") trouble().problem.remedy = value;
    each_number(state, [&](const char* name, auto& into) {
      if (key == name) read_number(value, into);
    });
  }
  return std::nullopt;
}

SeenKiosk look_at_kiosk(const std::filesystem::path& keepsakes) {
  SeenKiosk seen;
  const files::Descriptor file(
      ::open((keepsakes / kStateFile).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  if (!file.open()) return seen;
  if (::flock(file.get(), LOCK_SH | LOCK_NB) == 0)
    ::flock(file.get(), LOCK_UN);
  else
    seen.runs = errno == EWOULDBLOCK;
  std::string text(kMostOfAState, '\0');
  // A state that is half written is whole at the next look.
  for (int tries = 0; tries < 3 && !seen.state; ++tries) {
    const ssize_t n = ::pread(file.get(), text.data(), text.size(), 0);
    if (n > 0) seen.state = state_of(std::string_view(text).substr(0, static_cast<std::size_t>(n)));
  }
  // Other programs may write in this folder, and phones reach one of them: only the kiosk, whose
  // folder it is, says who may come in.
  struct stat own {
  }, folder{};
  const bool kiosks = ::fstat(file.get(), &own) == 0 && ::stat(keepsakes.c_str(), &folder) == 0 &&
                      own.st_uid == folder.st_uid;
  if (seen.state && !kiosks) seen.state->way_in.clear();
  return seen;
}

}  // namespace onggi::watch
