#include "kiosk/exhibit/editing/edit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/stat.h>

#include <cmath>
#include <random>

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/ground/files/durable_steps.h"
#include "tests/kiosk/exhibit/editing/small_site.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::editing::edit_test {
namespace {

using namespace test;
using changes::Revisions;
using files::test::in_child;
using files::test::names_in;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const char* const kExhibit = "config/exhibit.toml";

Result<Edited> set(const SmallSite& site, const std::string& key, const std::string& value) {
  return set_values(site.exhibit(), {{.key = key, .value = value}});
}

/// Expects `done` to be refused with `what`, and the site to be as `before`.
template <class Done>
void expect_refused(const Done& done, const std::string& what, const SmallSite& site,
                    const std::map<std::string, std::string>& before) {
  ASSERT_FALSE(done);
  EXPECT_THAT(to_text(done.error()), HasSubstr(what));
  EXPECT_EQ(site.texts(), before);
}

TEST(edit, is_thought_of_without_being_made) {
  const SmallSite site;
  const auto before = site.texts();
  const auto draft = with_changes(site.exhibit(), {{.key = "idle.warn_after", .value = "90"}});
  ASSERT_TRUE(draft) << to_text(draft.error());
  EXPECT_EQ(draft->text, replaced(content(site.exhibit()), "warn_after = 60 ", "warn_after = 90 "));
  EXPECT_EQ(site.texts(), before);
  EXPECT_FALSE(with_changes(site.exhibit(), {{.key = "idle.warn", .value = "90"}}));
}

TEST(edit, changes_one_value_and_undo_gives_back_every_byte) {
  const SmallSite site;
  const std::string before = content(site.exhibit());
  const auto done = set(site, "idle.warn_after", "90");
  ASSERT_TRUE(done) << to_text(done.error());
  EXPECT_EQ(content(site.exhibit()), replaced(before, "warn_after = 60 ", "warn_after = 90 "));
  EXPECT_EQ(change_words(done->revision.values.at(0)), "idle.warn_after is 90 now. It was 60.");
  const auto undone = undo(site.exhibit());
  ASSERT_TRUE(undone) << to_text(undone.error());
  EXPECT_EQ(content(site.exhibit()), before);
  EXPECT_FALSE(undone->kept_others);
  EXPECT_THAT(undo_words(undone->revision.values.at(0), undone->revision.when),
              HasSubstr("idle.warn_after is 60 again. It was 90 since 20"));
  const auto again = undo(site.exhibit());
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().what, HasSubstr("There is no change to take back."));
}

TEST(edit, takes_values_as_a_shell_leaves_them) {
  const SmallSite site;
  for (const auto& [key, typed, written] :
       {std::array{"credit", "Museum of Clay", "credit = \"Museum of Clay\" "},
        std::array{"credit", "\"in quotes\"", "credit = \"in quotes\" "},
        std::array{"credit", "46", "credit = \"46\" "},
        std::array{"credit", "he said \"go\"", "credit = \"he said \\\"go\\\"\" "},
        std::array{"attract.scripts", "follow, collapse", "scripts = [\"follow\", \"collapse\"]"},
        std::array{"attract.scripts", "[\"follow\"]", "scripts = [\"follow\"]"},
        std::array{"hidden", "", "hidden = [] "}, std::array{"screen.force", "0.5", "force = 0.5 "},
        std::array{"title.ko", "도자기", "ko = \"도자기\""},
        std::array{"screen.spoken", "true", "spoken = true "}}) {
    const auto done = set(site, key, typed);
    ASSERT_TRUE(done) << to_text(done.error());
    EXPECT_THAT(content(site.exhibit()), HasSubstr(written)) << key << typed;
  }
}

TEST(edit, adds_what_is_absent_and_undo_takes_it_away) {
  const SmallSite site;
  const std::string before = content(site.exhibit());
  for (const auto& [key, value] : {std::pair{"phone.address", "http://192.168.4.1:8080"},
                                   {"vessel_scenes.moon_jar", "scenes/master.toml"},
                                   {"hours.every_day", "10:00-18:00"}})
    ASSERT_TRUE(set(site, key, value)) << key;
  EXPECT_THAT(content(site.exhibit()), HasSubstr("[hours]\nevery_day = \"10:00-18:00\"\n"));
  for (int n = 0; n < 3; ++n) ASSERT_TRUE(undo(site.exhibit()));
  EXPECT_EQ(content(site.exhibit()), before);
}

TEST(edit, refuses_what_check_would_find_and_writes_nothing) {
  const SmallSite site;
  const auto before = site.texts();
  const auto refused = [&](const std::string& key, const std::string& value,
                           const std::string& what) {
    SCOPED_TRACE(key + " " + value);
    expect_refused(set(site, key, value), what, site, before);
  };
  refused("idle.warn_after", "5", "the smallest allowed value is 20 s");
  refused("idle.warn_after", "soon", "\"soon\" is not a number");
  refused("idle.warn_aftr", "60", "Did you mean idle.warn_after?");
  refused("warn_after", "60", "Did you mean idle.warn_after?");
  refused("screen.spoken", "yes", "\"yes\" is not true or false");
  refused("keepsake.quota_mb", "2000.5", "is not a whole number");
  refused("scene", "scenes/none.toml", "There is no file");
  refused("shelf", "nowhere", "is not a folder");
  refused("order", "moon_jra", "moon_jra");
  refused("languages", "en,xx", "There are no words for \"xx\"");
  refused("languages", "en,ko,fr", "There is no title for the language \"fr\"");
  refused("hours.exceptions.\"13-45\"", "closed", "is not a valid date");
  refused("idle", "5", "idle is not a key of this file");
  refused("idle warn", "5", "is not a key");
  EXPECT_FALSE(fs::exists(site / "revisions"));
}

TEST(edit, sets_several_values_in_one_step_where_each_alone_would_be_refused) {
  const SmallSite site;
  const std::string before = content(site.exhibit());
  const auto done =
      set_values(site.exhibit(), {{"languages", "en,ko,fr"}, {"title.fr", "Faites un pot"}});
  ASSERT_TRUE(done) << to_text(done.error());
  EXPECT_EQ(content(site.exhibit()),
            replaced(replaced(before, "[\"en\", \"ko\"]", "[\"en\", \"ko\", \"fr\"]"),
                     "ko = \"도자기 빚기\"\n", "ko = \"도자기 빚기\"\nfr = \"Faites un pot\"\n"));
  ASSERT_TRUE(undo(site.exhibit()));
  EXPECT_EQ(content(site.exhibit()), before);
}

TEST(edit, says_where_a_refused_value_stands_and_tells_of_the_value_first) {
  const SmallSite site;
  const auto replaced_value = set(site, "idle.warn_after", "5");
  ASSERT_FALSE(replaced_value);
  EXPECT_THAT(replaced_value.error().where, ::testing::EndsWith("config/exhibit.toml:28:14"));
  // A line that was never written has no number.
  const auto added = set(site, "phone.hours", "0");
  ASSERT_FALSE(added);
  EXPECT_THAT(added.error().where, ::testing::EndsWith("config/exhibit.toml, phone.hours"));
  // A fault elsewhere, in lines that an added one has moved.
  const auto date = set(site, "hours.exceptions.12-25", "closed");
  ASSERT_FALSE(date);
  EXPECT_THAT(date.error().where,
              ::testing::EndsWith("config/exhibit.toml, hours.exceptions.12-25"));
  // The file is called as it was named, also where the exhibit leads to it.
  const auto gloss =
      set_values(site / "config/../content/glazes.toml", {{"glaze.celadon.gloss", "2"}});
  ASSERT_FALSE(gloss);
  EXPECT_THAT(gloss.error().where, ::testing::EndsWith("config/../content/glazes.toml:10:9"));
  // Six other days lack hours too.
  const auto day = set(site, "hours.monday", "10-12");
  ASSERT_FALSE(day);
  EXPECT_THAT(day.error().what, HasSubstr("cannot be read as opening hours"));
}

TEST(edit, of_an_exhibit_with_old_faults_is_refused_for_new_ones_alone) {
  const SmallSite site;
  site.by_hand(kExhibit, "countdown = 25", "countdown = 1");
  EXPECT_TRUE(set(site, "idle.warn_after", "90"));
  EXPECT_FALSE(set(site, "idle.result_after", "1"));
  EXPECT_TRUE(set(site, "idle.countdown", "30"));
}

TEST(edit, that_changes_nothing_writes_nothing) {
  const SmallSite site;
  const auto done = set(site, "idle.warn_after", "60");
  ASSERT_TRUE(done);
  EXPECT_TRUE(done->revision.values.empty());
  EXPECT_FALSE(fs::exists(site / "revisions"));
}

TEST(edit, of_other_files_of_the_exhibit_is_checked_with_all_of_it) {
  const SmallSite site;
  const auto before = site.texts();
  EXPECT_TRUE(set_values(site / "content/missions.toml", {{"mission.litre_jar.on", "true"}}));
  EXPECT_TRUE(set_values(site / "content/lessons/first_minute.toml", {{"step.open.after", "20"}}));
  EXPECT_TRUE(set_values(site / "content/lessons/first_minute.toml", {{"step.2.after", "21"}}));
  EXPECT_TRUE(set_values(site / "config/scenes/studio.toml", {{"contact.stiffness", "6e6"}}));
  EXPECT_TRUE(set_values(site / "content/vessels/moon_jar/vessel.toml",
                         {{"label.ko.title", "백자 달항아리"}}));
  EXPECT_TRUE(set_values(site / "content/glazes.toml", {{"glaze.celadon.name.en", "Green"}}));
  EXPECT_TRUE(set_values(site / "config/devices/polhem.toml", {{"force.max", "3"}}));
  for (int n = 0; n < 7; ++n) {
    const auto undone = undo(site.exhibit());
    ASSERT_TRUE(undone) << to_text(undone.error());
  }
  EXPECT_EQ(site.texts(), before);
  const auto refused = [&](const char* file, const char* key, const char* value, const char* what) {
    SCOPED_TRACE(key);
    expect_refused(set_values(site / file, {{.key = key, .value = value}}), what, site, before);
  };
  refused("content/missions.toml", "mission.litre_jar.kind", "descrbe", "descrbe");
  refused("content/lessons/first_minute.toml", "step.opne.after", "20", "Did you mean step.open?");
  refused("content/lessons/first_minute.toml", "step.99.after", "20", "There is no step \"99\"");
  refused("content/lessons/first_minute.toml", "step.open.after", "1", "smallest allowed value");
  refused("config/scenes/first_touch.toml", "clay.rows", "1", "clay.rows");
  refused("content/vessels/moon_jar/vessel.toml", "true_height_mm", "-5", "true_height_mm");
  refused("config/devices/polhem.toml", "force.max", "300", "largest allowed value");
}

TEST(edit, keeps_what_a_hand_changed_in_between) {
  const SmallSite site;
  ASSERT_TRUE(set(site, "idle.warn_after", "90"));
  site.by_hand(kExhibit, "countdown = 25", "countdown = 30");
  const auto undone = undo(site.exhibit());
  ASSERT_TRUE(undone) << to_text(undone.error());
  EXPECT_TRUE(undone->kept_others);
  EXPECT_THAT(content(site.exhibit()), HasSubstr("warn_after = 60 "));
  EXPECT_THAT(content(site.exhibit()), HasSubstr("countdown = 30 "));
  // An added line goes, and the hand's stay.
  ASSERT_TRUE(set(site, "hours.every_day", "10:00-18:00"));
  site.by_hand(kExhibit, "countdown = 30", "countdown = 40");
  ASSERT_TRUE(undo(site.exhibit()));
  EXPECT_THAT(content(site.exhibit()), HasSubstr("countdown = 40 "));
  EXPECT_THAT(content(site.exhibit()), ::testing::Not(HasSubstr("\nevery_day")));
}

TEST(edit, does_not_undo_a_value_that_a_hand_has_changed_since) {
  const SmallSite site;
  ASSERT_TRUE(set(site, "idle.countdown", "30"));
  ASSERT_TRUE(set(site, "idle.warn_after", "90"));
  site.by_hand(kExhibit, "warn_after = 90", "warn_after = 100");
  const auto before = site.texts();
  expect_refused(undo(site.exhibit()), "was changed by hand", site, before);
  const auto forgotten = forget_newest(site.exhibit());
  ASSERT_TRUE(forgotten);
  EXPECT_EQ(words_of(*forgotten), "idle.warn_after: 60 -> 90");
  EXPECT_EQ(site.texts(), before);
  ASSERT_TRUE(undo(site.exhibit()));
  EXPECT_THAT(content(site.exhibit()), HasSubstr("warn_after = 100 "));
  EXPECT_THAT(content(site.exhibit()), HasSubstr("countdown = 25 "));
}

TEST(edit, keeps_permissions_and_links) {
  const SmallSite site;
  fs::rename(site.exhibit(), site / "config/real.toml");
  fs::create_symlink("real.toml", site.exhibit());
  ASSERT_EQ(::chmod((site / "config/real.toml").c_str(), 0640), 0);
  const auto done = set(site, "idle.warn_after", "90");
  ASSERT_TRUE(done) << to_text(done.error());
  EXPECT_TRUE(fs::is_symlink(site.exhibit()));
  EXPECT_THAT(content(site / "config/real.toml"), HasSubstr("warn_after = 90 "));
  struct stat info {};
  ASSERT_EQ(::stat((site / "config/real.toml").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 07777u, 0640u);
  ASSERT_TRUE(undo(site.exhibit()));
  EXPECT_THAT(content(site / "config/real.toml"), HasSubstr("warn_after = 60 "));
}

TEST(edit, takes_a_value_out_and_undo_puts_it_back_also_beside_what_a_hand_changed) {
  const SmallSite site;
  const std::string before = content(site.exhibit());
  const std::vector<changes::Change> away = {{"idle.countdown", std::nullopt}, {"credit", "Clay"}};
  const auto done = set_values(site.exhibit(), away);
  ASSERT_TRUE(done) << to_text(done.error());
  EXPECT_THAT(content(site.exhibit()), Not(HasSubstr("countdown")));
  EXPECT_EQ(change_words(done->revision.values.at(0)),
            "idle.countdown is not written any more. It was 25.");
  ASSERT_TRUE(undo(site.exhibit()));
  EXPECT_EQ(content(site.exhibit()), before);

  ASSERT_TRUE(set_values(site.exhibit(), away));
  site.by_hand(kExhibit, "warn_after = 60 ", "warn_after = 70 ");
  const auto undone = undo(site.exhibit());
  ASSERT_TRUE(undone) << to_text(undone.error());
  EXPECT_TRUE(undone->kept_others);
  const settings::Exhibit now = settings::read_exhibit(site.exhibit()).exhibit;
  EXPECT_EQ(now.idle.countdown, 25);
  EXPECT_EQ(now.idle.warn_after, 70);
  EXPECT_EQ(now.credit, "Onggi");
}

TEST(edit, takes_back_the_change_that_is_meant_and_no_other_that_came_meanwhile) {
  const SmallSite site;
  ASSERT_TRUE(set(site, "idle.warn_after", "90"));
  const std::string meant = Revisions(site.exhibit()).read().front().kept_in.stem().string();
  ASSERT_TRUE(set(site, "sound.volume", "0.25"));
  const std::string before = content(site.exhibit());
  const auto refused = undo(site.exhibit(), meant);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().exit_code, kAnotherFile);
  EXPECT_FALSE(forget_newest(site.exhibit(), meant));
  EXPECT_EQ(content(site.exhibit()), before);
  EXPECT_EQ(Revisions(site.exhibit()).read().size(), 2u);
  ASSERT_TRUE(undo(site.exhibit()));
  EXPECT_TRUE(undo(site.exhibit(), meant));
}

// Two browsers and a hand with a text editor, each counting in the same value: whoever writes has
// seen what was written before.
class Counting {
 public:
  Counting() {
    fs::create_directories(folder_ / "devices");
    std::ofstream(file()) << "# of a hand\nlifts_after = 0.1\n";
  }
  fs::path file() const { return folder_ / "devices/space_mouse.toml"; }
  int count() const {
    const std::string text = content(file());
    return static_cast<int>(std::lround(1000 * std::stod(text.substr(text.find('=') + 1)))) - 100;
  }
  /// What a browser shows: the count, and the file's tag.
  std::pair<int, std::string> seen() const { return {count(), changes::tag_of(content(file()))}; }
  static std::string written(int count) { return std::to_string(0.1 + 0.001 * count); }
  bool set(const std::pair<int, std::string>& seen) const {
    const auto done = set_values(file(), {{"lifts_after", written(seen.first + 1)}}, seen.second);
    if (!done) {
      EXPECT_EQ(done.error().exit_code, kAnotherFile) << to_text(done.error());
    }
    return done.has_value();
  }
  void by_hand() const {
    const std::string text = "# of a hand\nlifts_after = " + written(count() + 1) + "\n";
    std::ofstream(file()) << text;
  }

 private:
  const files::test::ScratchFolder folder_;
};

const Counting* counted = nullptr;
int hands_counts = 0;

TEST(edit, of_two_browsers_and_a_hand_loses_nobodys_change) {
  const Counting counting;
  counted = &counting;
  hands_counts = 0;
  std::mt19937 random(46);
  std::array<std::pair<int, std::string>, 2> browser{counting.seen(), counting.seen()};
  int accepted = 0, refused = 0;
  constexpr int kSteps = 10'000;
  for (int step = 0; step < kSteps; ++step) {
    auto& one = browser.at(random() % 2);
    switch (random() % 4) {
      case 0:
        one = counting.seen();
        break;
      case 1:
        counting.by_hand();
        ++hands_counts;
        break;
      case 2:  // while it is written
        files::watch_steps([](std::string_view done) {
          if (done != "revision kept") return;
          counted->by_hand();
          ++hands_counts;
        });
        [[fallthrough]];
      default:
        counting.set(one) ? ++accepted : ++refused;
        files::watch_steps(nullptr);
    }
    ASSERT_EQ(counting.count(), accepted + hands_counts) << step;
  }
  EXPECT_GT(accepted, kSteps / 40);
  EXPECT_GT(refused, kSteps / 40);
}

// The folder of settings becomes a disk of its own, without room or without rights.
TEST(edit, on_a_disk_that_takes_nothing_leaves_the_old_file_whole) {
  for (const auto& [flags, options, what] :
       {std::tuple{0UL, "size=16k,nr_inodes=64", "The disk is full."},
        std::tuple{0UL, "size=1m", "read-only"}}) {
    const SmallSite site;
    const std::string text = content(site.exhibit());
    const bool full = std::string(options).starts_with("size=16k");
    const int status = files::test::on_a_disk(site / "config", flags, options, [&, what = what] {
      site.write(kExhibit, "scene = \"" + fs::absolute("config/scenes/studio.toml").string() +
                               "\"\n" + (full ? "#" + std::string(9000, ' ') + "\n" : ""));
      const std::string before = content(site.exhibit());
      if (!full &&
          ::mount("none", (site / "config").c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) != 0)
        return false;
      const auto done = set(site, "credit", "Clay");
      if (done || done.error().exit_code != 1 ||
          done.error().what.find(what) == std::string::npos ||
          done.error().what.find("The file is as it was.") == std::string::npos) {
        ADD_FAILURE() << (done ? "it was done" : to_text(done.error()));
        return false;
      }
      return content(site.exhibit()) == before && Revisions(site.exhibit()).read().empty() &&
             names_in(site / "config").size() == 1;
    });
    if (WIFEXITED(status) && WEXITSTATUS(status) == files::test::kNoMounts)
      GTEST_SKIP() << "This machine lets no test mount a disk.";
    EXPECT_EQ(status, 0) << options;
  }
}

// The exhibit is root's, as on a kiosk, and the curator forgot to say sudo.
TEST(edit, of_a_user_without_rights_is_told_to_say_sudo) {
  if (::geteuid() != 0) GTEST_SKIP() << "Only root can become another user.";
  const SmallSite site;
  for (fs::path above = site.path().parent_path(); above != above.root_path();
       above = above.parent_path())
    if ((fs::status(above).permissions() & fs::perms::others_exec) == fs::perms::none)
      GTEST_SKIP() << above << " is shut to other users.";
  // The copies have the checkout's rights, and that may be one user's alone.
  for (const auto& entry : fs::recursive_directory_iterator(site.path()))
    fs::permissions(entry, fs::perms(entry.is_directory() ? 0755 : 0644));
  const auto before = site.texts();
  for (const char* shut : {".", "config"}) {
    fs::permissions(site.path(), fs::perms(0777));
    fs::permissions(site / "config", fs::perms(0777));
    fs::permissions(site / shut, fs::perms(0755));
    const int status = in_child([&] {
      if (::setuid(65534) != 0) return false;
      const auto done = set(site, "idle.warn_after", "90");
      const bool told = !done && done.error().exit_code == 1 &&
                        done.error().what.find("The file is as it was.") != std::string::npos &&
                        done.error().remedy.starts_with("Write sudo before the command.");
      if (!told) ADD_FAILURE() << (done ? "it was done" : to_text(done.error()));
      return told;
    });
    EXPECT_EQ(status, 0) << shut;
    EXPECT_EQ(site.texts(), before);
    EXPECT_TRUE(Revisions(site.exhibit()).read().empty());
  }
}

fs::path saved_meanwhile;

// While the exhibit is checked an editor saves the same file.
TEST(edit, does_not_overwrite_what_somebody_saves_at_the_same_moment) {
  const SmallSite site;
  saved_meanwhile = site.exhibit();
  const std::string by_hand = replaced(content(site.exhibit()), "\"Onggi\"", "\"Saved\"");
  static std::string text;
  text = by_hand;
  files::watch_steps([](std::string_view step) {
    if (step == "revision kept") std::ofstream(saved_meanwhile, std::ios::binary) << text;
  });
  const auto done = set(site, "idle.warn_after", "90");
  files::watch_steps(nullptr);
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().what, HasSubstr("Somebody else changed this file"));
  EXPECT_EQ(content(site.exhibit()), by_hand);
  EXPECT_TRUE(Revisions(site.exhibit()).read().empty());
}

std::string kill_at;
int steps_to_go = 0;
void kill_there(std::string_view step) {
  if (step == kill_at && steps_to_go-- == 0) ::raise(SIGKILL);
}

std::vector<std::string> steps_seen;
void note_step(std::string_view step) { steps_seen.emplace_back(step); }

TEST(edit, keeps_its_revision_before_it_replaces_the_file_and_forgets_it_after) {
  const SmallSite site;
  ASSERT_TRUE(set(site, "idle.countdown", "30"));  // the folder is there now
  const std::vector<std::string> write(files::kDurableSteps.begin(), files::kDurableSteps.end());
  const auto and_then = [](std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  steps_seen.clear();
  files::watch_steps(note_step);
  const bool done = set(site, "idle.warn_after", "90").has_value();
  const auto setting = std::exchange(steps_seen, {});
  const bool undone = undo(site.exhibit()).has_value();
  files::watch_steps(nullptr);
  ASSERT_TRUE(done && undone);
  EXPECT_EQ(setting,
            and_then(and_then(and_then(write, {"revision kept"}), write), {"file replaced"}));
  EXPECT_EQ(steps_seen, and_then(and_then(write, {"file replaced"}), {"revision forgotten"}));
}

// A real process is ended at every step of a change and of taking it back.
TEST(edit, killed_at_any_step_leaves_the_old_file_or_the_new_one_and_undo_knows_which) {
  const SmallSite site;
  ASSERT_TRUE(set(site, "idle.countdown", "30"));
  const std::string old = content(site.exhibit()),
                    fresh = replaced(old, "warn_after = 60 ", "warn_after = 90 ");
  std::vector<std::pair<std::string, int>> points;
  for (const std::string_view step : files::kDurableSteps)
    for (const int which : {0, 1}) points.emplace_back(step, which);  // the revision's, the file's
  points.emplace_back("revision kept", 0);
  points.emplace_back("file replaced", 0);
  points.emplace_back("revision forgotten", 0);
  int killed = 0, were_old = 0, were_new = 0;
  for (const bool setting : {true, false})
    for (const auto& [step, which] : points) {
      SCOPED_TRACE((setting ? "set " : "undo ") + step + std::to_string(which));
      site.write(kExhibit, old);
      if (!setting) {
        ASSERT_TRUE(set(site, "idle.warn_after", "90"));
      }
      const int status = in_child([&, step = step, which = which] {
        kill_at = step;
        steps_to_go = which;
        files::watch_steps(kill_there);
        return setting ? set(site, "idle.warn_after", "90").has_value()
                       : undo(site.exhibit()).has_value();
      });
      const std::string now = content(site.exhibit());
      ASSERT_TRUE(now == old || now == fresh);
      if (WIFSIGNALED(status)) ++killed;
      ++(now == old ? were_old : were_new);
      // What is listed is what stands in the file, and the next change works.
      const auto all = Revisions(site.exhibit()).read();
      ASSERT_FALSE(all.empty());
      EXPECT_EQ(words_of(all.front()),
                now == fresh ? "idle.warn_after: 60 -> 90" : "idle.countdown: 25 -> 30");
      ASSERT_TRUE(set(site, "idle.result_after", "100"));
      ASSERT_TRUE(undo(site.exhibit()));
      EXPECT_EQ(content(site.exhibit()), now);
      if (now == fresh) {
        ASSERT_TRUE(undo(site.exhibit()));
      }
      EXPECT_EQ(content(site.exhibit()), old);
      for (const char* folder : {"config", "revisions"})
        for (const std::string& name : names_in(site / folder))
          EXPECT_FALSE(name.ends_with(".part")) << folder << name;
    }
  EXPECT_GE(killed, 20);
  EXPECT_GE(were_old, 8);
  EXPECT_GE(were_new, 8);
}

}  // namespace
}  // namespace onggi::editing::edit_test
