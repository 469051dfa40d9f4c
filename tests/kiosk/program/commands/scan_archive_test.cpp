#include "kiosk/program/commands/scan_archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/kiosk/collection/archives/zip_maker.h"
#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands::scan_archive_test {
namespace {

namespace fs = std::filesystem;
using archives::test::ZipEntry;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class ImportOfAnArchive : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "shelf");
    fs::create_directories(folder_ / "tmp");
  }
  /// Imports these entries as `id`; nothing of them may stay elsewhere.
  Outcome import(const std::vector<ZipEntry>& entries, const std::string& more = {}) {
    archives::test::write_zip(folder_ / "scan.zip", archives::test::zip_of(entries));
    const Outcome run =
        onggi("vessel import '" + (folder_ / "scan.zip").string() + "' --id jar --shelf '" +
                  (folder_ / "shelf").string() + "' " + more,
              "export TMPDIR='" + (folder_ / "tmp").string() + "'");
    EXPECT_TRUE(fs::is_empty(folder_ / "tmp")) << "it is removed, whatever happens";
    EXPECT_THAT(run.out + run.err, Not(HasSubstr("onggi-import")));
    EXPECT_EQ(fs::exists(folder_ / "shelf/jar"), run.exit_code == 0);
    return run;
  }
  std::string imported() const { return content(folder_ / "shelf/jar/vessel.glb"); }
  ScratchFolder folder_;
  const std::string bowl_ = content("content/vessels/tea_bowl/vessel.glb"),
                    vase_ = content("content/vessels/cylinder_vase/vessel.glb");
};

TEST_F(ImportOfAnArchive, TheScanInItBecomesAVessel) {
  const Outcome run = import({{"bowl/", ""}, {"bowl/scan.glb", bowl_}, {"bowl/readme.txt", "x"}});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(imported() == bowl_);
  EXPECT_THAT(content(folder_ / "shelf/jar/vessel.toml"), HasSubstr("# From scan.glb."));
}

TEST_F(ImportOfAnArchive, WhereThereAreSeveralSomebodyChooses) {
  const std::vector<ZipEntry> both = {{"a/bowl.glb", bowl_}, {"a/vase.glb", vase_}};
  const Outcome asked = import(both);
  EXPECT_EQ(asked.exit_code, 2);
  EXPECT_THAT(asked.err, AllOf(HasSubstr("several scans in this archive: a/bowl.glb, a/vase.glb."),
                               HasSubstr("--scan 'a/bowl.glb'")));
  const Outcome wrong = import(both, "--scan vase.glb");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("It has: a/bowl.glb, a/vase.glb."));
  EXPECT_EQ(import(both, "--scan a/vase.glb").exit_code, 0);
  EXPECT_TRUE(imported() == vase_);
}

TEST_F(ImportOfAnArchive, AMuseumsDocumentGivesTheScanAndItsWords) {
  const std::string document =
      R"({"asset":{"type":"application/si-dpo-3d.document+json"},"models":[{"units":"m","derivatives":)"
      R"([{"quality":"Low","assets":[{"uri":"low.glb","type":"Model"}]},)"
      R"({"quality":"High","assets":[{"uri":"high.glb","type":"Model"}]}]}],)"
      R"("metas":[{"collection":{"titles":{"EN":"Tea bowl of a monk"}}}]})";
  const Outcome run =
      import({{"low.glb", vase_}, {"high.glb", bowl_}, {"document.json", document}});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(imported() == bowl_);
  EXPECT_THAT(content(folder_ / "shelf/jar/vessel.toml"), HasSubstr("Tea bowl of a monk"));
}

TEST_F(ImportOfAnArchive, ADocumentThatCannotBeUsedIsSaid) {
  const std::string document = R"({"type":"Manifest","items":[{"type":"Scene","items":[{"items":[)"
                               R"({"body":{"id":"finer.glb","type":"Model"}}]}]}]})";
  const Outcome run = import({{"bowl.glb", bowl_}, {"manifest.json", document}});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("note: "), HasSubstr("scan.zip, manifest.json")));
  fs::remove_all(folder_ / "shelf/jar");
  const Outcome alone = import({{"manifest.json", document}});
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_THAT(alone.err, HasSubstr("finer.glb"));
}

TEST_F(ImportOfAnArchive, WhatIsRefusedIsNamedByTheArchivesOwnNames) {
  const Outcome out = import({{"bowl.glb", bowl_}, {"../out", "x"}});
  EXPECT_EQ(out.exit_code, 2);
  EXPECT_THAT(out.err, HasSubstr("scan.zip, ../out: this name is no plain path"));
  const Outcome broken = import({{"bowl.glb", "no glTF"}});
  EXPECT_EQ(broken.exit_code, 2);
  EXPECT_THAT(broken.err, HasSubstr("scan.zip, bowl.glb: "));
  const Outcome none = import({{"readme.txt", "x"}});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("There is no scan in this archive."));
}

TEST_F(ImportOfAnArchive, ALooseFileHasNoScansToChooseFrom) {
  const Outcome run = onggi(
      "vessel import content/vessels/tea_bowl/vessel.glb --scan a.glb --id jar "
      "--shelf '" +
      (folder_ / "shelf").string() + "'");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("only a zip archive has scans to choose from"));
}

}  // namespace
}  // namespace onggi::commands::scan_archive_test
