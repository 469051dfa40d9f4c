#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace onggi::console {

/// Lets the program `onggi` do what takes seconds, in a process of its own: change a file, for
/// which it looks at the whole exhibit with every vessel, or measure. A thread of its own waits for
/// it; whoever asks here never waits. One piece of work at a time. The object's end does not wait
/// for one under way: that thread ends after it.
class OnggiProcess {
 public:
  /// `onggi`: the program beside this one.
  explicit OnggiProcess(std::filesystem::path onggi) : onggi_(std::move(onggi)) {}

  /// Begins `onggi ARGUMENTS`, which prints a JSON object. False while another one is under way.
  bool begin(std::vector<std::string> arguments);
  bool under_way() const;
  /// What it printed, once: nothing before its end. Where it failed, {"done": false, "what": why,
  /// "remedy": what to do}.
  std::optional<std::string> take();

 private:
  struct Shared;
  std::filesystem::path onggi_;
  std::shared_ptr<Shared> shared_;
};

}  // namespace onggi::console
