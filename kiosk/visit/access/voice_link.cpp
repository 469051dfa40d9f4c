#include "kiosk/visit/access/voice_link.h"

#include <errno.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace onggi::access {

namespace {

constexpr std::size_t kMostHeard = 4096;  // longest line from a voice, bytes

std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  return text;
}

}  // namespace

VoiceLink::VoiceLink(std::string program, std::vector<std::string> arguments)
    : program_(std::move(program)), arguments_(std::move(arguments)) {}

void VoiceLink::begin(double now) {
  if (!std::exchange(wanted_, true)) failures_ = 0;
  if (!child_ && (failures_ == 0 || failures_ >= kMost)) {
    failures_ = 0;
    start(now);
  }
}

void VoiceLink::start(double now) {
  to_ = files::Channel();
  from_ = files::Channel();
  heard_.clear();
  ready_ = false;
  if (!to_.open_for_writing() || !from_.open_for_reading())
    return fail(now, "no pipe could be made for it");
  auto child =
      files::ChildProcess::start(program_, arguments_, {to_.theirs.get(), from_.theirs.get(), -1});
  if (!child) return fail(now, program_ + " could not be started");
  child_.emplace(std::move(*child));
  to_.theirs.close();
  from_.theirs.close();
  asked_at_ = now;
}

void VoiceLink::fail(double now, const std::string& why) {
  child_.reset();  // kills it and waits for it
  to_ = files::Channel();
  from_ = files::Channel();
  ready_ = false;
  asked_at_ = -1;
  ++failures_;
  const bool last = failures_ >= kMost;
  if (failures_ == 1 || last)
    remarks_.push_back("The voice failed: " + why +
                       (last ? ". It stays off until a visitor asks for a voice again."
                             : ". It is started again."));
  again_at_ = last ? -1 : now + std::min(60.0, static_cast<double>(1 << (failures_ - 1)));
}

bool VoiceLink::send(const std::string& line, double now) {
  if (!child_) return false;
  // Write all or nothing: a full pipe means that the voice has hung.
  const ssize_t sent =
      ::send(to_.ours.get(), line.data(), line.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent != static_cast<ssize_t>(line.size())) {
    fail(now, "it does not read its input");
    return false;
  }
  if (asked_at_ < 0) asked_at_ = now;
  return true;
}

void VoiceLink::say(const Utterance& utterance, double now) {
  if (!wanted_ || voiceless_.count(utterance.language) > 0) {
    if (!utterance.text.empty()) ended_.push_back(utterance.id);
    return;
  }
  if (!ready_) {
    waits_ = utterance;
    return;
  }
  if (utterance.text.empty())
    send("hush\n", now);
  else
    send("say " + std::to_string(utterance.id) + ' ' + utterance.language + ' ' +
             one_line(utterance.text) + '\n',
         now);
}

void VoiceLink::take(const std::string& line, double now) {
  const auto rest = [&](std::size_t from) { return line.substr(std::min(from, line.size())); };
  if (line == "ready") {
    ready_ = true;
    asked_at_ = -1;
    if (auto first = std::exchange(waits_, std::nullopt)) say(*first, now);
  } else if (line.starts_with("taken ")) {
    asked_at_ = -1;
    failures_ = 0;
  } else if (line.starts_with("ended ")) {
    ended_.push_back(std::strtoull(rest(6).c_str(), nullptr, 10));
  } else if (line.starts_with("voiceless ")) {
    asked_at_ = -1;
    const std::string language = rest(10);
    if (voiceless_.insert(language).second)
      remarks_.push_back(
          "No voice on this machine speaks \"" + language +
          "\", so this language is silent. Install espeak-ng, which speaks most languages.");
  }
}

void VoiceLink::look(double now) {
  if (!child_) {
    if (wanted_ && again_at_ >= 0 && now >= again_at_) {
      again_at_ = -1;
      start(now);
    }
    return;
  }
  std::array<char, 1024> some{};
  for (;;) {
    const ssize_t got = ::read(from_.ours.get(), some.data(), some.size());
    if (got == 0) return fail(now, "it ended");
    if (got < 0) {
      if (errno == EINTR) continue;
      break;
    }
    heard_.append(some.data(), static_cast<std::size_t>(got));
    for (std::size_t end; (end = heard_.find('\n')) != std::string::npos;) {
      const std::string line = heard_.substr(0, end);
      heard_.erase(0, end + 1);
      take(line, now);
      if (!child_) return;
    }
    if (heard_.size() > kMostHeard) return fail(now, "its answer cannot be read");
  }
  if (asked_at_ >= 0 && now - asked_at_ > (ready_ ? kAnswer : kReady))
    fail(now, "it did not answer");
}

std::vector<std::uint64_t> VoiceLink::ended() { return std::exchange(ended_, {}); }
std::vector<std::string> VoiceLink::remarks() { return std::exchange(remarks_, {}); }

}  // namespace onggi::access
