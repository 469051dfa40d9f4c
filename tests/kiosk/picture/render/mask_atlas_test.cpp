#include "kiosk/picture/render/mask_atlas.h"

#include <cmath>
#include <map>
#include <set>

#include "tests/kiosk/picture/render/studio_fixture.h"
#include "tests/kiosk/picture/render/texels.h"

namespace onggi::render::testing::mask_atlas_test {
namespace {

class AMask : public StudioTest {
 protected:
  struct Kept {
    MaskAtlas::Place place;
    int w = 0, h = 0;
    std::uint8_t value = 0;
  };
  Kept add(int w, int h) {
    const auto value = static_cast<std::uint8_t>(++made_ % 255 + 1);
    const std::vector<std::uint8_t> mask(static_cast<std::size_t>(w * h), value);
    return {atlas_.add(w, h, mask.data()), w, h, value};
  }
  std::vector<std::uint8_t> texels(std::uint32_t page) {
    const Texture& texture = atlas_.use(page);
    std::vector<std::uint8_t> out;
    for (const float share : testing::shares_of(texture))
      out.push_back(static_cast<std::uint8_t>(std::lround(255 * share)));
    return out;
  }
  MaskAtlas atlas_;
  int made_ = 0;
};

TEST_F(AMask, KeepsItsTexelsBesideAllOthers) {
  std::vector<Kept> kept;
  for (int n = 0; n < 400; ++n) kept.push_back(add(1 + (37 * n) % 300, 1 + (53 * n) % 90));
  std::map<std::uint32_t, std::vector<std::uint8_t>> pages;
  for (const Kept& one : kept) {
    if (pages.count(one.place.page) == 0) pages[one.place.page] = texels(one.place.page);
    const auto& page = pages[one.place.page];
    for (int y = 0; y < one.h; ++y)
      for (int x = 0; x < one.w; ++x)
        ASSERT_EQ(
            page[static_cast<std::size_t>((one.place.y + y) * MaskAtlas::kPage + one.place.x + x)],
            one.value);
  }
  EXPECT_LE(pages.size(), 2u);
}

TEST_F(AMask, LargerThanAPageHasOneOfItsOwn) {
  const Kept small = add(40, 20), wide = add(3000, 30), tall = add(20, 2500), next = add(40, 20);
  EXPECT_NE(small.place.page, wide.place.page);
  EXPECT_NE(tall.place.page, small.place.page);
  EXPECT_EQ(atlas_.use(wide.place.page).width, 3000);
  EXPECT_EQ(atlas_.use(tall.place.page).height, 2500);
  EXPECT_EQ(texels(next.place.page).size() % MaskAtlas::kPage, 0u);
}

TEST_F(AMask, GoesWithItsPageOnceThereIsTooMuchAndOnlyWhereNothingOfItIsInUse) {
  constexpr int kPages = MaskAtlas::kMostBytes / (MaskAtlas::kPage * MaskAtlas::kPage);
  std::vector<std::uint32_t> pages;
  for (int n = 0; n < kPages; ++n) pages.push_back(add(2048, 2048).place.page);
  EXPECT_EQ(atlas_.drop_one(), 0u) << "there is room for as many";
  add(2048, 2048);
  EXPECT_EQ(atlas_.drop_one(), 0u) << "all are in use";
  atlas_.end_of_use();
  atlas_.use(pages[0]);
  EXPECT_EQ(atlas_.drop_one(), pages[1]);
  EXPECT_EQ(atlas_.drop_one(), 0u) << "there is room again";
}

}  // namespace
}  // namespace onggi::render::testing::mask_atlas_test
