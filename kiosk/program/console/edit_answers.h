#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "kiosk/collection/content/pack.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/web/message.h"
#include "kiosk/program/console/change_log.h"
#include "kiosk/program/console/change_on_trial.h"
#include "kiosk/program/console/edited_file.h"
#include "kiosk/program/console/onggi_process.h"
#include "kiosk/program/console/site.h"
#include "kiosk/program/console/vessel_sheets.h"

namespace onggi::console {

/// The part of the staff's page where editors change files. One thread; reads the disk, and leaves
/// writing to `onggi`. A file is meant by a tag of its bytes, so that nobody's change is lost.
class EditAnswers {
 public:
  /// `site` stays with the caller. `onggi`: the program that writes.
  /// `sheets`: a folder for drawn sheets. `trial`: a file for the change that is tried.
  EditAnswers(Site& site, const std::filesystem::path& onggi, std::filesystem::path sheets,
              std::filesystem::path trial)
      : site_(site), saver_(onggi), sheets_(onggi, std::move(sheets)), trial_(std::move(trial)) {}

  /// {file, tag, values: all of its TOML, fields, languages: codes of those that there are, gaps:
  /// [{key, what}] that its reader finds}
  web::Answer file(const web::Ask& ask, const std::string& name);
  /// `body`: {changes: [[key, value], ...]}; {faults: [{key, what, remedy}]}
  web::Answer check(const std::string& name, const std::string& body);
  /// `body`: {tag, changes, try}. 202 where it has begun; 409 with faults, 412 for another tag.
  /// With try: true it is taken back by itself after ChangeOnTrial::kLasts.
  web::Answer save(const web::Ask& ask, const std::string& name, const std::string& who,
                   std::int64_t now);
  /// Takes back the newest change, or only forgets it. `body`: {id, forget}; if another one is the
  /// newest, nothing is done.
  web::Answer undo(const web::Ask& ask, const std::string& who, std::int64_t now);
  /// {under_way, said: what `onggi set` or `undo` printed} of the change ?number=; of the last
  /// kRemembered.
  web::Answer saved(const web::Ask& ask);
  static constexpr std::size_t kRemembered = 16;
  /// The changes that can be taken back, newest first: [{id, when, file, words}]
  web::Answer revisions(const web::Ask& ask);
  /// The shelf in its order: [{id, titles: by language, hidden, unfinished, outline: it is drawn}]
  web::Answer shelf(const web::Ask& ask);
  /// The sheet of the vessel `id`, a PNG; 202 with JSON while it is drawn.
  web::Answer sheet(const web::Ask& ask, const std::string& id);
  /// The vessel `id` from the side, as it was drawn; 404 where there is no drawing.
  web::Answer outline(const web::Ask& ask, const std::string& id);
  /// A change is being made.
  bool under_way() const { return saver_.under_way(); }
  /// The change that has ended since the last call and was made: for the log. Call it often: what
  /// is tried is taken back by it.
  std::optional<ChangeLog::Change> ended(std::int64_t now);
  /// {left: s, what} of the change that is tried, {trouble} of one that could not be taken back;
  /// else null.
  files::Json trial(std::int64_t now) const;
  /// Keeps what is tried (`act` "keep"), or takes it back now ("back").
  web::Answer end_trial(const web::Ask& ask, const std::string& act, const std::string& who,
                        std::int64_t now);

 private:
  std::optional<web::Answer> refused_while_trying() const;
  bool has_outline(const std::string& id, const content::Pack& pack);
  web::Answer take_trial_back(std::int64_t now, const std::string& who, const std::string& from);
  web::Answer begin(std::vector<std::string> arguments, ChangeLog::Change note);

  Site& site_;
  OnggiProcess saver_;
  VesselSheets sheets_;
  ChangeOnTrial trial_;
  static constexpr std::int64_t kLongAgo = -1'000'000;
  bool trying_ = false;                  // the change under way is to be tried
  bool ending_trial_ = false;            // it takes back the one that is tried
  std::int64_t put_back_at_ = kLongAgo;  ///< When the last trial was, s since 1970.
  std::string trial_trouble_;
  int number_ = 0;
  std::map<int, std::string> said_;  ///< By number.
  ChangeLog::Change note_;
};

}  // namespace onggi::console
