#include "kiosk/collection/textures/texture_decoder.h"

#include <gtest/gtest.h>

#include "tests/kiosk/collection/textures/made_pictures.h"

// Pictures in scans: of any kind, any size, and of anybody's making.

namespace onggi::textures::texture_decoder_test {
namespace {

using namespace testing;

constexpr std::array<std::uint8_t, 3> kBlue{20, 40, 200}, kRed{190, 30, 25};

std::array<int, 3> at(const TexturePixels& p, int x, int y) {
  const auto i = 3 * static_cast<std::size_t>(y * p.width + x);
  return {p.rgb[i], p.rgb[i + 1], p.rgb[i + 2]};
}

void expect_near(const std::array<int, 3>& seen, const std::array<std::uint8_t, 3>& meant,
                 int apart, const std::string& what) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(seen[k], meant[k], apart) << what;
}

std::string why_not(const std::string& bytes, const TextureLimits& limits = {}) {
  const Decoded decoded = decode_texture(bytes_of(bytes), limits);
  return decoded ? "it was read" : decoded.error();
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Textures, each_kind_gives_the_pixels_that_it_was_made_from_first_row_first) {
  const TexturePixels made = two_halves(32, kBlue, kRed);
  for (const auto& [kind, bytes, apart] :
       {std::tuple{"PNG", png_of(made), 0}, std::tuple{"JPEG", jpeg_of(made), 6},
        std::tuple{"WebP", webp_of(made), 0}}) {
    const Decoded decoded = decode_texture(bytes_of(bytes), {});
    ASSERT_TRUE(decoded) << kind << ": " << decoded.error();
    ASSERT_EQ(decoded->width, 32) << kind;
    ASSERT_EQ(decoded->height, 32) << kind;
    expect_near(at(*decoded, 5, 2), kBlue, apart, kind);
    expect_near(at(*decoded, 5, 29), kRed, apart, kind);
  }
}

TEST(Textures, a_gamma_written_in_the_picture_is_not_used) {
  const TexturePixels made = two_halves(4, kBlue, kRed);
  const Decoded decoded =
      decode_texture(bytes_of(png_of(made, png_chunk("gAMA", big_endian(100000)))), {});
  ASSERT_TRUE(decoded) << decoded.error();
  EXPECT_EQ(*decoded, made);
}

TEST(Textures, a_large_picture_is_shrunk_to_the_mean_of_its_light) {
  TexturePixels board;
  board.width = board.height = 64;
  for (int i = 0; i < 64 * 64; ++i) {
    const auto c = static_cast<std::uint8_t>((i + i / 64) % 2 == 0 ? 255 : 0);
    board.rgb.insert(board.rgb.end(), {c, c, c});
  }
  const TexturePixels small = shrunk(board, 16);
  ASSERT_EQ(small.width, 16);
  ASSERT_EQ(small.height, 16);
  // Half of the light is 188 on a screen, not 128.
  EXPECT_EQ(at(small, 7, 9), (std::array<int, 3>{188, 188, 188}));
  EXPECT_EQ(shrunk(board, 64), board);
  // A side that is no multiple keeps all of its pixels.
  const TexturePixels odd = shrunk(two_halves(50, kBlue, kRed), 16);
  EXPECT_EQ(odd.width, 13);
  expect_near(at(odd, 12, 0), kBlue, 0, "corner");
  expect_near(at(odd, 12, 12), kRed, 0, "corner");
}

TEST(Textures, a_picture_that_is_too_large_is_refused_by_its_header) {
  // Nothing but a header: whoever wanted to decode it would say that it is cut off.
  EXPECT_TRUE(holds(why_not(png_head(60000, 60000)), "60000 x 60000 pixels"))
      << why_not(png_head(60000, 60000));
  std::string webp = webp_of(two_halves(40, kBlue, kRed)).substr(0, 40);
  EXPECT_TRUE(holds(why_not(webp, {32, 32}), "40 x 40 pixels")) << why_not(webp, {32, 32});
  const std::string jpeg = jpeg_of(two_halves(40, kBlue, kRed));
  EXPECT_TRUE(holds(why_not(jpeg.substr(0, 640), {32, 32}), "40 x 40 pixels"));
  EXPECT_TRUE(holds(why_not(png_head(0, 8)), "no pixels"));
}

TEST(Textures, damage_is_told_and_never_shown) {
  const TexturePixels made = two_halves(48, kBlue, kRed);
  for (const std::string& whole : {png_of(made), jpeg_of(made), webp_of(made)}) {
    // Within what comes before the pixels, or within these.
    for (const std::size_t size : {whole.size() * 2 / 3, whole.size() - 20})
      EXPECT_TRUE(holds(why_not(whole.substr(0, size)), "damaged"))
          << whole.substr(0, 4) << size << why_not(whole.substr(0, size));
  }
  std::string flipped = png_of(made);
  flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 0x40);
  EXPECT_TRUE(holds(why_not(flipped), "damaged"));
  EXPECT_EQ(why_not(""), "it is empty");
  EXPECT_EQ(why_not("GIF89a, which no scan has"), "it is not a PNG, JPEG, WebP or KTX2");
  EXPECT_TRUE(holds(why_not(jpeg_of(made, 4)), "CMYK"));
}

}  // namespace
}  // namespace onggi::textures::texture_decoder_test
