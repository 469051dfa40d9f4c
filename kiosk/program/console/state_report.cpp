#include "kiosk/program/console/state_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "kiosk/ground/files/local_time.h"

namespace onggi::console {

namespace {

// A kiosk posts its state at least every 10 s.
constexpr std::int64_t kSilent = 30;
constexpr double kSmooth = 25.0;  // pictures a second
// Of ticks: a hand feels a hitch, and a visitor may see one.
constexpr double kMostLost = 1e-4;
constexpr std::uint64_t kLow = 1'000'000'000, kFull = 100'000'000;  // bytes
constexpr int kLongAgo = 24 * 3600;

Sentence when(std::int64_t at, std::int64_t now) {
  const auto time = static_cast<std::time_t>(at);
  const std::string day = files::local_time(time, files::kDay);
  const Sentence clock{files::local_time(time, "%H:%M")};
  if (day == files::local_time(static_cast<std::time_t>(now), files::kDay))
    return {"today at {time}", {{"time", clock}}};
  return {"on {day} at {time}", {{"day", {day}}, {"time", clock}}};
}

std::string gigabytes(std::uint64_t bytes) {
  std::array<char, 32> text{};
  if (bytes >= kLow)
    std::snprintf(text.data(), text.size(), "%.1f GB", 1e-9 * static_cast<double>(bytes));
  else
    std::snprintf(text.data(), text.size(), "%.0f MB", 1e-6 * static_cast<double>(bytes));
  return text.data();
}

/// "3 days", "2 hours", "5 minutes"
Sentence lasted(double seconds) {
  const auto whole = static_cast<std::uint64_t>(std::max(seconds, 0.0));
  if (whole >= 2 * 86400) return counting(whole / 86400, "one day", "{count} days");
  if (whole >= 2 * 3600) return counting(whole / 3600, "one hour", "{count} hours");
  return counting(std::max<std::uint64_t>(whole / 60, 1), "one minute", "{count} minutes");
}

Line silent_kiosk(const Known& k) {
  Line line{"kiosk",
            "Kiosk",
            Mood::wrong,
            {},
            {"Start it: sudo systemctl start onggi. On a machine without that service: {command}",
             {{"command", {"onggi run --config " + k.exhibit}}}}};
  if (!k.kiosk.state) {
    line.says = {{"The kiosk does not run, and has left no word here."}};
    return line;
  }
  const watch::KioskState& s = *k.kiosk.state;
  if (s.ended) {
    line.mood = Mood::look;
    line.says = {{"The kiosk is switched off."},
                 {"It was closed {when}.", {{"when", when(s.said, k.now)}}}};
    return line;
  }
  line.says = {{"The kiosk stopped without being closed: a crash, or no power."},
               {"It was last seen {when}.", {{"when", when(s.said, k.now)}}}};
  return line;
}

Sentence doing(const Known& k, const watch::KioskState& s) {
  if (s.health.dark) return {"It is closed for now: outside the opening hours the screen is dark."};
  if (!s.open) return {"It is beginning, and still reads the vessels."};
  const std::vector<NamedWords> wheel{{"vessel", {k.vessel}}};
  if (k.vessel.empty())
    return {s.visitor ? "Somebody is playing." : "It is open and waits for a visitor."};
  return {s.visitor ? "Somebody is playing, with the {vessel} on the wheel."
                    : "It is open and waits for a visitor, with the {vessel} on the wheel.",
          wheel};
}

Line running_kiosk(const Known& k) {
  const watch::KioskState& s = *k.kiosk.state;
  Line line{"kiosk", "Kiosk", Mood::good, {doing(k, s)}, {}};
  line.says.push_back({"Open since {when}, for {time}. Onggi {version}.",
                       {{"when", when(s.said - std::llround(s.health.running_s), k.now)},
                        {"time", lasted(s.health.running_s)},
                        {"version", {s.health.version}}}});
  const std::vector<NamedWords> last_word{{"when", when(s.said, k.now)}};
  if (s.said - k.now > kSilent) {
    line.mood = Mood::look;
    line.says = {
        {"The kiosk runs, but its last word is from {when}: the machine's clock was set back.",
         last_word}};
    line.remedy = {"Set the clock right. Then: sudo systemctl restart onggi."};
  } else if (k.now - s.said > kSilent) {
    line.mood = Mood::wrong;
    line.says = {{"The kiosk runs, but has said nothing since {when}. Its picture may stand still.",
                  last_word}};
    line.remedy = {"Look at its screen. If nothing moves: sudo systemctl restart onggi."};
  } else if (s.stands_in) {
    line.mood = Mood::wrong;
    line.says.push_back(
        {"It shows another exhibit than yours, because yours is broken or crashed."});
    line.remedy = {"Put right what is named under Files. Then: sudo systemctl restart onggi."};
  } else if (s.exhibit != k.exhibit) {
    line.mood = Mood::look;
    line.says.push_back({"It shows the exhibit {its}, and this page is about {this}.",
                         {{"its", {s.exhibit}}, {"this", {k.exhibit}}}});
    line.remedy = {"Start this page with the other folder, if that is the museum's."};
  }
  return line;
}

Line picture(const watch::KioskState& s) {
  const auto rate = static_cast<std::uint64_t>(std::lround(s.frames_a_second));
  Line line{"picture",
            "Picture",
            Mood::good,
            {counting(rate, "One picture a second.", "{count} pictures a second.")},
            {}};
  // In the dark, and while it begins, few are drawn.
  if (s.open && !s.health.dark && static_cast<double>(rate) < kSmooth) {
    line.mood = Mood::look;
    line.says.push_back({"It looks smooth from 25."});
    line.remedy = {"End other programs on this machine, or choose a smaller window or scene."};
  }
  return line;
}

Line wheel(const watch::Health& h) {
  Line line{"wheel", "Wheel", Mood::good, {}, {}};
  if (h.wakes == 0) {
    line.says = {{"The wheel has not turned yet."}};
    return line;
  }
  line.says = {
      {"{late} of {all} ticks were late, and {lost} were lost.",
       {{"late", number(h.late)}, {"all", number(h.wakes)}, {"lost", number(h.lost_ticks)}}},
      {"A thousand make a second."}};
  if (static_cast<double>(h.lost_ticks) > kMostLost * static_cast<double>(h.wakes)) {
    line.mood = Mood::look;
    line.remedy = {"End other programs on this machine, or choose a lighter scene: onggi tune."};
  }
  return line;
}

Line keepsakes(const watch::Health& h) {
  Line line{"keepsakes",
            "Keepsakes",
            Mood::good,
            {counting(h.kept, "One keepsake was kept since the kiosk was opened.",
                      "{count} keepsakes were kept since the kiosk was opened.")},
            {}};
  if (h.not_kept > 0) {
    line.mood = Mood::wrong;
    line.says.push_back(
        counting(h.not_kept, "One could not be saved.", "{count} could not be saved."));
    line.remedy = {"See Disk and Last trouble below."};
  }
  return line;
}

Line disk(const Known& k) {
  Line line{"disk", "Disk", Mood::good, {}, {}};
  if (!k.free_bytes) {
    line.mood = Mood::wrong;
    line.says = {{"The folder of the keepsakes cannot be read."}};
    line.remedy = {"Let the user of this page read it; onggi check says which folder it is."};
    return line;
  }
  line.says = {{"{size} are free for keepsakes.", {{"size", {gigabytes(*k.free_bytes)}}}}};
  if (*k.free_bytes < kLow) {
    line.mood = *k.free_bytes < kFull ? Mood::wrong : Mood::look;
    line.remedy = {"Remove what this machine does not need, or lower quota_mb in [keepsake]."};
  }
  return line;
}

Line devices(const watch::KioskState& s) {
  std::string names;
  for (const std::string& name : s.devices) names += (names.empty() ? "" : ", ") + name;
  const Sentence none{"None is plugged in: visitors use touch, mouse or keys."};
  return {
      "devices", "Hand devices", Mood::good, {names.empty() ? none : Sentence{names + '.'}}, {}};
}

Line phones(bool answered) {
  if (answered)
    return {"phones", "Phones", Mood::good, {{"Visitors' phones get their pages."}}, {}};
  return {"phones",
          "Phones",
          Mood::wrong,
          {{"Visitors' phones get no answer: the program for phones does not run."}},
          {"Start it: sudo systemctl start onggi-phone."}};
}

Line trouble(const files::Trouble& t, std::int64_t now) {
  Line line{"trouble", "Last trouble", Mood::look, {}, quoted(t.problem.remedy)};
  line.says = {{"Logged {when}:", {{"when", when(t.at, now)}}},
               quoted(t.problem.where + ": " + t.problem.what)};
  if (t.count > 1)
    line.says.push_back({"It was the last of {number}.", {{"number", number(t.count)}}});
  // Nothing has gone wrong since.
  if (now - t.at > kLongAgo) line.mood = Mood::good;
  return line;
}

Line files_line(std::size_t problems) {
  if (problems == 0)
    return {"files", "Files", Mood::good, {{"onggi check finds nothing wrong."}}, {}};
  return {"files",
          "Files",
          Mood::wrong,
          {counting(problems, "onggi check finds one problem in the exhibit's files.",
                    "onggi check finds {count} problems in the exhibit's files.")},
          {"See Files: each is there with its line and what to do."}};
}

const char* name_of(Mood mood) {
  constexpr std::array<const char*, 3> kNames{"good", "look", "wrong"};
  return kNames[static_cast<std::size_t>(mood)];
}

}  // namespace

std::vector<Line> report_of(const Known& k) {
  std::vector<Line> lines;
  const bool runs = k.kiosk.runs && k.kiosk.state && !k.kiosk.state->ended;
  lines.push_back(runs ? running_kiosk(k) : silent_kiosk(k));
  if (runs) {
    const watch::KioskState& s = *k.kiosk.state;
    lines.push_back(picture(s));
    lines.push_back(wheel(s.health));
    lines.push_back(keepsakes(s.health));
  }
  lines.push_back(disk(k));
  if (runs) lines.push_back(devices(*k.kiosk.state));
  if (k.phones_answered) lines.push_back(phones(*k.phones_answered));
  if (k.file_problems) lines.push_back(files_line(*k.file_problems));
  if (k.kiosk.state && k.kiosk.state->trouble)
    lines.push_back(trouble(*k.kiosk.state->trouble, k.now));
  return lines;
}

files::Json json_of(const std::vector<Line>& lines) {
  files::Json all = files::Json::list();
  Mood worst = Mood::good;
  for (const Line& line : lines) {
    worst = std::max(worst, line.mood);
    files::Json says = files::Json::list();
    for (const Sentence& sentence : line.says) says.push_back(json_of(sentence));
    all.push_back(files::Json::object(
        {{"id", line.id},
         {"name", line.name},
         {"mood", name_of(line.mood)},
         {"says", says},
         {"remedy", line.remedy.english.empty() ? files::Json() : json_of(line.remedy)}}));
  }
  return files::Json::object({{"mood", name_of(worst)}, {"lines", all}});
}

}  // namespace onggi::console
