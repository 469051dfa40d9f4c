#pragma once

#include <optional>
#include <string>

#include "kiosk/ground/web/message.h"
#include "kiosk/program/console/change_log.h"
#include "kiosk/program/console/scan_inbox.h"
#include "kiosk/program/console/site.h"

namespace onggi::console {

/// The part of the staff's page where a scan becomes a vessel. One thread; reads the disk, and
/// leaves reading and writing of scans to the program `onggi`.
class ScanAnswers {
 public:
  /// `site` stays with the caller.
  ScanAnswers(Site& site, ScanInbox inbox) : site_(site), inbox_(std::move(inbox)) {}

  /// Where the body of a request goes that brings a file.
  web::BodyPlace place_for_file() { return inbox_.place_for_file(); }
  /// A file arrived: ?name=NAME, and &first=1 where it begins another scan, else &scan= the
  /// number of the one that it belongs to. Answers {took, scan}.
  web::Answer took(const web::Ask& ask);
  /// What has arrived and what became of it: ScanInbox::json().
  web::Answer state(const web::Ask& ask);
  /// `act`: "look", "forget", or "place" with the body {vessel, id, turned_over, height_mm}; in
  /// each `scan`, the number of the scan that is meant. 202 where it has begun, 412 for another
  /// scan.
  web::Answer act(const std::string& act, const web::Ask& ask, const std::string& who,
                  std::int64_t now);
  bool under_way() const { return inbox_.under_way(); }
  /// The vessel that came onto the shelf since the last call: for the log.
  std::optional<ChangeLog::Change> ended();

 private:
  web::Answer place(const web::Ask& ask);

  Site& site_;
  ScanInbox inbox_;
  ChangeLog::Change note_;
};

}  // namespace onggi::console
