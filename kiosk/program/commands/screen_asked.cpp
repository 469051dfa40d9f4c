#include "kiosk/program/commands/screen_asked.h"

#include <poll.h>
#include <sched.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <span>
#include <string>
#include <thread>
#include <utility>

#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/files/json.h"

namespace onggi::commands {

namespace {

using files::Json;

constexpr std::size_t kMostWords = 400'000;  // bytes: a label in twelve languages, as words

/// Up to the empty word; nothing where they do not end.
std::vector<std::string> asked_words() {
  std::vector<std::string> words(1);
  std::size_t bytes = 0;
  for (char c = 0; bytes < kMostWords; ++bytes) {
    const ssize_t n = ::read(STDIN_FILENO, &c, 1);
    if (n < 0 && errno == EINTR) continue;
    if (n != 1) return {};
    if (c != '\0') {
      words.back() += c;
      continue;
    }
    if (words.back().empty()) {
      words.pop_back();
      return words;
    }
    words.emplace_back();
  }
  return {};
}

}  // namespace

Result<int> become_asked() {
  std::vector<std::string> words = asked_words();
  if (words.empty())
    return problem("onggi screen --asked", "Its standard input names no screen.",
                   "It is for the staff's page: write onggi screen attract.");
  words.insert(words.begin(), {"onggi", "screen", "--page"});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execv("/proc/self/exe", arguments.data());
  return problem("/proc/self/exe", std::string("It cannot be started: ") + std::strerror(errno),
                 "Restart the machine.", 1);
}

void be_idle_until_left() {
  const sched_param none{};
  ::sched_setscheduler(0, SCHED_IDLE, &none);
  std::thread([] {
    pollfd left{STDIN_FILENO, 0, 0};  // POLLHUP needs no asking
    while (::poll(&left, 1, -1) < 0 && errno == EINTR) {
    }
    if ((left.revents & (POLLHUP | POLLERR)) != 0) ::_exit(1);
  }).detach();
}

Result<int> answer_page(Result<std::vector<std::vector<std::byte>>> files,
                        const std::vector<view::Image>& pictures) {
  Json head = Json::object({{"done", files.has_value()}});
  if (files) {
    Json list = Json::list();
    for (std::size_t n = 0; n < files->size(); ++n)
      list.push_back(Json::object({{"width", pictures[n].width},
                                   {"height", pictures[n].height},
                                   {"bytes", (*files)[n].size()}}));
    head["pictures"] = list;
  } else {
    head["where"] = files.error().where;
    head["what"] = files.error().what;
    head["remedy"] = files.error().remedy;
  }
  bool good = true;
  const std::string line = head.text(-1) + '\n';
  good = files::write_all(STDOUT_FILENO, std::as_bytes(std::span(line)));
  if (files)
    for (const auto& bytes : *files) good = good && files::write_all(STDOUT_FILENO, bytes);
  return good ? 0 : 1;
}

}  // namespace onggi::commands
