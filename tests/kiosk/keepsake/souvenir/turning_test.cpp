#include "kiosk/keepsake/souvenir/turning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "kiosk/keepsake/souvenir/open_passes.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::souvenir::turning_test {
namespace {

using namespace files::test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kVisit = "2026-05-04_141503_moon_jar";

std::vector<std::byte> a_gif() { return std::vector<std::byte>(5000, std::byte{'g'}); }

fs::path put_turned(const fs::path& folder, const std::string& name, std::size_t kilobytes = 1) {
  fs::create_directories(folder / name);
  std::ofstream(folder / name / "postcard.png") << std::string(kilobytes * 1000, 'x');
  return folder / name;
}

/// Noise, which no GIF makes smaller.
encoding::Turning busy(int frames) {
  encoding::Turning all{64, 64, frames, 4.0, {}};
  std::uint32_t state = 1;
  for (int k = 0; k < 4 * 64 * 64 * frames; ++k) {
    state = state * 1664525u + 1013904223u;
    all.rgba.push_back(k % 4 == 3 ? 255 : static_cast<std::uint8_t>(state >> 24));
  }
  return all;
}

TEST(TurningPicture, ComesIntoTheVisitThatIsThereAndLeavesNothingBeside) {
  const ScratchFolder scratch;
  const fs::path visit = put_turned(scratch.path(), kVisit);
  const auto added = add_turning(visit, a_gif(), {100});
  ASSERT_TRUE(added) << to_text(added.error());
  EXPECT_EQ(*added, visit / "turning.gif");
  EXPECT_EQ(fs::file_size(*added), 5000u);
  EXPECT_THAT(names_in(visit), ElementsAre("postcard.png", "turning.gif"));
  EXPECT_THAT(names_in(scratch.path()), ElementsAre(kVisit));
}

TEST(TurningPicture, AVisitThatWasDeletedMeanwhileGetsNoneAndNoneIsLeftOfIt) {
  const ScratchFolder scratch;
  const auto added = add_turning(scratch.path() / kVisit, a_gif(), {100});
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().exit_code, 1);
  EXPECT_THAT(names_in(scratch.path()), ElementsAre());
  // Renamed, and about to be removed.
  put_turned(scratch.path(), std::string(kVisit) + ".partial");
  ASSERT_FALSE(add_turning(scratch.path() / kVisit, a_gif(), {100}));
  EXPECT_THAT(names_in(scratch.path() / (std::string(kVisit) + ".partial")),
              ElementsAre("postcard.png"));
}

TEST(TurningPicture, WhoDeletesAKeepsakeDeletesWhatAPowerCutLeftOfItsTurningPicture) {
  const ScratchFolder scratch;
  const Passes passes(scratch.path());
  put_turned(scratch.path(), kVisit);
  const fs::path left = scratch.path() / (std::string(kVisit) + ".partial");
  fs::create_directories(left);
  std::ofstream(left / "turning.gif") << "half";
  const auto pass = passes.give(kVisit, 1000, 24);
  ASSERT_TRUE(pass);
  EXPECT_TRUE(OpenPasses(scratch.path()).remove_all_of(*pass));
  EXPECT_FALSE(fs::exists(scratch.path() / kVisit));
  EXPECT_FALSE(fs::exists(left));
}

TEST(TurningPicture, AVisitGoesForTheQuotaWithItsTurningPictureWhateverAPowerCutLeftOfAnother) {
  const ScratchFolder scratch;
  const fs::path old = put_turned(scratch.path(), "2026-01-01_100000_a", 6000);
  ASSERT_TRUE(add_turning(old, std::vector<std::byte>(3'000'000), {10}));
  fs::create_directories(old.string() + ".partial");
  std::ofstream(old.string() + ".partial/turning.gif") << "half";
  const fs::path visit = put_turned(scratch.path(), kVisit, 900);
  ASSERT_TRUE(tidy(scratch.path(), {10}));
  EXPECT_TRUE(fs::exists(old)) << "9.9 MB are within the quota";
  ASSERT_TRUE(add_turning(visit, std::vector<std::byte>(500'000), {10}));
  EXPECT_THAT(names_in(scratch.path()), ElementsAre(kVisit))
      << "it counts, and it is tidied around";
  EXPECT_THAT(names_in(visit), ElementsAre("postcard.png", "turning.gif"));
}

TEST(TurningPicture, ADiskThatRefusesCostsThePictureAndNothingElse) {
  const ScratchFolder scratch;
  const fs::path visit = put_turned(scratch.path(), kVisit);
  fs::permissions(scratch.path(), fs::perms::owner_read | fs::perms::owner_exec);
  const int status = in_child([&] {
    if (::geteuid() == 0 && ::setuid(65534) != 0) return false;
    return !add_turning(visit, a_gif(), {100}).has_value();
  });
  fs::permissions(scratch.path(), fs::perms::owner_all);
  EXPECT_EQ(status, 0);
  EXPECT_THAT(names_in(visit), ElementsAre("postcard.png"));
  EXPECT_THAT(names_in(scratch.path()), ElementsAre(kVisit));
}

TEST(TurningPicture, APotTooBusyForTheMostTurnsAsLongInFewerPictures) {
  const auto whole = turning_picture(busy(8), {});
  ASSERT_TRUE(whole) << to_text(whole.error());
  const auto half = turning_picture(busy(8), {}, whole->size() - 1);
  ASSERT_TRUE(half) << to_text(half.error());
  EXPECT_LT(half->size(), 0.6 * static_cast<double>(whole->size()));
  encoding::Turning every_second = busy(8);
  const std::size_t size = 4u * 64u * 64u;
  every_second.frames = 4;
  std::vector<std::uint8_t> kept;
  for (std::size_t n = 0; n < 8; n += 2)
    kept.insert(kept.end(), every_second.rgba.begin() + static_cast<std::ptrdiff_t>(n * size),
                every_second.rgba.begin() + static_cast<std::ptrdiff_t>((n + 1) * size));
  every_second.rgba = kept;
  EXPECT_EQ(*half, *encoding::encode(every_second, {}));
  const auto none = turning_picture(busy(8), {}, 1000);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().what, HasSubstr("1000 are allowed"));
}

}  // namespace
}  // namespace onggi::souvenir::turning_test
