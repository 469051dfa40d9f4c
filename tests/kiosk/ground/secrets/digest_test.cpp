#include "kiosk/ground/secrets/digest.h"

#include <gtest/gtest.h>

namespace onggi::secrets::digest_test {
namespace {

// FIPS 180-4's own example, and the digest of nothing.
TEST(digest_of, is_sha_256) {
  EXPECT_EQ(digest_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(digest_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(same_secret, is_true_of_the_same_bytes_alone) {
  EXPECT_TRUE(same_secret("", ""));
  EXPECT_TRUE(same_secret("ab", "ab"));
  EXPECT_FALSE(same_secret("ab", "ac"));
  EXPECT_FALSE(same_secret("ab", "abc"));
}

}  // namespace
}  // namespace onggi::secrets::digest_test
