#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace onggi::console {

/// A screen as `onggi screen` drew it, or why it did not.
struct DrawnScreen {
  struct Picture {
    int width = 0, height = 0;  ///< Pixels.
    std::string jpeg;
  };
  std::vector<Picture> pictures{};
  std::string what{}, remedy{};  ///< Why there is none, in words; "" where there are some.
  bool left = false;             ///< It was ended, because it was not wanted any more.
};

/// Draws screens of the exhibit by `onggi screen`, in a process of its own, one at a time: where a
/// service draws (onggi-screen.socket), in that one, else in a child of this process. A thread of
/// its own waits for it; whoever asks here never waits.
class ScreenDrawer {
 public:
  /// `onggi`: the program beside this one. `service`: the service's Unix socket; "": none.
  ScreenDrawer(std::filesystem::path onggi, std::filesystem::path service)
      : onggi_(std::move(onggi)), service_(std::move(service)) {}

  /// Begins `onggi screen WORDS`. False while another one is under way. It ends as soon as
  /// `unwanted` is true, which is asked some times a second, in that thread; whoever draws then
  /// stops within a second.
  bool begin(std::vector<std::string> words, std::function<bool()> unwanted);
  bool under_way() const;
  /// What came of it, once: nothing before its end.
  std::optional<DrawnScreen> take();

 private:
  struct Shared;
  std::filesystem::path onggi_, service_;
  std::shared_ptr<Shared> shared_;
};

}  // namespace onggi::console
