#include "kiosk/collection/content/address.h"

#include "kiosk/collection/content/pack.h"
#include "kiosk/collection/content/pack_writer.h"
#include "tests/kiosk/collection/content/temporary.h"

namespace onggi::content::address_test {
namespace {

TEST(Address, IsAPageThatAPhoneOpens) {
  for (const char* good : {"https://www.museum.go.kr/site/main/relic/search/view?relicId=305",
                           "https://a.museum", "https://n2t.net/ark:/65665/3a0c1",
                           "https://xn--9t4b11yi5a.kr/%EB%8B%AC", "https://museum.org#jar"})
    EXPECT_EQ(fault_of_address(good), "") << good;
  for (const std::string& bad :
       {std::string(), std::string("museum.org/305"), std::string("http://museum.org"),
        std::string("HTTPS://museum.org"), std::string("https://"), std::string("https://museum"),
        std::string("https://127.0.0.1/"), std::string("https://.org"),
        std::string("https://museum..org"), std::string("https://curator:secret@museum.org"),
        std::string("https://museum.org:8443/"), std::string("https://museum.org/moon jar"),
        std::string("https://museum.org/\x1b[31m"), std::string("https://museum.org/\n"),
        std::string("https://박물관.kr"), std::string("https://museum.org/\"<script>"),
        std::string("javascript:https://museum.org"),
        "https://museum.org/" + std::string(kLongestAddress, 'a')})
    EXPECT_NE(fault_of_address(bad), "") << bad;
}

TEST(Address, IsReadWithoutWhatNobodyTypes) {
  EXPECT_EQ(short_address("https://www.museum.org/jar/"), "museum.org/jar");
  EXPECT_EQ(short_address("https://a.museum"), "a.museum");
  const std::string most = "museum.org/" + std::string(29, 'j');
  EXPECT_EQ(short_address("https://" + most), most);
  EXPECT_EQ(short_address("https://" + most + "j"), "museum.org");
  EXPECT_EQ(short_address("https://www.museum.org?relic=" + std::string(60, '1')), "museum.org");
}

class AnAddress : public Temporary {
 protected:
  PackRead pack(const std::string& address, const std::string& korean = "") {
    return read_pack(write("jar/vessel.toml",
                           "true_height_mm = 100\ninstitution = \"M\"\nsource = \"S\"\n"
                           "credit = \"C\"\nlicence = \"CC0-1.0\"\n" +
                               address +
                               "[label.en]\ntitle = \"Jar\"\nculture = \"K\"\ndate = \"d\"\n"
                               "made = \"m\"\ntext = \"t\"\n[label.ko]\ntitle = \"항아리\"\n"
                               "culture = \"K\"\ndate = \"d\"\nmade = \"m\"\ntext = \"t\"\n" +
                               korean));
  }
};

TEST_F(AnAddress, IsAskedForByNobody) {
  const PackRead read = pack("");
  EXPECT_TRUE(read.problems.empty());
  EXPECT_TRUE(read.advice.empty()) << to_text(read.advice.front());
}

TEST_F(AnAddress, StandsOnEveryLabelButThoseWithOneOfTheirOwn) {
  const PackRead read =
      pack("address = \"https://museum.org/12.3\"\n", "address = \"https://museum.org/ko/12.3\"\n");
  EXPECT_TRUE(read.problems.empty() && read.advice.empty());
  Vessel vessel;
  vessel.address = read.pack.address;
  vessel.labels = read.pack.labels;
  EXPECT_EQ(vessel.label("en").address, "https://museum.org/12.3");
  EXPECT_EQ(vessel.label("ko").address, "https://museum.org/ko/12.3");
  vessel.labels.clear();
  EXPECT_EQ(vessel.label("en").address, "https://museum.org/12.3");
}

TEST_F(AnAddress, ThatIsNoneIsNamedWithItsLineAndLeftOffTheLabelNotTheShelf) {
  const PackRead read = pack("address = \"http://museum.org/12.3\"\n", "address = \"\"\n");
  EXPECT_TRUE(read.problems.empty());
  ASSERT_EQ(read.advice.size(), 2u);
  EXPECT_NE(read.advice[0].where.find("vessel.toml:6:"), std::string::npos) << read.advice[0].where;
  EXPECT_NE(read.advice[0].what.find("https"), std::string::npos);
  EXPECT_FALSE(read.advice[0].remedy.empty());
  EXPECT_EQ(read.pack.address, "");
  EXPECT_EQ(read.pack.labels.at("ko").address, "");
}

TEST_F(AnAddress, OfTheFileItselfIsWrittenByImportAndThatOfAnArchiveOnlyOffered) {
  Vessel vessel;
  vessel.extracted.profile.points = {{0, 0.03, 0}, {0.1, 0.03, 0.02}};
  EXPECT_NE(pack_toml(vessel).find("# address = \"https://"), std::string::npos);
  vessel.given.source = "https://sketchfab.com/3d-models/jar-1";
  EXPECT_NE(pack_toml(vessel).find("\n# address = \"https://sketchfab.com/3d-models/jar-1\"\n"),
            std::string::npos);
  vessel.given.address = "https://museum.org/12.3";
  EXPECT_NE(pack_toml(vessel).find("\naddress = \"https://museum.org/12.3\"\n"), std::string::npos);
  EXPECT_EQ(read_pack(write("jar/vessel.toml", pack_toml(vessel))).pack.address,
            "https://museum.org/12.3");
}

}  // namespace
}  // namespace onggi::content::address_test
