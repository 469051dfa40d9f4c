#include "kiosk/exhibit/composition/visit_counter.h"

#include <gtest/gtest.h>

#include "kiosk/keepsake/store/statistics.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::exhibit::visit_counter_test {
namespace {

using files::test::ScratchFolder;

screens::VisitNotes notes_of(double active_s) {
  screens::VisitNotes notes;
  notes.since_s = notes.active_s = active_s;
  notes.language = "en";
  notes.way = "touch";
  return notes;
}

Keepsakes::Finished kept(int ticket) { return {ticket, souvenir::KeepsakeFiles{}}; }
Keepsakes::Finished refused(int ticket) {
  return {ticket, problem("the disk", "It is full.", "Make room.", 1)};
}

TEST(VisitCounter, AVisitWaitsForItsKeepsakeWhicheverComesFirstAndIsCountedOnce) {
  const ScratchFolder scratch;
  const std::string file = (scratch.path() / "onggi.sqlite").string();
  const settings::Exhibit exhibit;
  {
    VisitCounter counter(file, exhibit);
    counter.saved(kept(1));
    counter.visit_over(notes_of(10.0), "kept_before", 1);
    counter.visit_over(notes_of(20.0), "kept_after", 2);
    counter.saved(kept(2));
    counter.visit_over(notes_of(30.0), "refused", 3);
    counter.saved(refused(3));
    counter.visit_over(notes_of(40.0), "nothing_to_keep", 0);
    counter.visit_over(notes_of(50.0), "never_saved", 4);
    counter.finish();
    EXPECT_TRUE(counter.remarks().empty());
  }
  const auto found = store::read_statistics(file, "", "");
  ASSERT_TRUE(found) << found.error().what;
  EXPECT_EQ(found->all.visits, 5);
  for (const store::Cell& cell : found->tables.at(0).cells) {
    EXPECT_EQ(cell.visits, 1) << cell.name;
    EXPECT_EQ(cell.kept, cell.name.starts_with("kept") ? 1 : 0) << cell.name;
  }
}

TEST(VisitCounter, AtTheEndWhatTheDiskDidNotTakeIsThereToBeLogged) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "away") << "a file where a folder is wanted";
  VisitCounter counter(scratch.path() / "away/onggi.sqlite", settings::Exhibit{});
  counter.visit_over(notes_of(10.0), "", 0);
  counter.finish();
  const auto remarks = counter.remarks();
  ASSERT_EQ(remarks.size(), 2u) << "why the disk takes nothing, and what is lost by it";
  EXPECT_EQ(remarks[1].what.rfind("1 visit ", 0), 0u) << remarks[1].what;
}

}  // namespace
}  // namespace onggi::exhibit::visit_counter_test
