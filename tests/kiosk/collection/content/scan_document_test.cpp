#include "kiosk/collection/content/scan_document.h"

#include "kiosk/collection/content/catalogue.h"
#include "kiosk/collection/content/pack.h"
#include "kiosk/collection/content/pack_writer.h"
#include "tests/kiosk/collection/content/temporary.h"
#include "tests/support/open_shelf.h"

// What museums publish beside a scan: manifests after IIIF's own examples, documents after
// Voyager's schema.

namespace onggi::content::scan_document_test {
namespace {

namespace fs = std::filesystem;

const char* const kSays =
    R"j("label":{"en":["Moon jar"],"ko":["달항아리"]},"summary":{"en":["A white <i>jar</i>."]},)j"
    R"j("requiredStatement":{"label":{"en":["Attribution"]},"value":{"en":["<a href='x'>The Museum</a>"]}},)j"
    R"j("rights":"http://creativecommons.org/licenses/by/4.0/",)j"
    R"j("provider":[{"id":"https://museum.org","type":"Agent","label":{"en":["Museum of Jars"]}}],)j"
    R"j("homepage":[{"id":"https://museum.org/12.3","type":"Text","label":{"en":["Page"]}}],)j"
    R"j("metadata":[{"label":{"en":["Accession number"]},"value":{"none":["12.3"]}},)j"
    R"j({"label":{"en":["Culture"]},"value":{"en":["Korea"]}},{"label":{"en":["Date"]},"value":{"en":["1700s"]}}])j";

/// A manifest of Presentation 4.0 whose Scene shows what `bodies` names.
std::string manifest(const std::string& bodies, const std::string& says = kSays) {
  return R"j({"@context":"http://iiif.io/api/presentation/4/context.json","id":"https://museum.org/m.json",)j"
         R"j("type":"Manifest",)j" +
         says +
         R"j(,"items":[{"id":"https://museum.org/scene","type":"Scene","items":[{"id":"https://museum.org/p",)j"
         R"j("type":"AnnotationPage","items":[)j" +
         bodies + "]}]}]}";
}

std::string shown(const std::string& name) {
  return R"j({"id":"https://museum.org/a","type":"Annotation","motivation":["painting"],"body":{"id":")j" +
         name +
         R"j(","type":"Model","format":"model/gltf-binary"},"target":"https://museum.org/scene"})j";
}

/// A Voyager document with an asset in each of `assets`: quality and name.
std::string voyager(const std::vector<std::pair<const char*, const char*>>& assets,
                    const char* units = "m") {
  std::string all;
  for (const auto& [quality, uri] : assets)
    all += std::string(all.empty() ? "" : ",") + R"j({"usage":"Web3D","quality":")j" + quality +
           R"j(","assets":[{"uri":")j" + uri + R"j(","type":"Model"}]})j";
  return std::string(
             R"j({"asset":{"type":"application/si-dpo-3d.document+json","version":"1.0",)j"
             R"j("copyright":"(c) The Museum"},"scene":0,"scenes":[{"units":"cm","nodes":[0]}],)j"
             R"j("nodes":[{"model":0}],"models":[{"units":")j") +
         units + R"j(","derivatives":[)j" + all +
         R"j(]}],"metas":[{"collection":{"titles":{"EN":"Moon jar","KO":"달항아리"},)j"
         R"j("creditLine":"Gift of a potter","museum":"Museum of Jars","accessionNumber":"12.3",)j"
         R"j("recordLink":"https://museum.org/12.3","license":"CC0"}}]})j";
}

class Documents : public Temporary {
 protected:
  void SetUp() override { put_jar("jar.glb"); }
  fs::path put_jar(const std::string& name) {
    const fs::path at = folder_ / name;
    fs::create_directories(at.parent_path());
    fs::copy_file("content/vessels/moon_jar/vessel.glb", at);
    return at;
  }
  Problem refused(const std::string& text) {
    const auto read = load_vessel(write("manifest.json", text));
    EXPECT_FALSE(read) << text;
    return read ? Problem{} : read.error();
  }
};

TEST_F(Documents, ofIiifBringTheScanWithTitleCreditLicenceAndPage) {
  const auto jar = load_vessel(write("manifest.json", manifest(shown("jar.glb"))));
  ASSERT_TRUE(jar) << to_text(jar.error());
  EXPECT_EQ(jar->file, folder_ / "jar.glb");
  EXPECT_EQ(jar->id, "jar");
  EXPECT_NEAR(jar->extracted.profile.height(), 0.305, 1e-3);
  EXPECT_EQ(jar->label("en").title, "Moon jar");
  EXPECT_EQ(jar->label("ko").title, "달항아리");
  EXPECT_EQ(jar->label("en").culture, "Korea");
  EXPECT_EQ(jar->label("en").date, "1700s");
  EXPECT_EQ(jar->label("ko").address, "https://museum.org/12.3");
  EXPECT_EQ(jar->licence, "CC-BY-4.0");
  EXPECT_NE(jar->credit.find("The Museum"), std::string::npos);
  EXPECT_EQ(jar->credit.find('<'), std::string::npos);
}

TEST_F(Documents, fillWhatImportWrites) {
  const auto jar = load_vessel(write("manifest.json", manifest(shown("jar.glb"))));
  ASSERT_TRUE(jar);
  const PackRead read = read_pack(write("pack/vessel.toml", pack_toml(*jar)), {"en", "ko"});
  EXPECT_TRUE(read.problems.empty()) << to_text(read.problems.front());
  EXPECT_EQ(read.pack.institution, "Museum of Jars");
  EXPECT_EQ(read.pack.accession, "12.3");
  EXPECT_EQ(read.pack.address, "https://museum.org/12.3");
  EXPECT_EQ(read.pack.licence, "CC-BY-4.0");
  EXPECT_EQ(read.pack.labels.at("en").culture, "Korea");
  EXPECT_EQ(read.pack.labels.at("en").text, "A white jar.");
  EXPECT_EQ(read.pack.labels.at("ko").title, "달항아리");
}

TEST_F(Documents, ofOlderManifestsBringTheScanThatTheyOffer) {
  const std::string canvas =
      std::string(R"j({"type":"Manifest",)j") + kSays +
      R"j(,"items":[{"id":"https://m.org/c","type":"Canvas","items":[]}],"rendering":)j"
      R"j([{"id":"jar.glb","type":"Model","format":"model/gltf-binary"}]})j";
  EXPECT_TRUE(load_vessel(write("manifest.json", canvas)));
  const std::string source =
      R"j({"id":"a","type":"Annotation","body":{"type":"SpecificResource","source":[{"id":"jar.glb","type":"Model"}]}})j";
  EXPECT_TRUE(load_vessel(write("manifest.json", manifest(source))));
}

TEST_F(Documents, ofACanvasThatOffersAScanBesideItsPicturesBringIt) {
  const auto jar = load_vessel(write(
      "manifest.json",
      R"j({"type":"Manifest","label":{"en":["Moon jar"]},"items":[{"type":"Canvas","id":"https://museum.org/c",)j"
      R"j("items":[{"type":"AnnotationPage","items":[{"type":"Annotation","body":{"id":"a.jpg","type":"Image",)j"
      R"j("format":"image/jpeg"}}]}],"rendering":[{"id":"jar.glb","type":"Model","format":"model/gltf-binary"}]}]})j"));
  ASSERT_TRUE(jar) << to_text(jar.error());
  EXPECT_EQ(jar->file, folder_ / "jar.glb");
}

TEST_F(Documents, withAChoiceOfOneVesselBringTheFirstThatIsThere) {
  const auto choice = [](const std::string& second) {
    return R"j({"type":"Annotation","body":{"type":"Choice","items":[{"id":"fine.glb","type":"Model"},{"id":")j" +
           second + R"j(","type":"Model"}]}})j";
  };
  const auto jar = load_vessel(write("manifest.json", manifest(choice("jar.glb"))));
  ASSERT_TRUE(jar) << to_text(jar.error());
  EXPECT_EQ(jar->file, folder_ / "jar.glb");
  EXPECT_NE(refused(manifest(choice("jar.glb") + "," + shown("other.glb"))).what.find("2 models"),
            std::string::npos);
}

TEST_F(Documents, thatShowOneScanAgainLaterShowOne) {
  const Problem two =
      refused(manifest(shown("jar.glb") + "," + shown("other.glb") + "," + shown("jar.glb")));
  EXPECT_NE(two.what.find("2 models"), std::string::npos) << two.what;
}

TEST_F(Documents, ofHundredThousandModelsAreRefusedByTheirNumber) {
  std::string all;
  for (int i = 0; i < 100000; ++i)
    all += (i == 0 ? "" : ",") + (R"({"type":"Model","id":")" + std::to_string(i)) + ".glb\"}";
  const Problem why = refused(manifest(all));
  EXPECT_NE(why.what.find("100000 models"), std::string::npos) << why.what;
}

TEST_F(Documents, giveTheirWordsWithoutTagsAndKeepASignThatIsNone) {
  const auto jar = load_vessel(write(
      "manifest.json",
      manifest(
          shown("jar.glb"),
          R"j("label":{"en":["<b>Moon</b> jar"],"ko":["<i>달항아리</i>"]},"summary":{"en":["A jar <30 cm, a < b, <br/>white."]})j")));
  ASSERT_TRUE(jar) << to_text(jar.error());
  EXPECT_EQ(jar->label("en").title, "Moon jar");
  EXPECT_EQ(jar->label("ko").title, "달항아리");
  EXPECT_EQ(jar->given.description, "A jar <30 cm, a < b, white.");
}

TEST_F(Documents, onTheWebAreTakenFromBesideAndElseToBeDownloadedFirst) {
  EXPECT_TRUE(load_vessel(
      write("manifest.json", manifest(shown("https://museum.org/3d/jar.glb?size=full#here")))));
  for (const char* away : {"https://museum.org/3d/bowl.glb", "http://museum.org/models/77",
                           "//museum.org/bowl.glb", "ftp://museum.org/bowl.glb"}) {
    const Problem why = refused(manifest(shown(away)));
    EXPECT_NE(why.what.find("network"), std::string::npos) << why.what;
    EXPECT_EQ(why.remedy.find("Download it first"), 0u) << why.remedy;
    EXPECT_NE(why.remedy.find(".glb"), std::string::npos) << why.remedy;
  }
}

TEST_F(Documents, openNothingOutsideTheirFolder) {
  const fs::path inner = folder_ / "inner";
  fs::create_directories(inner);
  fs::create_symlink("../jar.glb", inner / "link.glb");
  for (const char* name : {"../jar.glb", "%2e%2e/jar.glb", "/etc/passwd", "link.glb", "nothing.glb",
                           "..\\\\jar.glb", "file:///etc/passwd"}) {
    std::ofstream(inner / "manifest.json") << manifest(shown(name));
    const auto read = load_vessel(inner / "manifest.json");
    ASSERT_FALSE(read) << name;
    EXPECT_FALSE(read.error().remedy.empty());
  }
}

TEST_F(Documents, ofTheSmithsonianBringTheFinestScanThatIsThereInItsUnit) {
  const fs::path fine = put_jar("models/jar-high.glb");
  const auto jar = load_vessel(write(
      "document.json",
      voyager({{"Thumb", "jar.glb"}, {"Highest", "gone.glb"}, {"High", "models/jar-high.glb"}})));
  ASSERT_TRUE(jar) << to_text(jar.error());
  EXPECT_EQ(jar->file, fine);
  EXPECT_EQ(jar->size_from, SizeFrom::units);
  EXPECT_NEAR(jar->extracted.profile.height(), 0.305, 1e-3);
  EXPECT_EQ(jar->label("en").title, "Moon jar");
  EXPECT_EQ(jar->label("ko").title, "달항아리");
  EXPECT_EQ(jar->given.institution, "Museum of Jars");
  EXPECT_EQ(jar->given.accession, "12.3");
  EXPECT_EQ(jar->address, "https://museum.org/12.3");
  EXPECT_EQ(jar->licence, "CC0-1.0");
  EXPECT_EQ(jar->credit, "Gift of a potter. (c) The Museum");
  const auto feet = load_vessel(write("document.json", voyager({{"High", "jar.glb"}}, "ft")));
  ASSERT_TRUE(feet) << to_text(feet.error());
  EXPECT_NEAR(feet->extracted.profile.height(), 0.305 * 0.3048, 1e-3);
}

TEST_F(Documents, onAShelfStandForTheirScanAndOtherJsonIsLeftAlone) {
  put_jar("named/jar.glb");
  write("named/document.json", voyager({{"High", "jar.glb"}}));
  write("figures.json", R"({"jar": 305})");
  write("list.json", "[1, 2]");
  const OpenedShelf shelf = open_shelf(folder_);
  EXPECT_TRUE(shelf.problems.empty()) << to_text(shelf.problems.front());
  ASSERT_EQ(shelf.vessels.size(), 2u);
  EXPECT_EQ(shelf.vessels[0].id, "jar");
  EXPECT_EQ(shelf.vessels[0].address, "");
  EXPECT_EQ(shelf.vessels[1].id, "named");
  EXPECT_EQ(shelf.vessels[1].address, "https://museum.org/12.3");
}

TEST_F(Documents, areLookedOverWithTheirScan) {
  const fs::path file = write("manifest.json", manifest(shown("jar.glb")));
  for (const fs::path& path : {file, folder_}) {
    const ShelfCheck check = check_shelf(path);
    EXPECT_TRUE(check.problems.empty()) << to_text(check.problems.front());
    EXPECT_EQ(check.files, (std::vector<fs::path>{file, folder_ / "jar.glb"}));
  }
  const ShelfCheck none = check_shelf(write("manifest.json", manifest(shown("bowl.glb"))));
  ASSERT_EQ(none.problems.size(), 1u);
  EXPECT_EQ(none.files.size(), 1u);
}

TEST_F(Documents, thatAreNoneOfThemAreRefusedWithARemedy) {
  const std::string image =
      R"j({"id":"a","type":"Annotation","body":{"id":"jar.png","type":"Image","format":"image/png"}})j";
  for (
      const std::string& text :
      {std::string(), std::string("{}"), std::string("[]"), std::string("{\"type\":"),
       std::string(R"({"asset":{"version":"2.0"}})"), std::string(200, '['), manifest(""),
       manifest(image), manifest(shown("jar.glb") + "," + shown("bowl.glb")),
       manifest(shown("manifest.json")), manifest(shown("")), voyager({}),
       voyager({{"High", "gone.glb"}}), voyager({{"High", "jar.glb"}}, "mm"),
       std::string(
           R"j({"type":"Manifest","items":{"body":[[[7,null,"x"]]]},"label":7,"metadata":[3]})j")}) {
    const Problem why = refused(text);
    EXPECT_FALSE(why.what.empty() || why.remedy.empty()) << text;
    EXPECT_EQ(why.exit_code, 2);
  }
}

TEST_F(Documents, sayNoMoreThanALabelCanHold) {
  const std::string says = R"j("label":{"en":["\u001b[31m)j" + std::string(5000, 'a') +
                           R"j("]},"homepage":[{"id":"javascript:alert(1)"}])j";
  const auto jar = load_vessel(write("manifest.json", manifest(shown("jar.glb"), says)));
  ASSERT_TRUE(jar);
  EXPECT_LE(jar->label("en").title.size(), 1000u);
  EXPECT_EQ(jar->label("en").title.find('\x1b'), std::string::npos);
  EXPECT_EQ(jar->address, "");
}

}  // namespace
}  // namespace onggi::content::scan_document_test
