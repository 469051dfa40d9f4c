// A kiosk's keeping without its screens: keepsakes and counted visits, by the rooms that a kiosk
// keeps them with, for tests/faults/run.py to put faults into.
//   onggi_faults_keeper FOLDER FIRST COUNT [--quota-mb N]
// Keeps the visits FIRST .. FIRST + COUNT - 1, one after the other, and says what came of each when
// a kiosk would say it:
//   kept NAME            its folder is whole
//   refused NAME: WORDS  and will be tried again by nobody
//   turned NAME          its picture that turns is there, too
//   remark WORDS         what staff should know of the store
//   counted N            of this run, visits that are in the store: unless there was a remark
//   before
// exit 0 whatever the disk did: a kiosk plays on.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <thread>

#include "kiosk/exhibit/composition/keepsakes.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/keepsake/store/store_thread.h"

namespace {

using namespace onggi;

void say(const std::string& line) {
  std::fputs((line + "\n").c_str(), stdout);
  std::fflush(stdout);
}

// By the clock on the wall, as a kiosk names them: it may be ten years off.
std::string name_of(int n) {
  char number[24];
  std::snprintf(number, sizeof number, "_jar_%06d", n);
  return files::local_time(std::time(nullptr), files::kStamp) + number;
}

// The same for every visit but in name: so that whoever looks knows what each file must hold.
souvenir::Keepsake keepsake_of(int n) {
  souvenir::Keepsake all;
  all.name = name_of(n);
  all.postcard.width = 60;
  all.postcard.height = 84;
  for (int k = 0; k < 60 * 84 * 4; ++k)
    all.postcard.rgba.push_back(static_cast<std::uint8_t>(k % 4 == 3 ? 255 : k * 7 / 3));
  all.caption = {"Moon jar", "A museum", "thrown by hand"};
  for (int k = 0; k < 9000; ++k) all.glb.push_back(static_cast<std::byte>(k * 31));
  for (int k = 0; k < 5000; ++k) all.replay.push_back(static_cast<std::byte>(k * 17));
  return all;
}

encoding::Turning turning() {
  encoding::Turning all{12, 12, 3, 1.0, {}};
  for (int k = 0; k < 3 * 12 * 12 * 4; ++k)
    all.rgba.push_back(static_cast<std::uint8_t>(k % 4 == 3 ? 255 : k * 5 / 3));
  return all;
}

store::VisitRecord record_now() {
  store::VisitRecord visit;
  visit.start = std::time(nullptr);
  visit.day = files::local_time(visit.start, files::kDay);
  visit.hour = 12;
  visit.vessel = "moon_jar";
  visit.scene = "first_touch";
  visit.language = "en";
  visit.way = "touch";
  visit.reached = visit.left = "keepsake";
  visit.ended = "finished";
  visit.active_s = 60.0;
  visit.throwing_s = 40.0;
  visit.pots = 1;
  visit.likeness = 80.0;
  visit.kept = true;
  return visit;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fputs("usage: onggi_faults_keeper FOLDER FIRST COUNT [--quota-mb N]\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const int first = std::atoi(argv[2]), count = std::atoi(argv[3]);
  const int quota =
      argc > 5 && std::strcmp(argv[4], "--quota-mb") == 0 ? std::atoi(argv[5]) : 100'000;
  exhibit::Keepsakes keepsakes(folder, {.quota_mb = quota, .days = 30});
  store::StoreThread store(folder / "onggi.sqlite", 12);
  double now = 0.0;
  for (int n = first; n < first + count; ++n) {
    keepsakes.look(now += 60.0);
    const int ticket = keepsakes.save(keepsake_of(n));
    keepsakes.add(ticket, turning(), {"Moon jar", "A museum", "thrown by hand"});
    std::optional<exhibit::Keepsakes::Finished> done;
    while (!(done = keepsakes.finished()))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    say(done->outcome ? "kept " + done->outcome->folder.filename().string()
                      : "refused " + name_of(n) + ": " + to_text(done->outcome.error()));
    std::optional<exhibit::Keepsakes::Added> added;
    while (!(added = keepsakes.added())) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (added->outcome) say("turned " + added->outcome->parent_path().filename().string());
    store.visit(record_now());
    store.finish();
    const auto remarks = store.remarks();
    for (const Problem& remark : remarks) say("remark " + to_text(remark));
    say("counted " + std::to_string(n - first + 1));
  }
  store.end();
  for (const Problem& remark : store.remarks()) say("remark " + to_text(remark));
  say("ended");
  return 0;
}
