#include "kiosk/program/console/people.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <thread>
#include <vector>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::console::people_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class PeopleTest : public ::testing::Test {
 protected:
  People open() const {
    auto people = People::open(state_);
    EXPECT_TRUE(people) << to_text(people.error());
    return std::move(*people);
  }
  static std::optional<Role> role(People& people, const std::string& name,
                                  const std::string& phrase) {
    const auto role = people.role_with(name, phrase);
    EXPECT_TRUE(role) << to_text(role.error());
    return *role;
  }
  files::test::ScratchFolder scratch_;
  fs::path state_ = scratch_ / "state";
};

TEST_F(PeopleTest, ComeInByTheirOwnPassphraseAndNoOther) {
  People people = open();
  ASSERT_TRUE(people.set("maria", Role::desk, "three wet sponges"));
  ASSERT_TRUE(people.set("joon", Role::editor, "four dry sponges"));
  EXPECT_EQ(role(people, "maria", "three wet sponges"), Role::desk);
  EXPECT_EQ(role(people, "joon", "four dry sponges"), Role::editor);
  for (const auto& [name, phrase] : {std::pair{"maria", "four dry sponges"},
                                     {"maria", ""},
                                     {"maria", "Three wet sponges"},
                                     {"maria", "three wet sponges "},
                                     {"joon", "three wet sponges"},
                                     {"nobody", "three wet sponges"},
                                     {"", ""},
                                     {"nobody", ""}})
    EXPECT_EQ(role(people, name, phrase), std::nullopt) << name << phrase;
  EXPECT_EQ(role(people, "maria", std::string(100'000, 'x')), std::nullopt);
}

TEST_F(PeopleTest, AreKeptAsHashesInAFolderThatNobodyElseMayRead) {
  People people = open();
  ASSERT_TRUE(people.set("maria", Role::desk, "three wet sponges"));
  const std::string text = files::test::content(state_ / "people");
  EXPECT_THAT(text, HasSubstr("maria desk $argon2id$v=19$m=65536,t=2,p=1$"));
  EXPECT_EQ(text.find("sponges"), std::string::npos);
  struct stat info {};
  ASSERT_EQ(::stat(state_.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 077, 0u);
  People another = open();
  EXPECT_EQ(role(another, "maria", "three wet sponges"), Role::desk);
}

TEST_F(PeopleTest, GetAnotherRoleAndKeepTheirPassphrase) {
  People people = open();
  ASSERT_TRUE(people.set("maria", Role::desk, "three wet sponges"));
  ASSERT_TRUE(people.set("maria", Role::editor, ""));
  EXPECT_EQ(role(people, "maria", "three wet sponges"), Role::editor);
  ASSERT_TRUE(people.set("maria", Role::editor, "another passphrase"));
  EXPECT_EQ(role(people, "maria", "three wet sponges"), std::nullopt);
  ASSERT_TRUE(people.remove("maria"));
  EXPECT_EQ(role(people, "maria", "another passphrase"), std::nullopt);
  EXPECT_EQ(people.remove("maria").error().exit_code, 2);
}

TEST_F(PeopleTest, NamesAndPassphrasesThatCannotBeAreRefusedAndNothingIsWritten) {
  People people = open();
  const std::string good = "123456789012";
  for (const std::string& name :
       {std::string(), std::string("Maria"), std::string("mar ia"), std::string("maria\neve"),
        std::string("1maria"), std::string("mariä"), std::string("../people"),
        std::string(41, 'a')})
    EXPECT_EQ(people.set(name, Role::desk, good).error().exit_code, 2) << name;
  EXPECT_EQ(people.set("maria", Role::desk, "").error().exit_code, 2);
  EXPECT_EQ(
      people.set("maria", Role::desk, std::string(People::kShortest - 1, 'x')).error().exit_code,
      2);
  EXPECT_EQ(
      people.set("maria", Role::desk, std::string(People::kLongest + 1, 'x')).error().exit_code, 2);
  EXPECT_FALSE(fs::exists(state_ / "people"));
  EXPECT_EQ(people.set("maria", Role::desk, "도자기").error().exit_code, 2) << "three letters";
  EXPECT_TRUE(people.set("maria", Role::desk, std::string(People::kShortest, 'x')));
  EXPECT_TRUE(people.set("joon", Role::desk, std::string(People::kLongest, 'x')));
}

// Three programs at once, none of which writes over what another has just written.
TEST_F(PeopleTest, WhatSeveralProgramsChangeAtOnceIsAllChanged) {
  constexpr int kEach = 40;
  const std::vector<std::string> whose{"a", "b", "c"};
  {
    People people = open();
    ASSERT_TRUE(people.set("a0", Role::desk, "three wet sponges"));
    const std::string line = files::test::content(state_ / "people");
    std::ofstream file(state_ / "people");
    for (const std::string& who : whose)
      for (int n = 0; n < kEach; ++n) file << who << n << line.substr(2);
  }
  ASSERT_EQ(open().all()->size(), whose.size() * kEach);
  std::vector<std::thread> programs;
  for (const std::string& who : whose)
    programs.emplace_back([this, &who] {
      People people = open();
      for (int n = 0; n < kEach; ++n)
        EXPECT_TRUE(people.set(who + std::to_string(n), Role::editor, ""));
    });
  for (std::thread& one : programs) one.join();
  const auto all = *open().all();
  EXPECT_EQ(all.size(), whose.size() * kEach);
  for (const Person& one : all) EXPECT_EQ(one.role, Role::editor) << one.name;
}

TEST_F(PeopleTest, AFileThatIsDamagedLetsNobodyInAndSaysWhichLine) {
  People people = open();
  ASSERT_TRUE(people.set("maria", Role::desk, "three wet sponges"));
  for (const char* line :
       {"eve king hash", "eve editor", "Eve editor hash", "eve editor hash more", "x"}) {
    std::ofstream(state_ / "people", std::ios::app) << line << '\n';
    const auto none = people.role_with("maria", "three wet sponges");
    ASSERT_FALSE(none) << line;
    EXPECT_THAT(none.error().where, HasSubstr("people:2"));
    const std::string text = files::test::content(state_ / "people");
    std::ofstream(state_ / "people") << text.substr(0, text.find('\n') + 1);
  }
  EXPECT_EQ(role(people, "maria", "three wet sponges"), Role::desk);
  std::ofstream(state_ / "people", std::ios::app) << "eve editor $argon2id$nonsense\n";
  EXPECT_EQ(role(people, "eve", ""), std::nullopt);
}

}  // namespace
}  // namespace onggi::console::people_test
