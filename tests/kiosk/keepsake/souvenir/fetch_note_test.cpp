#include "kiosk/keepsake/souvenir/fetch_note.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/kiosk/ground/files/disk.h"

namespace onggi::souvenir::fetch_note_test {
namespace {

const std::string kOne(26, 'a'), kTwo(26, '7');

TEST(FetchNote, IsReadAsItWasLeftAndTheFirstDayStays) {
  const files::test::ScratchFolder scratch;
  const auto folder = scratch.path() / "phone/fetched";
  EXPECT_TRUE(fetch_notes(folder, 9).empty());
  EXPECT_TRUE(leave_fetch_note(folder, {kOne, "2026-05-04"}));
  EXPECT_TRUE(leave_fetch_note(folder, {kOne, "2026-05-05"}));
  EXPECT_TRUE(leave_fetch_note(folder, {kTwo, "2026-05-06"}));
  auto notes = fetch_notes(folder, 9);
  std::sort(notes.begin(), notes.end(), [](const auto& a, const auto& b) { return a.id > b.id; });
  EXPECT_EQ(notes, (std::vector<FetchNote>{{kOne, "2026-05-04"}, {kTwo, "2026-05-06"}}));
  EXPECT_EQ(fetch_notes(folder, 1).size(), 1u);
  remove_fetch_note(folder, notes[0]);
  EXPECT_EQ(fetch_notes(folder, 9), (std::vector<FetchNote>{{kTwo, "2026-05-06"}}));
}

TEST(FetchNote, OneThatAPowerCutLeftWithoutItsDayIsWrittenAgainAndNoPartStays) {
  const files::test::ScratchFolder scratch;
  std::ofstream(scratch.path() / kOne).close();
  EXPECT_TRUE(fetch_notes(scratch.path(), 9).empty());
  EXPECT_TRUE(leave_fetch_note(scratch.path(), {kOne, "2026-05-04"}));
  EXPECT_EQ(fetch_notes(scratch.path(), 9), (std::vector<FetchNote>{{kOne, "2026-05-04"}}));
  std::filesystem::create_directory(scratch.path() / kTwo);
  EXPECT_FALSE(leave_fetch_note(scratch.path(), {kTwo, "2026-05-04"})) << "something is in its way";
  EXPECT_EQ(files::test::names_in(scratch.path()), (std::vector<std::string>{kTwo, kOne}));
}

TEST(FetchNote, WhatIsNoneIsPassedOverAndNothingElseIsWrittenOrRemoved) {
  const files::test::ScratchFolder scratch;
  const auto& folder = scratch.path();
  for (const std::string& id : {std::string("../x"), std::string(25, 'a'), std::string(27, 'a'),
                                std::string(26, '/'), std::string(26, 'A')}) {
    EXPECT_FALSE(leave_fetch_note(folder, {id, "2026-05-04"})) << id;
    remove_fetch_note(folder, {id, ""});
  }
  std::ofstream(folder / "a note") << "2026-05-04";
  std::ofstream(folder / kOne) << "2026-05-041";
  std::ofstream(folder / kTwo) << "yesterday!";
  std::filesystem::create_symlink("a note", folder / std::string(26, 'b'));
  EXPECT_TRUE(fetch_notes(folder, 9).empty());
}

}  // namespace
}  // namespace onggi::souvenir::fetch_note_test
