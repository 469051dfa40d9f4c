#include "kiosk/program/console/desk_answers.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <ctime>
#include <filesystem>
#include <utility>
#include <vector>

#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/keepsake/phone/sent_keepsake.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/picture/view/square_code.h"
#include "kiosk/program/console/said.h"
#include "kiosk/program/console/staff_page_files.h"
#include "kiosk/program/desk/kept.h"
#include "kiosk/program/desk/published.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;
using files::Json;

constexpr const char* kBySudo =
    "Start onggi-console with sudo, or as the user who owns the keepsakes.";
constexpr std::size_t kMostListed = 200;  // keepsakes

struct Picture {
  const char *name, *type;
};
constexpr Picture kPictures[] = {
    {souvenir::kSmall, "image/jpeg"},     {souvenir::kPostcard, "image/jpeg"},
    {souvenir::kPrint, "image/jpeg"},     {souvenir::kTurning, "image/gif"},
    {souvenir::kRollout, "image/jpeg"},   {souvenir::kSheet, "image/jpeg"},
    {souvenir::kPostcardPng, "image/png"}};
/// What is printed: the first of these that is there. The first two have the visitor's code.
constexpr std::array kPrinted{souvenir::kPrint, souvenir::kPostcardPng, souvenir::kPostcard};

/// A visit that is listed has one of these.
constexpr std::array kOurs{souvenir::kPostcard, souvenir::kPotGlb,      souvenir::kReplay,
                           souvenir::kSmall,    souvenir::kPostcardPng, souvenir::kPrint};

/// A visit's folder, as save() names them, that is there. One that holds nothing of ours is a
/// museum's own.
bool is_visit(const fs::path& keepsakes, const std::string& name) {
  std::error_code error;
  return souvenir::is_visit_name(name) && souvenir::visit_name(name) == name &&
         !name.ends_with(souvenir::kPartial) &&
         fs::symlink_status(keepsakes / name, error).type() == fs::file_type::directory &&
         std::ranges::any_of(kOurs, [&](const char* file) {
           return fs::symlink_status(keepsakes / name / file, error).type() ==
                  fs::file_type::regular;
         });
}

/// What OpenPasses wants to know of a visit to open its files.
souvenir::Pass pass_of(const std::string& visit) {
  souvenir::Pass pass;
  pass.visit = visit;
  return pass;
}

Json json_of(const view::SquareCode& code) {
  Json rows = Json::list();
  for (int y = 0; y < code.side(); ++y) {
    std::string row;
    for (int x = 0; x < code.side(); ++x) row += code.dark(x, y) ? '1' : '0';
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

bool DeskAnswers::has(const std::string& visit) {
  return is_visit(site_.exhibit().keepsake.folder, visit);
}

/// By name, by how its time begins, or by a word of its vessel, in files or on its label.
std::vector<souvenir::NamedVisit> DeskAnswers::called(const std::string& typed) {
  std::vector<souvenir::NamedVisit> found = kept_->called(typed);
  if (!found.empty()) return found;
  std::string in_files = typed;
  std::transform(in_files.begin(), in_files.end(), in_files.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const souvenir::NamedVisit& one : kept_->visits) {
    const std::string vessel = desk::vessel_of(one.visit);
    if (desk::time_of(one.visit).starts_with(typed) ||
        desk::in_words(vessel).find(in_files) != std::string::npos || titles_.has(vessel, typed))
      found.push_back(one);
  }
  return found;
}

/// Ten thousand visits take a second to list, and all who ask wait for it.
Result<void> DeskAnswers::list(const fs::path& folder) {
  struct stat info {};
  std::string stamp = folder.string() + '\n';
  if (::stat(folder.c_str(), &info) == 0)
    stamp += std::to_string(info.st_ino) + ' ' + std::to_string(info.st_mtim.tv_sec) + ' ' +
             std::to_string(info.st_mtim.tv_nsec);
  if (kept_ && stamp == listed_) return {};
  std::vector<Problem> remarks;
  auto kept = desk::open_kept({site_.file(), folder, ""}, remarks);
  if (!kept) return tl::unexpected(kept.error());
  kept_ = std::move(*kept);
  // What comes within a clock's step of the listing may not change the folder's time.
  constexpr std::time_t kStep = 2;  // s
  listed_ = std::time(nullptr) - info.st_mtim.tv_sec > kStep ? stamp : "";
  return {};
}

web::Answer DeskAnswers::keepsakes(const web::Ask& ask) {
  const std::string day = query(ask, "day"), name = query(ask, "name");
  if (!desk::is_day(day)) return refused(409, "This is not a day.", "Write it as 2026-05-31.");
  std::error_code error;
  const fs::path& folder = site_.exhibit().keepsake.folder;
  Json all = Json::list();
  // Before the first keepsake there is no folder, and that is no trouble.
  if (!fs::exists(folder, error) && !error) return json(ask, all.text(-1));
  if (const auto good = list(folder); !good)
    return refused(409, {good.error().where, good.error().what, kBySudo});
  const desk::Kept* kept = &*kept_;
  const souvenir::OpenPasses opened(folder);
  std::size_t listed = 0;
  for (const souvenir::NamedVisit& one : name.empty() ? kept->visits : called(name)) {
    if (!day.empty() && desk::day_of(one.visit) != day) continue;
    // Others could not be opened by their name.
    if (!is_visit(folder, one.visit)) continue;
    if (++listed > kMostListed) break;
    const auto has = [&](const char* file) { return opened.has_file(pass_of(one.visit), file); };
    all.push_back(Json::object({{"visit", one.visit},
                                {"day", desk::day_of(one.visit)},
                                {"time", desk::time_of(one.visit).substr(0, 5)},
                                {"name", one.spoken.empty() ? "" : kept->said(one)},
                                {"vessel", desk::in_words(desk::vessel_of(one.visit))},
                                {"titles", titles_.json_of(desk::vessel_of(one.visit))},
                                {"small", has(souvenir::kSmall)},
                                {"turning", has(souvenir::kTurning)},
                                {"sheet", has(souvenir::kSheet)},
                                {"rollout", has(souvenir::kRollout)}}));
  }
  return json(ask, all.text(-1));
}

web::Answer DeskAnswers::picture(const web::Ask& ask, const std::string& visit,
                                 const std::string& name) {
  const fs::path& folder = site_.exhibit().keepsake.folder;
  const souvenir::OpenPasses opened(folder);
  if (is_visit(folder, visit))
    for (const Picture& one : kPictures) {
      if (name != one.name) continue;
      auto file = opened.open_file(pass_of(visit), one.name);
      if (!file) break;
      if (file->remark) tell_(*file->remark);
      return web::part_of(phone::sent(std::move(*file)), one.type, ask);
    }
  return refused(404, "This picture is not here.", "Look at the list again.");
}

web::Answer DeskAnswers::print_page(const std::string& visit) {
  const fs::path& folder = site_.exhibit().keepsake.folder;
  std::error_code error;
  if (is_visit(folder, visit))
    for (const char* name : kPrinted)
      if (fs::is_regular_file(folder / visit / name, error))
        // A visit's name has letters that are safe here (visit_name()).
        return {.status = 200,
                .body = std::string(k_print_html) + "<img id=\"card\" alt=\"The postcard\" src=\"" +
                        "/keepsake/" + visit + '/' + name + "\"></body></html>"};
  return page_of(404, "There is no postcard here. It may have been deleted.");
}

web::Answer DeskAnswers::give_pass(const std::string& visit, std::int64_t now) {
  const settings::Exhibit& exhibit = site_.exhibit();
  if (exhibit.phone.address.empty())
    return refused(409, "Visitors' phones get no pages here.",
                   "An editor sets address in [phone] of exhibit.toml.");
  if (!souvenir::Passes(exhibit.keepsake.folder).served(now))
    return refused(409, "Visitors' phones get no answer: the program for phones does not run.",
                   "Start it: sudo systemctl start onggi-phone. Or print the postcard.");
  const auto pass =
      souvenir::Passes::give_at_the_desk(exhibit.keepsake.folder / visit, now, exhibit.phone.hours);
  if (!pass)
    return refused(409,
                   {pass.error().where, "No page could be made. " + pass.error().what, kBySudo});
  const std::string address = exhibit.phone.address + "/k/" + pass->token;
  return json(Json::object(
      {{"address", address},
       {"code", json_of(view::SquareCode(address))},
       {"until", files::local_time(static_cast<std::time_t>(pass->until), "%Y-%m-%d %H:%M")}}));
}

web::Answer DeskAnswers::remove(const std::string& visit) {
  const fs::path& folder = site_.exhibit().keepsake.folder;
  const auto gone = souvenir::remove_visit(folder / visit);
  std::error_code error;
  // Once its folder has another name nobody can open it, whatever is left.
  if (!fs::exists(folder / visit, error)) souvenir::Passes(folder).take_back_all(visit);
  if (!gone && !fs::exists(folder / visit, error))
    return refused(409, {gone.error().where,
                         "Nobody can open it any more, but some of its files are still in " +
                             visit + souvenir::kPartial + '.',
                         "The kiosk tries again each hour. If they stay, remove them with sudo."});
  if (!gone) return refused(409, {gone.error().where, "It could not be deleted.", kBySudo});
  return json(Json::object({{"deleted", visit}}));
}

}  // namespace onggi::console
