#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace onggi::console {

/// What `onggi check --json` says of an exhibit. It is asked in a process of its own, because it
/// reads every vessel, and again when a file has changed. A thread of its own looks for that and
/// waits for the answer; whoever asks here never waits. The object's end does not wait for a check
/// under way either: that thread ends after it.
class FileCheck {
 public:
  /// s between two looks at the files, while somebody asks; longer where a look takes long.
  static constexpr double kEvery = 2.0;

  /// `onggi`: the program beside this one.
  FileCheck(std::filesystem::path onggi, std::filesystem::path exhibit);
  ~FileCheck();
  FileCheck(FileCheck&&) = default;
  FileCheck& operator=(FileCheck&&) = delete;

  /// The newest answer, as JSON: {"checking": whether a newer one is on its way, "report": null
  /// before the first, else what `onggi check` printed, "trouble": why there is none}.
  std::string json();
  /// How many problems it has found; absent: not known.
  std::optional<std::size_t> problems();

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

}  // namespace onggi::console
