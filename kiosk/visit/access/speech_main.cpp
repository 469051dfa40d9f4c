// onggi-speech speaks through speech-dispatcher. It is a separate program, because a libspeechd
// call blocks until its server answers. It reads lines from standard input and answers on standard
// output (kiosk/visit/access/voice_link.h). It ends when its input ends.

#include <libspeechd.h>
#include <signal.h>
#include <sys/prctl.h>

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <mutex>
#include <set>
#include <string>

namespace {

std::mutex g_writing;
std::map<std::size_t, std::uint64_t> g_ids;  // speech-dispatcher's message number: our id
std::set<std::size_t> g_over;                // ended before their id was known

void tell(const std::string& line) {
  const std::string whole = line + '\n';
  std::fwrite(whole.data(), 1, whole.size(), stdout);
  std::fflush(stdout);
}

/// On libspeechd's thread: a message ended, completely or not.
void on_end(std::size_t message, std::size_t, SPDNotificationType) {
  const std::lock_guard lock(g_writing);
  const auto ours = g_ids.find(message);
  if (ours == g_ids.end()) {
    g_over.insert(message);
    return;
  }
  tell("ended " + std::to_string(ours->second));
  g_ids.erase(ours);
}

/// ISO 639: the names that voices use for some of the exhibit's language codes.
std::string also(const std::string& language) { return language == "zh" ? "cmn" : language; }

bool speaks(SPDConnection* voice, const std::string& language) {
  SPDVoice** all = spd_list_synthesis_voices(voice);
  if (all == nullptr) return true;  // a synthesiser that lists no voices may still speak it
  const std::string stem = language.substr(0, language.find('-'));
  bool found = false;
  for (SPDVoice** one = all; *one != nullptr && !found; ++one) {
    const std::string its = (*one)->language != nullptr ? (*one)->language : "";
    for (const std::string& wanted : {stem, also(stem)})
      found = found || its == wanted || its.starts_with(wanted + "-");
  }
  free_spd_voices(all);
  return found;
}

void say(SPDConnection* voice, std::map<std::string, bool>& spoken, const std::string& id,
         const std::string& language, const std::string& words) {
  if (spoken.count(language) == 0) spoken[language] = speaks(voice, language);
  if (!spoken[language]) {
    tell("voiceless " + language);
    return;
  }
  spd_cancel(voice);
  spd_set_language(voice, language.c_str());
  // Without the lock: the thread that brings the answer may be in on_end().
  const int message = spd_say(voice, SPD_TEXT, words.c_str());
  const std::lock_guard lock(g_writing);
  tell("taken " + id);
  if (message < 0 || g_over.erase(static_cast<std::size_t>(message)) > 0)
    tell("ended " + id);
  else
    g_ids[static_cast<std::size_t>(message)] = std::strtoull(id.c_str(), nullptr, 10);
}

}  // namespace

int main() {
  // Input ends with the exhibit, but a process that hangs in a call does not notice.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  char* error = nullptr;
  SPDConnection* voice =
      spd_open2("onggi", "visit", nullptr, SPD_MODE_THREADED, nullptr, 1, &error);
  if (voice == nullptr) {
    std::cerr << "onggi-speech: speech-dispatcher does not answer: "
              << (error != nullptr ? error : "no reason given") << '\n';
    return 1;
  }
  voice->callback_end = voice->callback_cancel = on_end;
  spd_set_notification_on(voice, SPD_END);
  spd_set_notification_on(voice, SPD_CANCEL);
  tell("ready");
  std::map<std::string, bool> spoken;
  for (std::string line; std::getline(std::cin, line);) {
    if (line == "hush") {
      spd_cancel(voice);
      const std::lock_guard lock(g_writing);
      tell("taken 0");
    } else if (line.starts_with("say ")) {
      const auto id_end = line.find(' ', 4), language_end = line.find(' ', id_end + 1);
      if (id_end == std::string::npos || language_end == std::string::npos) continue;
      say(voice, spoken, line.substr(4, id_end - 4),
          line.substr(id_end + 1, language_end - id_end - 1), line.substr(language_end + 1));
    }
  }
  spd_cancel(voice);
  spd_close(voice);
  return 0;
}
