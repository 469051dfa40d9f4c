#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kiosk/ground/files/log.h"
#include "kiosk/ground/web/message.h"
#include "kiosk/program/console/door.h"
#include "kiosk/program/console/figures.h"
#include "kiosk/program/console/file_check.h"
#include "kiosk/program/console/site.h"

namespace onggi::console {

/// The staff's page of one exhibit. Whoever has no session (Door) gets a page that says how to come
/// in, and 401 for all else.
///   GET  /                       the page
///   GET  /?code=CODE             in, by the code of the printed address
///   GET  /api/state              how the kiosk is, in words
///   GET  /api/files              what onggi check says
///   GET  /api/figures?from=&to=  what visitors did, small cells left out
///   GET  /figures.svg?from=&to=  the same as a picture
///   GET  /api/keepsakes?day=DAY, ?name=WORDS      what was kept, newest first
///   GET  /keepsake/VISIT/FILE    one of its pictures
///   GET  /print/VISIT            a page that prints the postcard
///   POST /api/keepsakes/VISIT/pass    a page for the visitor's phone
///   POST /api/keepsakes/VISIT/delete  every copy, for good
///   POST /api/leave              ends the session
/// A POST needs a JSON body, and the page's own address as its Origin. A Host that is not one of
/// the program's is refused, so that no other site's name can lead here. One thread.
class StaffAnswers final : public web::Answering {
 public:
  /// Refuses everything until open(). `clock` gives s since 1970. `tell` gets what the staff should
  /// know of a file.
  StaffAnswers(Site site, FileCheck check, std::function<std::int64_t()> clock,
               std::function<void(const Problem&)> tell = files::log_problem)
      : site_(std::move(site)),
        check_(std::move(check)),
        clock_(std::move(clock)),
        tell_(std::move(tell)) {}
  /// `hosts`: the Host fields that are accepted, "127.0.0.1:8090".
  void open(Door door, std::vector<std::string> hosts) {
    door_ = std::move(door);
    hosts_ = std::move(hosts);
  }

  web::Answer to(const web::Ask& ask) override;
  /// After open().
  const Door& door() const { return *door_; }

 private:
  web::Answer get(const web::Ask& ask);
  web::Answer post(const web::Ask& ask);
  web::Answer state(const web::Ask& ask);
  web::Answer figures(const web::Ask& ask, bool picture);
  web::Answer keepsakes(const web::Ask& ask);
  web::Answer picture(const web::Ask& ask, const std::string& visit, const std::string& name);
  web::Answer print_page(const std::string& visit);
  web::Answer give_pass(const std::string& visit);
  web::Answer remove(const std::string& visit);

  Site site_;
  FileCheck check_;
  std::function<std::int64_t()> clock_;
  std::function<void(const Problem&)> tell_;
  std::optional<Door> door_;
  std::vector<std::string> hosts_;
  Figures figures_;
};

}  // namespace onggi::console
