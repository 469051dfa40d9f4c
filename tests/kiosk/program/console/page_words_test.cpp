#include "kiosk/program/console/page_words.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::console::page_words_test {
namespace {

using ::testing::HasSubstr;

constexpr const char* kKorean = R"(name = "한국어"
right_to_left = false
[page]
"Sign in" = "로그인"
"{count} days" = { other = "{count}일" }
[editors]
"Save" = "저장"
)";

class PageWordsTest : public ::testing::Test {
 protected:
  PageWordsTest() { std::filesystem::create_directories(folder_); }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
  }
  PageWords read() {
    remarks_.clear();
    return {folder_, remarks_};
  }
  static std::string body(const PageWords& words, const std::string& target) {
    const auto answer = words.to({.method = "GET", .target = target});
    return answer ? answer->body : "(nothing)";
  }

  files::test::ScratchFolder scratch_;
  std::filesystem::path folder_ = scratch_ / "content";
  std::vector<Problem> remarks_;
};

TEST_F(PageWordsTest, TellWhichLanguagesThereAreAndWhatTheySay) {
  write("ko.toml", kKorean);
  write("notes.txt", "no language");
  write("b\xff\xfe.toml", kKorean);  // no name of a language, and no text either
  const PageWords words = read();
  EXPECT_TRUE(remarks_.empty());
  EXPECT_EQ(body(words, "/words"), R"({"ko":"한국어"})");
  const std::string page = body(words, "/words/ko");
  EXPECT_THAT(page, HasSubstr(R"("Sign in":"로그인")"));
  EXPECT_THAT(page, HasSubstr(R"("{count} days":{"other":"{count}일"})"));
  EXPECT_THAT(page, ::testing::Not(HasSubstr("Save")));  // the desk needs no words of editors
  EXPECT_EQ(body(words, "/words/ko/editors"), R"({"editors":{"Save":"저장"}})");
  for (const char* other : {"/words/", "/words/nl", "/words/ko/", "/words/../ko", "/"})
    EXPECT_EQ(body(words, other), "(nothing)") << other;
}

TEST_F(PageWordsTest, OfABrokenFileAreLeftOutAndItsPlaceIsTold) {
  write("ko.toml", kKorean);
  write("aa.toml", "name = ");
  write("bb.toml", "name = \"b\"\nright_to_left = false\n[page]\nx = 3\n[editors]\n");
  write("cc.toml",
        "name = \"c\"\nright_to_left = false\n[page]\n\"{count}\" = { one = \"x\" }\n[editors]\n");
  write("ee.toml",
        "name = \"e\"\nright_to_left = false\n[page]\nGood = { other = \"x\" }\n[editors]\n");
  write("dd.toml", "name = \"d\"\n[page]\n[editors]\n");
  EXPECT_EQ(body(read(), "/words"), R"({"ko":"한국어"})");
  ASSERT_EQ(remarks_.size(), 5u);
  for (const Problem& remark : remarks_) {
    EXPECT_THAT(remark.where, HasSubstr(folder_.string()));
    EXPECT_FALSE(remark.remedy.empty());
  }
}

TEST_F(PageWordsTest, OfAFolderThatIsNotThereAreNoneAndThatIsTold) {
  std::filesystem::remove_all(folder_);
  EXPECT_EQ(body(read(), "/words"), "{}");
  ASSERT_EQ(remarks_.size(), 1u);
  EXPECT_EQ(remarks_[0].where, folder_.string());
  EXPECT_THAT(remarks_[0].what, HasSubstr("English alone"));
}

TEST_F(PageWordsTest, LieBesideTheProgramOrAboveIt) {
  std::filesystem::create_directories(folder_ / "content/staff");
  std::filesystem::create_directories(folder_ / "build/bin");
  EXPECT_EQ(PageWords::folder_of(folder_ / "build/bin/onggi-console"), folder_ / "content/staff");
  EXPECT_EQ(PageWords::folder_of(folder_ / "onggi-console"), folder_ / "content/staff");
  EXPECT_EQ(PageWords::folder_of("/onggi-console"), "");
}

}  // namespace
}  // namespace onggi::console::page_words_test
