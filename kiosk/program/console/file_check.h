#pragma once

#include <filesystem>
#include <future>
#include <string>

namespace onggi::console {

/// What `onggi check --json` says of an exhibit. It is asked in a process of its own, because it
/// reads every vessel, and again when a file has changed. One thread; the check has another.
class FileCheck {
 public:
  /// `onggi`: the program beside this one.
  FileCheck(std::filesystem::path onggi, std::filesystem::path exhibit);

  /// The newest answer, as JSON: {"checking": whether a newer one is on its way, "report": null
  /// before the first, else what `onggi check` printed, "trouble": why there is none}. Begins a
  /// check where a file has changed; never waits for it.
  std::string json();

 private:
  struct Answer {
    std::string report, trouble;
  };
  static Answer ask(const std::filesystem::path& onggi, const std::filesystem::path& exhibit);
  std::string stamps() const;

  std::filesystem::path onggi_, exhibit_;
  std::string checked_;  // stamps of the files that the answer is about
  Answer answer_;
  std::future<Answer> coming_;
};

}  // namespace onggi::console
