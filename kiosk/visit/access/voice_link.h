#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kiosk/ground/files/child_process.h"
#include "kiosk/visit/access/utterance.h"

namespace onggi::access {

/// The link to the voice, which is a program of its own, because speech software may hang or die
/// and must not harm the exhibit. Lines go to it and come from it, and nothing here waits:
///   say ID LANGUAGE WORDS    ->    taken ID, then ended ID; or voiceless LANGUAGE
///   hush                     ->    taken 0
/// It writes ready when it is. A program that does not answer within kAnswer is killed and started
/// again after 1, 2, 4 ... 60 s, at most kMost times in a row. Then there is no voice until a
/// visitor asks again (begin()). Main thread.
class VoiceLink {
 public:
  static constexpr double kAnswer = 3.0, kReady = 15.0;  ///< s
  static constexpr int kMost = 8;

  explicit VoiceLink(std::string program, std::vector<std::string> arguments = {});

  /// A visitor wants a voice: starts it if it is not running, regardless of earlier failures.
  void begin(double now);
  /// Speaks, and interrupts the current utterance whatever its weight: the caller decides on
  /// timing. Does nothing without a voice. Until the voice is ready, keeps only the last utterance.
  void say(const Utterance& utterance, double now);
  /// Call once a frame: reads the voice's answers, and checks that it still answers.
  void look(double now);
  /// Finished utterances, each once.
  std::vector<std::uint64_t> ended();
  /// Lines for the log, each once: the voice died, or a language has no voice.
  std::vector<std::string> remarks();
  bool running() const { return child_.has_value(); }
  int failures() const { return failures_; }

 private:
  void start(double now);
  void fail(double now, const std::string& why);
  bool send(const std::string& line, double now);
  void take(const std::string& line, double now);

  std::string program_;
  std::vector<std::string> arguments_;
  std::optional<files::ChildProcess> child_;
  files::Channel to_, from_;
  std::string heard_;  ///< An incomplete line.
  bool wanted_ = false, ready_ = false;
  std::optional<Utterance> waits_;  ///< Spoken when the voice is ready.
  double asked_at_ = -1;            ///< Below 0: no answer is due.
  double again_at_ = -1;
  int failures_ = 0;
  std::vector<std::uint64_t> ended_;
  std::vector<std::string> remarks_;
  std::set<std::string> voiceless_;
};

}  // namespace onggi::access
