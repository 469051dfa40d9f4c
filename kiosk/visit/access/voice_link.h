#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kiosk/ground/files/child_process.h"
#include "kiosk/visit/access/utterance.h"

namespace onggi::access {

/// The voice, which is a program of its own: what makes it speak may hang or die and takes nothing
/// of the exhibit with it. Lines go to it and come from it, and nothing here waits:
///   say ID LANGUAGE WORDS    ->    taken ID, then ended ID; or voiceless LANGUAGE
///   hush                     ->    taken 0
/// It says ready when it is. A program that does not answer within kAnswer is killed and begun
/// anew, after 1, 2, 4 ... 60 s, and kMost times in a row at the most: then there is no voice until
/// somebody asks for one again (begin()). Main thread.
class VoiceLink {
 public:
  static constexpr double kAnswer = 3.0, kReady = 15.0;  ///< s
  static constexpr int kMost = 8;

  /// `program` with `arguments` is the voice.
  explicit VoiceLink(std::string program, std::vector<std::string> arguments = {});

  /// A visitor wants a voice: it is started where it is not running, however often it failed.
  void begin(double now);
  /// Ended by the next say() of whatever weight: who says when is not decided here. Nothing while
  /// there is no voice, and nothing of what came before it was ready but the last.
  void say(const Utterance& utterance, double now);
  /// Once a frame: what the voice has said since, and whether it still does.
  void look(double now);
  /// Utterances that are over, once each.
  std::vector<std::uint64_t> ended();
  /// Lines for the log, once each: a voice that died, one that a language has not.
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
  std::string heard_;  ///< A line that has not ended yet.
  bool wanted_ = false, ready_ = false;
  std::optional<Utterance> waits_;  ///< Until it is ready.
  double asked_at_ = -1;            ///< Below 0: it owes no answer.
  double again_at_ = -1;
  int failures_ = 0;
  std::vector<std::uint64_t> ended_;
  std::vector<std::string> remarks_;
  std::set<std::string> voiceless_;
};

}  // namespace onggi::access
