#include "kiosk/program/console/staff_answers.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <string_view>
#include <utility>

#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/keepsake/phone/sent_keepsake.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/keepsake/store/figures_report.h"
#include "kiosk/picture/drawing/plot.h"
#include "kiosk/picture/view/square_code.h"
#include "kiosk/program/console/staff_page_files.h"
#include "kiosk/program/console/state_report.h"
#include "kiosk/program/desk/kept.h"
#include "kiosk/program/desk/published.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;
using files::Json;

constexpr const char* kJson = "application/json; charset=utf-8";
constexpr std::size_t kMostListed = 200;  // keepsakes

struct PageFile {
  const char *name, *type, *text;
};
const PageFile kPageFiles[] = {{"/staff.js", "text/javascript; charset=utf-8", k_staff_js},
                               {"/print.js", "text/javascript; charset=utf-8", k_print_js},
                               {"/staff.css", "text/css; charset=utf-8", k_staff_css},
                               {"/staff.svg", "image/svg+xml", k_staff_svg}};

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

/// JSON with a tag, or 304 where the browser has this one.
web::Answer json(const web::Ask& ask, const std::string& text) {
  const std::string tag = '"' + std::to_string(std::hash<std::string>{}(text)) + '"';
  web::Answer answer{.status = 200, .type = kJson, .body = text};
  if (ask.if_none_match == tag) answer = {.status = 304, .type = ""};
  answer.fields = {{"ETag", tag}};
  return answer;
}

web::Answer json(const Json& value) {
  return {.status = 200, .type = kJson, .body = value.text(-1)};
}

web::Answer refused(int status, const Problem& p) {
  return {
      .status = status,
      .type = kJson,
      .body = Json::object({{"where", p.where}, {"what", p.what}, {"remedy", p.remedy}}).text(-1)};
}

web::Answer refused(int status, const char* what, const char* remedy) {
  return refused(status, Problem{"", what, remedy});
}

/// A day or a name as a query writes it: '+' and %20 are blanks.
std::string decoded(std::string_view text) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  std::string out;
  for (std::size_t n = 0; n < text.size(); ++n) {
    const int high = text[n] == '%' && n + 2 < text.size() ? digit(text[n + 1]) : -1;
    const int low = high >= 0 ? digit(text[n + 2]) : -1;
    if (low >= 0) {
      out += static_cast<char>(16 * high + low);
      n += 2;
    } else {
      out += text[n] == '+' ? ' ' : text[n];
    }
  }
  return out;
}

std::string query(const web::Ask& ask, std::string_view name) {
  return decoded(web::asked_for(ask.target, name));
}

/// The parts of "/keepsake/VISIT/FILE".
std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> parts;
  while (!path.empty()) {
    path.remove_prefix(1);
    const std::size_t end = std::min(path.find('/'), path.size());
    parts.emplace_back(path.substr(0, end));
    path.remove_prefix(end);
  }
  return parts;
}

/// A visit's folder, as save() names them, that is there.
bool is_visit(const fs::path& keepsakes, const std::string& name) {
  std::error_code error;
  return souvenir::is_visit_name(name) && souvenir::visit_name(name) == name &&
         !name.ends_with(souvenir::kPartial) &&
         fs::symlink_status(keepsakes / name, error).type() == fs::file_type::directory;
}

/// What OpenPasses wants to know of a visit to open its files.
souvenir::Pass pass_of(const std::string& visit) {
  souvenir::Pass pass;
  pass.visit = visit;
  return pass;
}

std::string in_words(std::string id) {
  std::replace(id.begin(), id.end(), '_', ' ');
  return id;
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

web::Answer StaffAnswers::to(const web::Ask& ask) {
  if (std::ranges::find(hosts_, ask.host) == hosts_.end())
    return {.status = 421,
            .type = "text/plain; charset=utf-8",
            .body =
                "This page is not served under this name. Use the address that onggi-console "
                "printed.\n"};
  const bool reads = ask.method == "GET" || ask.method == "HEAD";
  if (reads)
    for (const auto& [name, type, text] : kPageFiles)
      if (ask.target == name) return {.status = 200, .type = type, .body = text};
  const std::int64_t now = clock_();
  if (ask.method == "GET" && ask.target.starts_with("/?code="))
    if (const std::string cookie = door_->enter(web::asked_for(ask.target, "code"), now);
        !cookie.empty())
      // Without the code, which is no longer good.
      return {.status = 303, .type = "", .fields = {{"Location", "/"}, {"Set-Cookie", cookie}}};
  if (!door_->knows(ask, now)) {
    if (reads && (ask.target == "/" || ask.target.starts_with("/?")))
      return {.status = 401, .body = k_door_html};
    return refused(401, "You are not signed in, or not any more.",
                   "Start onggi-console again, and open the address that it prints.");
  }
  if (reads) return get(ask);
  if (ask.method == "POST") return post(ask);
  return refused(405, "This cannot be done here.", "Use the page.");
}

web::Answer StaffAnswers::get(const web::Ask& ask) {
  const std::string path = ask.target.substr(0, ask.target.find('?'));
  if (path == "/") return {.status = 200, .body = k_staff_html};
  if (path == "/api/state") return state(ask);
  if (path == "/api/files") return json(ask, check_.json());
  if (path == "/api/figures") return figures(ask, false);
  if (path == "/figures.svg") return figures(ask, true);
  if (path == "/api/keepsakes") return keepsakes(ask);
  const auto parts = parts_of(path);
  if (parts.size() == 3 && parts[0] == "keepsake") return picture(ask, parts[1], parts[2]);
  if (parts.size() == 2 && parts[0] == "print") return print_page(parts[1]);
  return refused(404, "There is no such page.", "Go back to the first one.");
}

web::Answer StaffAnswers::post(const web::Ask& ask) {
  // Another site can send a form here, but neither of these.
  if (ask.origin != "http://" + ask.host && ask.origin != "https://" + ask.host)
    return refused(403, "This came from another page.", "Use the page itself.");
  if (!ask.type.starts_with("application/json"))
    return refused(415, "Changes are sent as JSON.", "Use the page itself.");
  if (ask.target == "/api/leave")
    return {
        .status = 200, .type = kJson, .body = "{}", .fields = {{"Set-Cookie", door_->leave(ask)}}};
  const auto parts = parts_of(ask.target);
  if (parts.size() == 4 && parts[0] == "api" && parts[1] == "keepsakes") {
    if (!is_visit(site_.exhibit().keepsake.folder, parts[2]))
      return refused(404, "This keepsake is not here any more.", "Look at the list again.");
    if (parts[3] == "pass") return give_pass(parts[2]);
    if (parts[3] == "delete") return remove(parts[2]);
  }
  return refused(404, "This cannot be done here.", "Use the page.");
}

web::Answer StaffAnswers::state(const web::Ask& ask) {
  const settings::Exhibit& exhibit = site_.exhibit();
  const fs::path& folder = exhibit.keepsake.folder;
  Known known;
  known.kiosk = watch::look_at_kiosk(folder);
  known.now = clock_();
  known.exhibit = site_.file().string();
  if (known.kiosk.state) known.vessel = in_words(known.kiosk.state->vessel);
  std::error_code error;
  // The kiosk makes the folder at its first start.
  const bool there = fs::exists(folder, error);
  if (const auto space = fs::space(there ? folder : site_.file().parent_path(), error); !error)
    known.free_bytes = space.available;
  if (!exhibit.phone.address.empty())
    known.phones_answered = souvenir::Passes(folder).served(known.now);
  Json out = json_of(report_of(known));
  out["title"] = site_.title();
  out["credit"] = exhibit.credit;
  out["exhibit"] = site_.file().string();
  out["keepsakes"] = folder.string();
  out["phones"] = !exhibit.phone.address.empty();
  out["today"] = files::local_time(static_cast<std::time_t>(known.now), files::kDay);
  return json(ask, out.text(-1));
}

web::Answer StaffAnswers::figures(const web::Ask& ask, bool picture) {
  std::error_code error;
  // The first visit makes the store.
  if (!picture && !fs::exists(files::store_file(site_.exhibit().keepsake.folder), error) && !error)
    return json(ask, R"({"visits": 0, "words": "No visit has been counted here yet."})");
  const auto told =
      figures_.of(site_.exhibit().keepsake.folder, query(ask, "from"), query(ask, "to"), clock_());
  if (!told) return refused(picture ? 404 : 409, told.error());
  if (!picture) {
    Json out = store::json_of(**told);
    out["words"] = store::words_of(**told);
    return json(ask, out.text(-1));
  }
  const auto bytes = drawing::draw_plot(desk::plot_of(**told), "figures.svg");
  return {.status = 200,
          .type = "image/svg+xml",
          .body = std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size())};
}

web::Answer StaffAnswers::keepsakes(const web::Ask& ask) {
  const std::string day = query(ask, "day"), name = query(ask, "name");
  if (!desk::is_day(day)) return refused(409, "This is not a day.", "Write it as 2026-05-31.");
  std::vector<Problem> remarks;
  std::error_code error;
  const fs::path& folder = site_.exhibit().keepsake.folder;
  Json list = Json::list();
  // Before the first keepsake there is no folder, and that is no trouble.
  if (!fs::exists(folder, error) && !error) return json(ask, list.text(-1));
  const auto kept = desk::open_kept({site_.file(), folder, ""}, remarks);
  if (!kept) return refused(409, kept.error());
  const souvenir::OpenPasses opened(folder);
  std::size_t listed = 0;
  for (const souvenir::NamedVisit& one : name.empty() ? kept->visits : kept->called(name)) {
    if (!day.empty() && desk::day_of(one.visit) != day) continue;
    if (++listed > kMostListed) break;
    const auto has = [&](const char* file) { return opened.has_file(pass_of(one.visit), file); };
    list.push_back(Json::object({{"visit", one.visit},
                                 {"day", desk::day_of(one.visit)},
                                 {"time", desk::time_of(one.visit).substr(0, 5)},
                                 {"name", one.spoken.empty() ? "" : kept->said(one)},
                                 {"vessel", in_words(desk::vessel_of(one.visit))},
                                 {"small", has(souvenir::kSmall)},
                                 {"turning", has(souvenir::kTurning)},
                                 {"sheet", has(souvenir::kSheet)},
                                 {"rollout", has(souvenir::kRollout)}}));
  }
  return json(ask, list.text(-1));
}

web::Answer StaffAnswers::picture(const web::Ask& ask, const std::string& visit,
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

web::Answer StaffAnswers::print_page(const std::string& visit) {
  const fs::path& folder = site_.exhibit().keepsake.folder;
  std::error_code error;
  if (is_visit(folder, visit))
    for (const char* name : kPrinted)
      if (fs::is_regular_file(folder / visit / name, error))
        // A visit's name has letters that are safe here (visit_name()).
        return {.status = 200,
                .body = std::string(k_print_html) + "<img id=\"card\" alt=\"The postcard\" src=\"" +
                        "/keepsake/" + visit + '/' + name + "\"></body></html>"};
  return refused(404, "There is no postcard here.", "Look at the list again.");
}

web::Answer StaffAnswers::give_pass(const std::string& visit) {
  const settings::Exhibit& exhibit = site_.exhibit();
  if (exhibit.phone.address.empty())
    return refused(409, "Visitors' phones get no pages here.",
                   "Set address in [phone] of exhibit.toml: kiosk/docs/phone.md says how.");
  const std::int64_t now = clock_();
  const auto pass =
      souvenir::Passes::give_at_the_desk(exhibit.keepsake.folder / visit, now, exhibit.phone.hours);
  if (!pass) return refused(pass.error().exit_code == 1 ? 500 : 409, pass.error());
  const std::string address = exhibit.phone.address + "/k/" + pass->token;
  return json(Json::object(
      {{"address", address},
       {"code", json_of(view::SquareCode(address))},
       {"until", files::local_time(static_cast<std::time_t>(pass->until), "%Y-%m-%d %H:%M")}}));
}

web::Answer StaffAnswers::remove(const std::string& visit) {
  const fs::path& folder = site_.exhibit().keepsake.folder;
  if (const auto gone = souvenir::remove_visit(folder / visit); !gone)
    return refused(500, gone.error());
  souvenir::Passes(folder).take_back_all(visit);
  return json(Json::object({{"deleted", visit}}));
}

}  // namespace onggi::console
