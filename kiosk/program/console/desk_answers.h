#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/web/message.h"
#include "kiosk/program/console/site.h"
#include "kiosk/program/console/vessel_titles.h"
#include "kiosk/program/desk/kept.h"

namespace onggi::console {

/// The part of the staff's page for the desk: what visitors kept. A `visit` is the name of a
/// keepsake's folder; links are not followed, and other files of the machine are not there. One
/// thread; blocks on the disk.
class DeskAnswers {
 public:
  /// `site` and `titles` stay with the caller. `tell` gets what the staff should know of a file.
  DeskAnswers(Site& site, VesselTitles& titles, std::function<void(const Problem&)> tell)
      : site_(site), titles_(titles), tell_(std::move(tell)) {}

  /// That keepsake is there.
  bool has(const std::string& visit);
  /// JSON, newest first, at most 200: those of ?day=DAY, or with a word of ?name=.
  web::Answer keepsakes(const web::Ask& ask);
  /// A picture of it, whole or a span of its bytes.
  web::Answer picture(const web::Ask& ask, const std::string& visit, const std::string& name);
  /// A page that prints its postcard, the one with the visitor's code if there is one.
  web::Answer print_page(const std::string& visit);
  /// A page for the visitor's phone: {address, code: rows of the square code, until}.
  web::Answer give_pass(const std::string& visit, std::int64_t now);
  /// Removes every copy, and every pass.
  web::Answer remove(const std::string& visit);

 private:
  Result<void> list(const std::filesystem::path& folder);

  std::vector<souvenir::NamedVisit> called(const std::string& typed);

  Site& site_;
  VesselTitles& titles_;
  std::optional<desk::Kept> kept_;  ///< As listed when the folder had the stamp listed_.
  std::string listed_;
  std::function<void(const Problem&)> tell_;
};

}  // namespace onggi::console
