#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/ground/files/virtual_display.h"
#include "tests/kiosk/program/commands/temporary_exhibit.h"

namespace onggi::exhibit {

/// A kiosk in a window that nobody sees, with the moon jar on its shelf and a folder of its own.
class OneJar : public ::testing::Test {
 protected:
  /// Opens it, and waits for the shelf; skips the test where there is no display. `keepsake`: more
  /// of that table, and `before`: tables of the exhibit before it.
  void open(const std::string& scene, const std::string& keepsake, KioskOptions options,
            const std::string& before = "") {
    auto made = files::VirtualDisplay::ensure(options.window.width, options.window.height);
    if (!made) GTEST_SKIP() << "no display, and Xvfb is not installed";
    display_ = std::move(*made);
    std::filesystem::create_directories(folder_ / "shelf");
    std::filesystem::copy("content/vessels/moon_jar", folder_ / "shelf/moon_jar",
                          std::filesystem::copy_options::recursive);
    options.config = commands::write_exhibit(
        folder_, scene,
        before + "[keepsake]\nfolder = \"" + (folder_ / "kept").string() + "\"\n" + keepsake +
            "[store]\ncount = " + (counted_ ? "true\n" : "false\n"));
    options.shelf = folder_ / "shelf";
    options.bus = [this] { return plugged(); };
    auto kiosk = Kiosk::open(options);
    ASSERT_TRUE(kiosk) << to_text(kiosk.error());
    kiosk_ = std::move(*kiosk);
    const auto ready = [&] {
      return kiosk_->doing().open_to_visitors && kiosk_->shelf().complete();
    };
    for (int n = 0; n < 10'000 && !ready(); ++n) {
      kiosk_->frame(now_ += 0.01, false);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));  // The shelf has a thread.
    }
    ASSERT_TRUE(ready());
  }
  void TearDown() override {
    kiosk_.reset();
    display_.reset();
  }

  /// A puck that nobody touches, `pucks` times.
  struct Bus final : device::HidBus {
    struct Port final : device::HidPort {
      int read(std::span<std::uint8_t>, int timeout_ms) noexcept override {
        std::this_thread::sleep_for(std::chrono::milliseconds(timeout_ms));
        return 0;
      }
      bool write(device::Report) noexcept override { return true; }
      int feature(std::uint8_t, std::span<std::uint8_t>) noexcept override { return -1; }
    };
    explicit Bus(int pucks) : pucks_(pucks) {}
    std::vector<device::HidListing> list() override {
      std::vector<device::HidListing> all(static_cast<std::size_t>(pucks_));
      for (std::size_t n = 0; n < all.size(); ++n) {
        all[n].path = std::to_string(n);
        all[n].vendor = 0x256f;
        all[n].product = 0xc635;
        all[n].usage_page = 1;
        all[n].usage = 8;
      }
      return all;
    }
    std::unique_ptr<device::HidPort> open(const std::string&) override {
      return std::make_unique<Port>();
    }
    int pucks_;
  };

  virtual std::unique_ptr<device::HidBus> plugged() { return std::make_unique<Bus>(pucks_); }

  bool counted_ = false;  ///< Visits are counted, beside the keepsakes.
  int pucks_ = 0;         ///< Plugged in.
  commands::ScratchFolder folder_;
  std::unique_ptr<files::VirtualDisplay> display_;
  double now_ = 0;
  std::unique_ptr<Kiosk> kiosk_;
};

}  // namespace onggi::exhibit
