#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/log.h"
#include "kiosk/ground/web/message.h"
#include "kiosk/keepsake/souvenir/staff_notice.h"
#include "kiosk/program/console/change_log.h"
#include "kiosk/program/console/desk_answers.h"
#include "kiosk/program/console/door.h"
#include "kiosk/program/console/edit_answers.h"
#include "kiosk/program/console/figures.h"
#include "kiosk/program/console/file_check.h"
#include "kiosk/program/console/page_words.h"
#include "kiosk/program/console/patience.h"
#include "kiosk/program/console/people.h"
#include "kiosk/program/console/scan_answers.h"
#include "kiosk/program/console/scene_answers.h"
#include "kiosk/program/console/screen_answers.h"
#include "kiosk/program/console/site.h"
#include "kiosk/program/console/vessel_titles.h"

namespace onggi::console {

/// The staff's page of one exhibit. Whoever has no session (Door) gets a page to sign in, and 401
/// for all else. (e): an editor alone, 403 for others.
///   GET  /                       the page
///   GET  /?code=CODE             in, by a code
///   GET  /api/door               whether anybody has a name yet
///   GET  /words, /words/CODE...  what the page says in other languages (PageWords)
///   POST /api/enter              {name, passphrase}: in, by them
///   POST /api/leave              ends the session
///   GET  /api/state              who is signed in, and how the kiosk is, in words
///   GET  /api/files              what onggi check says
///   GET  /api/figures?from=&to=  what visitors did, small cells left out
///   GET  /figures.svg?from=&to=  the same as a picture
///   GET  /api/keepsakes?day=DAY, ?name=WORDS      what was kept, newest first
///   GET  /keepsake/VISIT/FILE    one of its pictures
///   GET  /print/VISIT            a page that prints the postcard
///   POST /api/keepsakes/VISIT/pass    a page for the visitor's phone
///   POST /api/keepsakes/VISIT/delete  every copy, for good
///   POST /api/passphrase         {old, new}: one's own
///   GET  /api/edit/NAME      (e) a file that can be changed: exhibit, scene/NAME
///   POST /api/edit/NAME/check(e) {changes}: what is wrong with them
///   POST /api/edit/NAME/save (e) {tag, changes, try}: begins to change it
///   GET  /api/saved?number=  (e) what came of a change
///   GET  /api/revisions      (e) what can be taken back
///   POST /api/undo           (e) {id, forget}: begins to take back the newest
///   POST /api/trial/keep     (e) keeps the change that is tried
///   POST /api/trial/back     (e) begins to take it back now
///   GET  /api/shelf          (e) the vessels in their order
///   GET  /outline/ID             one of them from the side
///   GET  /sheet/ID           (e) section and view of it, drawn
///   GET  /api/scenes         (e) the scenes: what each is for, who plays it
///   POST /api/screen         (e) {screen, language, vessel, comfort, file, changes}: begins it
///   GET  /api/screen?number= (e) what came of it
///   POST /api/screen/stop    (e) ends it
///   GET  /screen/NUMBER/N    (e) one of its pictures
///   GET  /api/prices/NAME    (e) what its effects cost on this machine
///   POST /api/prices/NAME    (e) measures that anew
///   POST /api/upload?name=&first=1 (e) a file of a scan, as it is
///   GET  /api/scan           (e) what has arrived, and what is in it
///   POST /api/scan/look      (e) begins to read it
///   POST /api/scan/place     (e) {vessel, id, turned_over, height_mm}: begins to shelve it
///   POST /api/scan/forget    (e) deletes what has arrived
///   GET  /api/people         (e) names and roles
///   POST /api/people         (e) {name, role, passphrase}: adds or changes somebody
///   POST /api/people/NAME/remove (e)
///   GET  /api/changes        (e) who changed what, newest first
/// A POST needs a JSON body (a file: application/octet-stream), and the page's own address as its
/// Origin. A Host that is not one of the program's is refused, so that no other site's name can
/// lead here. One thread.
class StaffAnswers final : public web::Answering {
 public:
  /// What it works with.
  struct Parts {
    Site site;
    FileCheck check;
    std::filesystem::path onggi;  ///< The program that changes files.
    People people;
    ChangeLog changes;
    std::filesystem::path prices;         ///< A folder for what scenes cost,
    std::filesystem::path scans;          ///< one for scans on their way to the shelf,
    std::filesystem::path sheets;         ///< one for the drawn sheets of vessels,
    std::filesystem::path trial;          ///< and a file for the change that is tried.
    std::filesystem::path screens{};      ///< The socket of the service that draws; "": none.
    PageWords words{};                    ///< The page in other languages.
    std::function<std::int64_t()> clock;  ///< s since 1970.
    /// Gets what the staff should know of a file.
    std::function<void(const Problem&)> tell = files::log_problem;
  };
  /// Refuses everything until open().
  explicit StaffAnswers(Parts parts)
      : parts_(std::move(parts)),
        titles_(parts_.site),
        desk_(parts_.site, titles_, parts_.tell),
        edit_(parts_.site, parts_.onggi, parts_.sheets, parts_.trial),
        scenes_(parts_.site, ScenePrices(parts_.onggi, parts_.prices)),
        scans_(parts_.site, ScanInbox(parts_.onggi, parts_.scans)),
        screens_(parts_.site, ScreenDrawer(parts_.onggi, parts_.screens)),
        notice_(parts_.site.exhibit().keepsake.folder) {}
  StaffAnswers(const StaffAnswers&) = delete;
  StaffAnswers& operator=(const StaffAnswers&) = delete;
  /// `hosts`: the Host fields that are accepted, "127.0.0.1:8090"; the first is the page's address.
  /// `scheme`: how browsers reach them, "http://" or "https://".
  void open(Door door, std::vector<std::string> hosts, std::string scheme = "http://") {
    door_ = std::move(door);
    hosts_ = std::move(hosts);
    scheme_ = std::move(scheme);
    address_ = scheme_ + hosts_.front();
    tell_kiosk();
  }

  web::Answer to(const web::Ask& ask) override;
  /// A scan's file goes to the disk, and only from an editor.
  web::BodyPlace place_for_body(const web::Ask& head) override;
  web::Answer refusal(int status, const Problem& why) override;
  /// A label in twelve languages.
  std::size_t most_of_a_body() const override { return 128u << 10; }
  /// After open().
  const Door& door() const { return *door_; }
  /// Call it once a minute: forgets changes that are too old.
  void look_after();
  /// Call it last: waits some seconds for a change under way, so that it is noted who made it.
  void end();

 private:
  std::optional<web::Answer> refused_at_once(const web::Ask& ask) const;
  std::optional<Session> session_of(const web::Ask& ask, bool by_itself);
  bool shown_on_screen(const std::string& code);
  void tell_kiosk();
  web::Answer outside(const web::Ask& ask);
  web::Answer enter(const web::Ask& ask);
  web::Answer get(const web::Ask& ask, const Session& session);
  web::Answer post(const web::Ask& ask, const Session& session);
  web::Answer post_people(const web::Ask& ask, const Session& session);
  web::Answer state(const web::Ask& ask, const Session& session);
  web::Answer figures(const web::Ask& ask, bool picture);
  web::Answer set_passphrase(const web::Ask& ask, const Session& session);
  web::Answer people();
  web::Answer changes();
  web::Answer get_edit(const web::Ask& ask, const std::string& path);
  web::Answer post_edit(const web::Ask& ask, const Session& session);
  void note_ended();
  /// `answer`, noted as a change by `session` if it is a success.
  web::Answer noted(web::Answer answer, const web::Ask& ask, const Session& session,
                    const char* did, const std::string& what);

  Parts parts_;
  VesselTitles titles_;
  DeskAnswers desk_;
  EditAnswers edit_;
  SceneAnswers scenes_;
  ScanAnswers scans_;
  ScreenAnswers screens_;
  std::optional<Door> door_;
  std::vector<std::string> hosts_;
  souvenir::StaffNotice notice_;
  std::string scheme_, address_;
  Figures figures_;
  Patience patience_;
};

}  // namespace onggi::console
