#include "kiosk/ground/toml/texts_of.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace onggi::toml {
namespace {

std::vector<TextAt> texts_in(const std::string& toml) {
  const auto file = std::filesystem::temp_directory_path() / "onggi_texts_of_test.toml";
  std::ofstream(file) << toml;
  auto texts = texts_of(file);
  for (TextAt& text : texts) text.where.erase(0, file.string().size());
  std::filesystem::remove(file);
  return texts;
}

TEST(TextsOf, EveryTextWithItsPlaceInFileOrderWhateverItsKey) {
  const auto texts = texts_in(
      "b = \"달항아리\"  # \"no text\"\na = 3\n[title]\nen = \"A\\u00E9\"\n"
      "list = [\"x\", [\"월\", \"y\"]]\n[[mission]]\nid = \"m\"\n");
  std::string all;
  for (const TextAt& text : texts) all += text.where + " " + text.text + "\n";
  EXPECT_EQ(all, ":1:5 달항아리\n:4:6 A\u00E9\n:5:9 x\n:5:15 월\n:5:20 y\n:7:6 m\n");
}

TEST(TextsOf, AFileThatIsNoTomlHasNone) {
  EXPECT_TRUE(texts_in("a = \"b\nc").empty());
  EXPECT_TRUE(texts_of("/nowhere/at all.toml").empty());
}

}  // namespace
}  // namespace onggi::toml
