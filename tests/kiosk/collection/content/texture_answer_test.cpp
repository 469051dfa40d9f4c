#include "kiosk/collection/content/texture_answer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kiosk/collection/textures/made_pictures.h"

namespace onggi::content::texture_answer_test {
namespace {

using textures::testing::bytes_of;
using textures::testing::two_halves;

TEST(TextureAnswer, says_of_each_picture_what_became_of_it) {
  const textures::TexturePixels made = two_halves(6, {1, 2, 3}, {4, 5, 6});
  const std::vector<textures::Decoded> told{made, tl::unexpected(std::string("it is empty")), made};
  const auto read = answers_of(answer_bytes(told), 3, 6);
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(*read[0], made);
  EXPECT_EQ(read[1].error(), "it is empty");
  EXPECT_EQ(*read[2], made);
}

TEST(TextureAnswer, is_believed_only_whole) {
  const textures::TexturePixels made = two_halves(6, {1, 2, 3}, {4, 5, 6});
  const auto bytes = answer_bytes({made, tl::unexpected(std::string("no"))});
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_TRUE(answers_of(std::span(bytes).first(size), 2, 6).empty()) << size;
  auto longer = bytes;
  longer.push_back(std::byte{0});
  EXPECT_TRUE(answers_of(longer, 2, 6).empty());
  EXPECT_TRUE(answers_of(bytes, 1, 6).empty());
  EXPECT_TRUE(answers_of(bytes, 3, 6).empty());
  EXPECT_TRUE(answers_of(bytes, 2, 5).empty()) << "more pixels than were wanted";
}

TEST(TextureAnswer, and_the_order_has_each_picture_whole_or_none) {
  const std::string a = "first", b, c = "third of them";
  const std::vector<std::span<const std::uint8_t>> all{bytes_of(a), bytes_of(b), bytes_of(c)};
  const auto order = order_bytes(all);
  const std::span<const std::uint8_t> bytes(reinterpret_cast<const std::uint8_t*>(order.data()),
                                            order.size());
  const auto read = pictures_of(bytes);
  ASSERT_EQ(read.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_TRUE(std::equal(read[i].begin(), read[i].end(), all[i].begin(), all[i].end()));
  EXPECT_TRUE(pictures_of(bytes.first(bytes.size() - 1)).empty());
}

}  // namespace
}  // namespace onggi::content::texture_answer_test
