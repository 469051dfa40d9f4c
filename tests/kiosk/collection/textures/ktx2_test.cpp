#include "kiosk/collection/textures/ktx2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "kiosk/collection/textures/texture_decoder.h"
#include "tests/kiosk/collection/textures/made_pictures.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

// KTX2 as glTF allows it, against what another decoder makes of the same files (samples/README.md).

namespace onggi::textures::ktx2_test {
namespace {

using namespace testing;

std::string sample(const std::string& name) {
  return files::test::content("tests/kiosk/collection/textures/samples/" + name);
}

TexturePixels other_decoder(const std::string& name) {
  const Decoded decoded = decode_texture(bytes_of(sample(name)), {});
  EXPECT_TRUE(decoded) << name;
  return decoded ? *decoded : TexturePixels{};
}

int worst(const TexturePixels& a, const TexturePixels& b) {
  if (a.width != b.width || a.height != b.height || a.rgb.empty()) return 256;
  int out = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) out = std::max(out, std::abs(a.rgb[i] - b.rgb[i]));
  return out;
}

std::string fault_of(const std::string& bytes, unsigned most = 8192, unsigned wanted = 1024) {
  const Decoded decoded = decode_ktx2(bytes_of(bytes), most, wanted);
  return decoded ? "it was read" : decoded.error();
}

TEST(Ktx2, every_mode_of_uastc_has_the_pixels_of_the_other_decoder) {
  const Decoded decoded = decode_ktx2(bytes_of(sample("every_mode.ktx2")), 8192, 1024);
  ASSERT_TRUE(decoded) << decoded.error();
  // It rounds as a picture of plain numbers is; glTF's are a display's, which may differ by one.
  EXPECT_LE(worst(*decoded, other_decoder("every_mode.png")), 1);
}

TEST(Ktx2, basis_lz_has_the_very_pixels_of_the_other_decoder_on_each_level) {
  const Decoded whole = decode_ktx2(bytes_of(sample("round.ktx2")), 8192, 1024);
  ASSERT_TRUE(whole) << whole.error();
  EXPECT_EQ(worst(*whole, other_decoder("round.png")), 0);
  // The smallest level that is not under what is wanted, and its size is what is judged.
  const Decoded half = decode_ktx2(bytes_of(sample("round.ktx2")), 30, 20);
  ASSERT_TRUE(half) << half.error();
  EXPECT_EQ(worst(*half, other_decoder("round_half.png")), 0);
  EXPECT_NE(fault_of(sample("round.ktx2"), 30, 40).find("50 x 38 pixels"), std::string::npos);
}

TEST(Ktx2, the_first_row_is_the_first) {
  for (const char* name : {"halves.ktx2", "halves_zstandard.ktx2"}) {
    const Decoded decoded = decode_ktx2(bytes_of(sample(name)), 8192, 1024);
    ASSERT_TRUE(decoded) << name << decoded.error();
    EXPECT_LE(worst(*decoded, two_halves(64, {20, 40, 200}, {190, 30, 25})), 4) << name;
  }
}

TEST(Ktx2, cut_off_or_damaged_anywhere_it_is_refused_or_still_a_picture_of_its_size) {
  for (const char* name :
       {"every_mode.ktx2", "round.ktx2", "halves.ktx2", "halves_zstandard.ktx2"}) {
    const std::string whole = sample(name);
    for (std::size_t size = 0; size < whole.size(); size += 7)
      EXPECT_NE(fault_of(whole.substr(0, size)), "it was read") << name << ' ' << size;
    for (std::size_t i = 12; i < whole.size(); ++i) {
      std::string flipped = whole;
      flipped[i] = static_cast<char>(flipped[i] ^ (1 << i % 8));
      const Decoded decoded = decode_ktx2(bytes_of(flipped), 100, 1024);
      if (decoded)
        EXPECT_EQ(decoded->rgb.size(), 3u * static_cast<unsigned>(decoded->width) *
                                           static_cast<unsigned>(decoded->height));
      else
        EXPECT_FALSE(decoded.error().empty());
    }
  }
}

TEST(Ktx2, what_gltf_does_not_allow_is_named) {
  std::string file = sample("halves.ktx2");
  file[20 + 16] = 6;  // faces
  EXPECT_NE(fault_of(file).find("several pictures"), std::string::npos);
  file = sample("halves.ktx2");
  file[12] = 37;  // VK_FORMAT_R8G8B8A8_UNORM
  EXPECT_NE(fault_of(file).find("neither BasisLZ nor UASTC"), std::string::npos);
  file = sample("halves.ktx2");
  for (const std::size_t side : {20u, 24u}) file[side + 2] = 1;  // 65600 pixels
  EXPECT_NE(fault_of(file).find("65600 x 65600 pixels"), std::string::npos) << fault_of(file);
}

}  // namespace
}  // namespace onggi::textures::ktx2_test
