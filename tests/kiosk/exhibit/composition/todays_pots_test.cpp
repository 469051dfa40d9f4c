#include "kiosk/exhibit/composition/todays_pots.h"

#include <gtest/gtest.h>

#include <set>
#include <thread>

#include "kiosk/ground/files/clock_jump.h"
#include "kiosk/keepsake/souvenir/keepsake.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"
#include "tests/kiosk/exhibit/composition/no_renderer.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::exhibit::todays_pots_test {
namespace {

namespace fs = std::filesystem;
using files::test::ScratchFolder;

/// Keeps pictures, draws nothing.
class PictureKeeper final : public test::NoRenderer {
 public:
  view::PictureId make_picture(const view::Image& image) override {
    last = image;
    held.insert(++made);
    return made;
  }
  void drop_picture(view::PictureId id) override { EXPECT_EQ(held.erase(id), 1u); }

  std::set<view::PictureId> held;
  view::PictureId made = 0;
  view::Image last;
};

/// A folder in which pots are kept at a time that the test says.
class Museum {
 public:
  void keep(const std::string& name, int stars = 3) {
    // Encoded once: each takes its time.
    static const auto kJpeg = [] {
      view::Image grey{40, 50, std::vector<std::uint8_t>(4 * 40 * 50, 120)};
      for (std::size_t i = 3; i < grey.rgba.size(); i += 4) grey.rgba[i] = 255;
      return encoding::encode(grey, encoding::Format::jpeg, {});
    }();
    ASSERT_TRUE(kJpeg) << (kJpeg ? "" : to_text(kJpeg.error()));
    fs::create_directories(folder() / name);
    std::ofstream(folder() / name / souvenir::kSmall, std::ios::binary)
        .write(reinterpret_cast<const char*>(kJpeg->data()),
               static_cast<std::streamsize>(kJpeg->size()));
    std::ofstream(folder() / name / souvenir::kShown)
        << souvenir::text_of(souvenir::SmallPot{{}, "jar", stars});
  }
  /// As many, copies of one.
  void keep_copies(const std::string& of, int count) {
    for (int i = 0; i < count; ++i) {
      char name[64];
      std::snprintf(name, sizeof name, "2026-05-04_09%02d%02d_jar", i / 60, i % 60);
      fs::copy(folder() / of, folder() / name);
    }
  }
  void look(TodaysPots& pots) { pots.look(now += 2, renderer, true); }
  const fs::path& folder() const { return scratch_.path(); }
  std::function<std::time_t()> clock() {
    return [this] { return *files::time_of_stamp(wall); };
  }

  PictureKeeper renderer;
  std::string wall = "2026-05-04_150000";
  double now = 10;

 private:
  ScratchFolder scratch_;
};

TEST(TodaysPots, WhatIsKeptIsThereAndWhatIsDeletedIsGoneAtTheNextLook) {
  Museum museum;
  museum.keep("2026-05-04_120000_jar", 2);
  museum.keep("2026-05-04_130000_jar", 5);
  TodaysPots pots(museum.folder(), museum.clock());
  museum.look(pots);
  ASSERT_EQ(pots.pots().size(), 2u);
  EXPECT_EQ(pots.pots()[0].stars, 5) << "the newest first";
  EXPECT_EQ(pots.pots()[1].vessel, "jar");
  EXPECT_EQ(museum.renderer.held.size(), 2u);
  museum.look(pots);
  EXPECT_EQ(museum.renderer.made, 2u) << "a picture is read once";

  fs::remove_all(museum.folder() / "2026-05-04_130000_jar");
  museum.look(pots);
  ASSERT_EQ(pots.pots().size(), 1u);
  EXPECT_EQ(pots.pots()[0].stars, 2);
  EXPECT_EQ(museum.renderer.held.size(), 1u) << "nothing of it is left in memory";
  // A curator takes it out of the gallery and leaves it to its visitor.
  fs::remove(museum.folder() / "2026-05-04_120000_jar" / souvenir::kSmall);
  museum.look(pots);
  EXPECT_TRUE(pots.pots().empty());
}

TEST(TodaysPots, AtMidnightTheGalleryIsEmpty) {
  Museum museum;
  museum.keep("2026-05-04_235900_jar");
  museum.wall = "2026-05-04_235959";
  TodaysPots pots(museum.folder(), museum.clock());
  museum.look(pots);
  EXPECT_EQ(pots.pots().size(), 1u);
  museum.wall = "2026-05-05_000000";
  museum.look(pots);
  EXPECT_TRUE(pots.pots().empty());
  EXPECT_TRUE(museum.renderer.held.empty());
}

TEST(TodaysPots, ADamagedPictureIsLeftOutAndAskedForOnce) {
  Museum museum;
  for (const char* name :
       {"2026-05-04_120000_jar", "2026-05-04_120100_jar", "2026-05-04_120200_jar"})
    museum.keep(name);
  std::ofstream(museum.folder() / "2026-05-04_120100_jar" / souvenir::kSmall) << "no picture";
  const fs::path cut = museum.folder() / "2026-05-04_120200_jar" / souvenir::kSmall;
  fs::resize_file(cut, fs::file_size(cut) / 2);
  TodaysPots pots(museum.folder(), museum.clock());
  museum.look(pots);
  EXPECT_EQ(pots.pots().size(), 1u);
  museum.look(pots);
  EXPECT_EQ(museum.renderer.made, 1u);
}

TEST(TodaysPots, APictureThatEndsTheHelperTakesNoOtherWithIt) {
  Museum museum;
  for (const char* name :
       {"2026-05-04_120000_jar", "2026-05-04_120100_jar", "2026-05-04_120200_jar"})
    museum.keep(name, name[14] - '0');
  const fs::path deadly = museum.folder() / "2026-05-04_120100_jar" / souvenir::kSmall;
  std::ofstream(deadly) << "deadly";
  int asked = 0;
  TodaysPots pots(
      museum.folder(), museum.clock(),
      [&](const TodaysPots::Encoded& pictures) -> Result<std::vector<textures::Decoded>> {
        ++asked;
        for (const auto& one : pictures)
          if (one.size() == 6) return problem("helper", "It ended.", "None.", 1);
        textures::TexturePixels grey{1, 1, {120, 120, 120}};
        return std::vector<textures::Decoded>(pictures.size(), grey);
      });
  museum.look(pots);
  ASSERT_EQ(pots.pots().size(), 2u);
  EXPECT_EQ(pots.pots()[0].stars, 2);
  EXPECT_EQ(pots.pots()[1].stars, 0);
  EXPECT_EQ(asked, 1 + 3) << "once all, then each";
  museum.look(pots);
  EXPECT_EQ(asked, 1 + 3) << "and never again";
}

TEST(TodaysPots, TheFolderMayBeTakenAwayAndComeBack) {
  Museum museum;
  museum.keep("2026-05-04_120000_jar");
  TodaysPots pots(museum.folder(), museum.clock());
  museum.look(pots);
  EXPECT_EQ(pots.pots().size(), 1u);
  const fs::path away = museum.folder().string() + "_away";
  fs::rename(museum.folder(), away);
  museum.look(pots);
  EXPECT_TRUE(pots.pots().empty());
  fs::rename(away, museum.folder());
  museum.look(pots);
  EXPECT_EQ(pots.pots().size(), 1u);
}

TEST(TodaysPots, OfAHundredOneAFrameGoesToTheRendererAndNoFrameWaits) {
  Museum museum;
  museum.keep("2026-05-04_080000_jar");
  museum.keep_copies("2026-05-04_080000_jar", 99);
  TodaysPots pots(museum.folder(), museum.clock());
  for (int frame = 0; frame < 20000 && pots.pots().size() < 100; ++frame) {
    const auto before = museum.renderer.made;
    pots.look(museum.now += 0.001, museum.renderer);
    EXPECT_LE(museum.renderer.made - before, 1u);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(pots.pots().size(), 100u);
  museum.keep_copies("2026-05-04_080000_jar", 0);
  fs::remove_all(museum.folder() / "2026-05-04_090000_jar");
  museum.look(pots);
  EXPECT_EQ(pots.pots().size(), 99u);
  EXPECT_EQ(museum.renderer.held.size(), 99u);
}

TEST(TodaysPots, ItsPlasterGoesOverIntoThePages) {
  Museum museum;
  museum.keep("2026-05-04_120000_jar");
  TodaysPots pots(museum.folder(), museum.clock());
  museum.look(pots);
  const view::Image& image = museum.renderer.last;
  ASSERT_EQ(image.width, 40);
  ASSERT_EQ(image.height, 50);
  const auto alpha = [&](int x, int y) {
    return image.rgba[static_cast<std::size_t>(4 * (y * 40 + x) + 3)];
  };
  EXPECT_EQ(alpha(20, 25), 255);
  EXPECT_LT(alpha(0, 25), 20);
  EXPECT_LT(alpha(39, 25), 20);
  EXPECT_LT(alpha(20, 0), 20);
  EXPECT_LT(alpha(20, 49), 20);
}

}  // namespace
}  // namespace onggi::exhibit::todays_pots_test
