#include "kiosk/collection/content/data_uri.h"

#include <gtest/gtest.h>

#include <string>

namespace onggi::content::data_uri_test {
namespace {

std::string decoded(std::string uri, std::size_t most = 1000) {
  const std::span<unsigned char> bytes(reinterpret_cast<unsigned char*>(uri.data()), uri.size());
  if (!is_data_uri(bytes)) return "no data";
  const std::size_t bound = most_bytes_in(bytes);
  const auto out = decode_data_uri(bytes, most);
  if (!out) return "broken";
  EXPECT_LE(out->size(), bound);
  return {out->begin(), out->end()};
}

TEST(DataUri, GivesTheBytesOfTheStandardsOwnExamples) {
  // RFC 4648, section 10.
  for (const auto& [code, text] : {std::pair{"", ""},
                                   {"Zg==", "f"},
                                   {"Zm8=", "fo"},
                                   {"Zm9v", "foo"},
                                   {"Zm9vYg==", "foob"},
                                   {"Zm9vYmE=", "fooba"},
                                   {"Zm9vYmFy", "foobar"},
                                   {"Zg", "f"}})
    EXPECT_EQ(decoded(std::string("data:application/octet-stream;base64,") + code), text);
  EXPECT_EQ(decoded("data:;base64,/+8="), "\xFF\xEF");
  EXPECT_EQ(decoded("data:;base64,\\/\\u002b8\\u003D"), "\xFF\xEF");  // as some write JSON
}

TEST(DataUri, TakesNoMoreThanIsWanted) {
  EXPECT_EQ(decoded("data:;base64,Zm9vYmFy", 4), "foob");
  EXPECT_EQ(decoded("data:;base64,Zm9v*", 3), "foo");
}

TEST(DataUri, RefusesWhatIsNone) {
  for (const char* text : {"", "data", "data:;base64", "a.bin", "data:,Zm9v", "xdata:;base64,Zg=="})
    EXPECT_EQ(decoded(text), "no data") << text;
  for (const char* text :
       {"Zm 9v", "Zm9v*", "Zg==Zg==", "Zm9\\n", "Zm9\\", "Zm9\\u00", "\\u0100AAA"})
    EXPECT_EQ(decoded(std::string("data:;base64,") + text), "broken") << text;
}

}  // namespace
}  // namespace onggi::content::data_uri_test
