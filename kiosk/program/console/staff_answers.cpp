#include "kiosk/program/console/staff_answers.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <iterator>
#include <string_view>
#include <thread>
#include <utility>

#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/secrets/digest.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/keepsake/store/figures_report.h"
#include "kiosk/picture/drawing/plot.h"
#include "kiosk/program/console/said.h"
#include "kiosk/program/console/staff_page_files.h"
#include "kiosk/program/console/state_report.h"
#include "kiosk/program/desk/kept.h"
#include "kiosk/program/desk/published.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;
using files::Json;

constexpr std::size_t kMostShown = 200;  // changes

struct PageFile {
  const char *name, *type, *text;
};
constexpr const char* kScript = "text/javascript; charset=utf-8";
const PageFile kPageFiles[] = {{"/base.js", kScript, k_base_js},
                               {"/edit.js", kScript, k_edit_js},
                               {"/settings.js", kScript, k_settings_js},
                               {"/shelf.js", kScript, k_shelf_js},
                               {"/scan.js", kScript, k_scan_js},
                               {"/lists.js", kScript, k_lists_js},
                               {"/scenes.js", kScript, k_scenes_js},
                               {"/words.js", kScript, k_words_js},
                               {"/look.js", kScript, k_look_js},
                               {"/staff.js", kScript, k_staff_js},
                               {"/print.js", kScript, k_print_js},
                               {"/door.js", kScript, k_door_js},
                               {"/staff.css", "text/css; charset=utf-8", k_staff_css},
                               {"/staff.svg", "image/svg+xml", k_staff_svg}};

constexpr const char* kEdit = "/api/edit/";
constexpr const char* kPrices = "/api/prices/";

constexpr const char* kTrial = "/api/trial/";
constexpr const char* kScan = "/api/scan";
constexpr const char* kSheet = "/sheet/";
constexpr const char *kScreens = "/api/screen", *kScreenPicture = "/screen/";
constexpr const char* kFile = "application/octet-stream";

bool is_read(const web::Ask& ask) { return ask.method == "GET" || ask.method == "HEAD"; }

/// True of a file of a scan.
bool brings_file(const web::Ask& ask) {
  return ask.method == "POST" && ask.target.substr(0, ask.target.find('?')) == "/api/upload";
}

/// True of what editors alone see and do.
bool is_of_editors(const std::string& path) {
  constexpr const char* kEditorsFolders[] = {kScan,  "/api/upload", kEdit,    kPrices,
                                             kSheet, kTrial,        kScreens, kScreenPicture};
  constexpr const char* kEditorsOwn[] = {"/api/scenes", "/api/shelf", "/api/revisions",
                                         "/api/saved", "/api/undo"};
  return std::ranges::any_of(kEditorsFolders,
                             [&](const char* one) { return path.starts_with(one); }) ||
         std::ranges::find(kEditorsOwn, path) != std::end(kEditorsOwn);
}

web::Answer not_an_editor() { return refused(403, "This is for editors.", "Ask one of them."); }

}  // namespace

/// Why it is not looked at, whoever asks.
std::optional<web::Answer> StaffAnswers::refused_at_once(const web::Ask& ask) const {
  if (std::ranges::find(hosts_, ask.host) == hosts_.end())
    return web::Answer{
        .status = 421,
        .type = "text/plain; charset=utf-8",
        .body =
            "This page is not served under this name. Use the address that onggi-console "
            "printed.\n"};
  if (is_read(ask)) return std::nullopt;
  if (ask.method != "POST") return refused(405, "This cannot be done here.", "Use the page.");
  // Another site can send a form here, but neither of these.
  if (ask.origin != scheme_ + ask.host)
    return refused(403, "This came from another page.", "Use the page itself.");
  if (!(brings_file(ask) ? ask.type == kFile : ask.type.starts_with("application/json")))
    return refused(415, "Changes are sent as JSON, and files as they are.", "Use the page itself.");
  return std::nullopt;
}

/// Who asks; none where nobody has come in.
std::optional<Session> StaffAnswers::session_of(const web::Ask& ask, bool by_itself) {
  const Session* session = door_->session_of(ask, parts_.clock(), by_itself);
  if (session == nullptr) return std::nullopt;
  // Another program may have changed that, or a hand with an editor.
  if (session->who != Session::kByCode && parts_.people.role_now(session->who) != session->role) {
    door_->end_all_of(std::string(session->who));
    return std::nullopt;
  }
  return *session;  // a copy: what is done may end it
}

web::BodyPlace StaffAnswers::place_for_body(const web::Ask& head) {
  if (!brings_file(head)) return web::IntoMemory{};
  if (auto no = refused_at_once(head)) return std::move(*no);
  const auto session = session_of(head, false);
  if (!session) return outside(head);
  if (session->role != Role::editor) return not_an_editor();
  return scans_.place_for_file();
}

web::Answer StaffAnswers::refusal(int status, const Problem& why) { return refused(status, why); }

web::Answer StaffAnswers::to(const web::Ask& ask) {
  if (auto no = refused_at_once(ask)) return std::move(*no);
  note_ended();
  const bool reads = is_read(ask);
  if (reads)
    for (const auto& [name, type, text] : kPageFiles)
      if (ask.target == name) return {.status = 200, .type = type, .body = text};
  if (reads)
    if (auto words = parts_.words.to(ask)) return std::move(*words);
  if (ask.method == "GET" && ask.target.starts_with("/?code=")) {
    const std::string code = web::asked_for(ask.target, "code");
    std::string cookie = door_->enter(code, parts_.clock());
    if (cookie.empty() && shown_on_screen(code))
      cookie = door_->admit(Session::kByCode, Role::editor, parts_.clock());
    // Without the code, which is no longer good.
    if (!cookie.empty())
      return {.status = 303, .type = "", .fields = {{"Location", "/"}, {"Set-Cookie", cookie}}};
  }
  // What the page asks by itself does not say that somebody is here.
  const bool by_itself = reads && web::asked_for(ask.target, "alone") == "1";
  const auto session = session_of(ask, by_itself);
  if (!session) return outside(ask);
  return reads ? get(ask, *session) : post(ask, *session);
}

/// By the kiosk, to whoever held a corner of it. Only until somebody has a name, and once.
bool StaffAnswers::shown_on_screen(const std::string& code) {
  const auto people = parts_.people.all();
  if (!people || !people->empty()) return false;
  const watch::SeenKiosk kiosk = watch::look_at_kiosk(parts_.site.exhibit().keepsake.folder);
  if (!kiosk.runs || !kiosk.state) return false;
  const std::string& shown = kiosk.state->way_in;
  const std::int64_t left = kiosk.state->way_in_until - parts_.clock();
  if (left <= 0 || left > souvenir::kWayInLasts || shown.empty() ||
      !secrets::same_secret(shown, secrets::digest_of(code)))
    return false;
  return door_->use_once(shown);
}

/// Tells the kiosk whether it may show a way in.
void StaffAnswers::tell_kiosk() {
  const auto people = parts_.people.all();
  if (!people || !people->empty())
    notice_.take_away();
  else
    static_cast<void>(notice_.put_up(address_));  // where the disk refuses, sudo's code is the way
}

web::Answer StaffAnswers::outside(const web::Ask& ask) {
  if (ask.target == "/api/enter" && ask.method == "POST") return enter(ask);
  if (ask.method != "POST" && ask.target == "/api/door") {
    const auto people = parts_.people.all();
    return json(Json::object({{"names", !people || !people->empty()}}));
  }
  const bool page = !ask.target.starts_with("/api/") && !ask.target.starts_with("/keepsake/") &&
                    !ask.target.starts_with("/figures.svg");
  if (ask.method != "POST" && page) return {.status = 401, .body = k_door_html};
  return refused(401, "You are not signed in, or not any more.", "Sign in again.");
}

web::Answer StaffAnswers::enter(const web::Ask& ask) {
  const Words words(ask.body);
  const std::string name = words["name"];
  const std::int64_t now = parts_.clock();
  if (const std::int64_t wait = patience_.wait(name, ask.from, now); wait > 0) {
    constexpr std::int64_t kMoment = 10;  // s
    web::Answer later =
        wait < kMoment ? refused(429, "That was wrong before.", "Wait a moment, and try again.")
                       : refused(429, "That was wrong before.", "Wait a minute, and try again.");
    later.fields = {{"Retry-After", std::to_string(wait)}};
    return later;
  }
  const auto role = parts_.people.role_with(name, words["passphrase"]);
  if (!role) return refused(500, role.error());
  if (!*role) {
    patience_.wrong(name, ask.from, now);
    return refused(401, "This name and passphrase do not belong together.",
                   "Try again. If you forgot it, ask an editor for another.");
  }
  patience_.right(name, ask.from);
  const std::string cookie = door_->admit(name, **role, now);
  if (cookie.empty()) return refused(500, "The machine gives no random numbers.", "Restart it.");
  return {.status = 200, .type = kJson, .body = "{}", .fields = {{"Set-Cookie", cookie}}};
}

web::Answer StaffAnswers::get(const web::Ask& ask, const Session& session) {
  const std::string path = ask.target.substr(0, ask.target.find('?'));
  if (path == "/") return {.status = 200, .body = k_staff_html};
  if (path == "/api/state") return state(ask, session);
  if (path == "/api/files") return json(ask, parts_.check.json());
  if (path == "/api/figures") return figures(ask, false);
  if (path == "/figures.svg") return figures(ask, true);
  if (path == "/api/keepsakes") return desk_.keepsakes(ask);
  const auto parts = parts_of(path);
  if (parts.size() == 3 && parts[0] == "keepsake") return desk_.picture(ask, parts[1], parts[2]);
  if (parts.size() == 2 && parts[0] == "outline") return edit_.outline(ask, decoded(parts[1]));
  if (parts.size() == 2 && parts[0] == "print") return desk_.print_page(parts[1]);
  if (path == "/api/people" || path == "/api/changes" || is_of_editors(path)) {
    if (session.role != Role::editor) return not_an_editor();
    if (is_of_editors(path)) return get_edit(ask, path);
    return path == "/api/people" ? people() : changes();
  }
  if (path.starts_with("/api/"))
    return refused(404, "There is no such thing.", "Load this page again.");
  return page_of(404, "There is no such page.");
}

web::Answer StaffAnswers::post(const web::Ask& ask, const Session& session) {
  if (ask.target == "/api/leave")
    return {
        .status = 200, .type = kJson, .body = "{}", .fields = {{"Set-Cookie", door_->leave(ask)}}};
  if (ask.target == "/api/enter") return enter(ask);  // in another tab
  if (ask.target == "/api/passphrase")
    return noted(set_passphrase(ask, session), ask, session, "changed passphrase", session.who);
  const auto parts = parts_of(ask.target);
  if (parts.size() == 4 && parts[0] == "api" && parts[1] == "keepsakes") {
    if (!desk_.has(parts[2]))
      return refused(404, "This keepsake is not here any more.", "Look at the list again.");
    if (parts[3] == "pass")
      return noted(desk_.give_pass(parts[2], parts_.clock()), ask, session, "gave a pass",
                   parts[2]);
    if (parts[3] == "delete")
      return noted(desk_.remove(parts[2]), ask, session, "deleted keepsake", parts[2]);
  }
  if (is_of_editors(ask.target))
    return session.role == Role::editor ? post_edit(ask, session) : not_an_editor();
  if (parts.size() >= 2 && parts[0] == "api" && parts[1] == "people")
    return session.role == Role::editor ? post_people(ask, session) : not_an_editor();
  return refused(404, "This cannot be done here.", "Use the page.");
}

web::Answer StaffAnswers::noted(web::Answer answer, const web::Ask& ask, const Session& session,
                                const char* did, const std::string& what) {
  if (answer.status != 200) return answer;
  // It is done. That it could not be noted is the staff's to know, and undoes nothing.
  if (auto added = parts_.changes.add({parts_.clock(), session.who, ask.from, did, what}); !added)
    parts_.tell(added.error());
  return answer;
}

web::Answer StaffAnswers::set_passphrase(const web::Ask& ask, const Session& session) {
  const Words words(ask.body);
  const std::int64_t now = parts_.clock();
  // Whoever tries at the door from the same address keeps nobody waiting here.
  const std::string here = session.who + " (in)";
  if (patience_.wait(here, ask.from, now) > 0)
    return refused(429, "That was wrong before.", "Wait a minute, and try again.");
  const auto role = parts_.people.role_with(session.who, words["old"]);
  if (!role) return refused(500, role.error());
  if (!*role) {
    patience_.wrong(here, ask.from, now);
    return refused(409, "The old passphrase is another.", "Try again.");
  }
  if (auto set = parts_.people.set(session.who, **role, words["new"]); !set)
    return refused(set.error());
  door_->end_all_of(session.who);
  const std::string cookie = door_->admit(session.who, **role, now);
  return {.status = 200, .type = kJson, .body = "{}", .fields = {{"Set-Cookie", cookie}}};
}

web::Answer StaffAnswers::people() {
  const auto all = parts_.people.all();
  if (!all) return refused(500, all.error());
  Json list = Json::list();
  for (const Person& one : *all)
    list.push_back(Json::object({{"name", one.name}, {"role", name_of(one.role)}}));
  return json(list);
}

web::Answer StaffAnswers::post_people(const web::Ask& ask, const Session& session) {
  const auto parts = parts_of(ask.target);
  if (parts.size() == 4 && parts[3] == "remove") {
    if (auto removed = parts_.people.remove(parts[2]); !removed) return refused(removed.error());
    door_->end_all_of(parts[2]);
    tell_kiosk();
    return noted(json(Json::object()), ask, session, "removed person", parts[2]);
  }
  if (parts.size() != 2) return refused(404, "This cannot be done here.", "Use the page.");
  const Words words(ask.body);
  const std::string name = words["name"];
  const auto role = role_of(words["role"]);
  if (!role) return refused(409, "This is no role.", "Take desk or editor.");
  const auto before = parts_.people.role_now(name);
  if (before && words["add"] == "yes")
    return refused(409, "There is somebody of this name already.",
                   "Take another name, or choose Change beside that one.");
  if (auto set = parts_.people.set(name, *role, words["passphrase"]); !set)
    return refused(set.error());
  // Whoever was signed in by the old passphrase or with the old role comes in anew.
  door_->end_all_of(name);
  tell_kiosk();
  const char* did = !before                       ? "added person"
                    : words["passphrase"].empty() ? "gave a role"
                                                  : "gave a passphrase";
  return noted(json(Json::object()), ask, session, did, name + " (" + name_of(*role) + ')');
}

web::Answer StaffAnswers::changes() {
  std::string lines;
  for (const std::string& line : parts_.changes.newest(kMostShown))
    lines += (lines.empty() ? "" : ",") + line;
  return {.status = 200, .type = kJson, .body = '[' + lines + ']'};
}

web::Answer StaffAnswers::get_edit(const web::Ask& ask, const std::string& path) {
  if (path == "/api/shelf") return edit_.shelf(ask);
  if (path == "/api/revisions") return edit_.revisions(ask);
  if (path == "/api/saved") return edit_.saved(ask);
  if (path == kScan) return scans_.state(ask);
  if (path.starts_with(kSheet))
    return edit_.sheet(ask, decoded(path.substr(std::string_view(kSheet).size())));
  if (path == kScreens) return screens_.drawn(ask);
  if (const auto parts = parts_of(path); path.starts_with(kScreenPicture) && parts.size() == 3)
    return screens_.picture(parts[1], parts[2]);
  if (path == "/api/scenes") return scenes_.scenes(ask);
  if (path.starts_with(kPrices))
    return scenes_.prices(ask, decoded(path.substr(std::string_view(kPrices).size())));
  return path.starts_with(kEdit)
             ? edit_.file(ask, decoded(path.substr(std::string_view(kEdit).size())))
             : refused(404, "There is no such thing.", "Load this page again.");
}

web::Answer StaffAnswers::post_edit(const web::Ask& ask, const Session& session) {
  if (ask.target == "/api/undo") return edit_.undo(ask, session.who, parts_.clock());
  if (brings_file(ask)) return scans_.took(ask);
  if (ask.target == kScreens) return screens_.draw(ask);
  if (ask.target == std::string(kScreens) + "/stop") return screens_.stop();
  if (ask.target.starts_with(kTrial))
    return edit_.end_trial(ask, ask.target.substr(std::string_view(kTrial).size()), session.who,
                           parts_.clock());
  if (ask.target.starts_with(std::string(kScan) + '/'))
    return scans_.act(ask.target.substr(std::string_view(kScan).size() + 1), ask, session.who,
                      parts_.clock());
  if (ask.target.starts_with(kPrices))
    return scenes_.measure(decoded(ask.target.substr(std::string_view(kPrices).size())));
  const std::size_t last = ask.target.rfind('/'), first = std::string_view(kEdit).size();
  if (last <= first) return refused(404, "This cannot be done here.", "Use the page.");
  const std::string name = decoded(ask.target.substr(first, last - first)),
                    act = ask.target.substr(last);
  if (act == "/check") return edit_.check(name, ask.body);
  if (act == "/save") return edit_.save(ask, name, session.who, parts_.clock());
  return refused(404, "This cannot be done here.", "Use the page.");
}

void StaffAnswers::note_ended() {
  for (const auto& change : {edit_.ended(parts_.clock()), scans_.ended()})
    if (change)
      if (auto added = parts_.changes.add(*change); !added) parts_.tell(added.error());
}

void StaffAnswers::end() {
  constexpr int kTurns = 200;  // 20 s: long enough for most exhibits
  for (int n = 0; n < kTurns && (edit_.under_way() || scans_.under_way()); ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  note_ended();
}

void StaffAnswers::look_after() {
  note_ended();
  tell_kiosk();
  if (auto forgot = parts_.changes.forget(parts_.clock()); !forgot) parts_.tell(forgot.error());
}

web::Answer StaffAnswers::state(const web::Ask& ask, const Session& session) {
  const settings::Exhibit& exhibit = parts_.site.exhibit();
  const fs::path& folder = exhibit.keepsake.folder;
  Known known;
  known.kiosk = watch::look_at_kiosk(folder);
  known.now = parts_.clock();
  known.exhibit = parts_.site.file().string();
  if (known.kiosk.state) known.vessel = desk::in_words(known.kiosk.state->vessel);
  std::error_code error;
  // The kiosk makes the folder at its first start.
  const bool there = fs::exists(folder, error);
  if (const auto space = fs::space(there ? folder : parts_.site.file().parent_path(), error);
      !error)
    known.free_bytes = space.available;
  if (!exhibit.phone.address.empty())
    known.phones_answered = souvenir::Passes(folder).served(known.now);
  known.file_problems = parts_.check.problems();
  Json out = json_of(report_of(known));
  out["who"] = session.who;
  out["role"] = name_of(session.role);
  out["title"] = parts_.site.title();
  Json titles = Json::object();
  for (const auto& [language, title] : exhibit.title) titles[language] = title;
  out["titles"] = titles;
  out["credit"] = exhibit.credit;
  out["exhibit"] = parts_.site.file().string();
  out["keepsakes"] = folder.string();
  out["phones"] = known.phones_answered.value_or(false);
  if (session.role == Role::editor) out["trial"] = edit_.trial(known.now);
  out["today"] = files::local_time(static_cast<std::time_t>(known.now), files::kDay);
  return json(ask, out.text(-1));
}

web::Answer StaffAnswers::figures(const web::Ask& ask, bool picture) {
  std::error_code error;
  // The first visit makes the store.
  if (!picture && !fs::exists(files::store_file(parts_.site.exhibit().keepsake.folder), error) &&
      !error)
    return json(ask, R"({"visits": 0, "tables": {}})");
  const auto told = figures_.of(parts_.site.exhibit().keepsake.folder, query(ask, "from"),
                                query(ask, "to"), parts_.clock());
  if (!told)
    return refused(picture ? 404 : 409, {told.error().where, told.error().what,
                                         "If it is there, start onggi-console with sudo."});
  if (!picture) {
    Json out = store::json_of(**told), titles = Json::object();
    for (const auto& table : (*told)->tables)
      if (table.name == "vessel")
        for (const auto& line : table.lines) titles[line.name] = titles_.json_of(line.name);
    out["titles"] = titles;
    return json(ask, out.text(-1));
  }
  const auto bytes = drawing::draw_plot(desk::plot_of(**told), "figures.svg");
  return {.status = 200,
          .type = "image/svg+xml",
          .body = std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size())};
}

}  // namespace onggi::console
