#include "kiosk/program/console/edit_answers.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <vector>

#include "kiosk/collection/changes/revisions.h"
#include "kiosk/collection/content/drawing.h"
#include "kiosk/collection/content/pack.h"
#include "kiosk/ground/fields/field_json.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/toml/toml_json.h"
#include "kiosk/ground/toml/toml_text.h"
#include "kiosk/program/console/change_words.h"
#include "kiosk/program/console/said.h"
#include "kiosk/program/console/side_view.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;
using files::Json;

constexpr std::size_t kMostOfANote = 600;  // bytes

web::Answer no_such_file() {
  return refused(404, "There is no such file here any more.", "Load this page again.");
}

web::Answer another_change() {
  return refused(503, "Another change is being made at this moment.", "Try again in a moment.");
}

web::Answer wrong_form() { return refused(409, "This is no change.", "Load this page again."); }

std::vector<std::string> language_codes(const fs::path& folder) {
  std::vector<std::string> codes;
  std::error_code gone;
  for (fs::directory_iterator it(folder, gone), end; !gone && it != end; it.increment(gone))
    if (it->path().extension() == ".toml") codes.push_back(it->path().stem().string());
  std::ranges::sort(codes);
  return codes;
}

struct OnShelf {
  std::string id;
  content::Pack pack;
};

std::vector<OnShelf> shelf_of(const settings::Exhibit& exhibit) {
  std::vector<OnShelf> out;
  std::error_code gone;
  for (fs::directory_iterator it(exhibit.shelf, gone), end; !gone && it != end; it.increment(gone))
    if (const fs::path file = it->path() / "vessel.toml"; fs::is_regular_file(file, gone))
      out.push_back({it->path().filename().string(), content::read_pack(file).pack});
  const auto place = [&](const OnShelf& one) {
    return std::ranges::find(exhibit.order, one.id) - exhibit.order.begin();
  };
  std::ranges::sort(out, [&](const OnShelf& a, const OnShelf& b) {
    return std::pair(place(a), a.id) < std::pair(place(b), b.id);
  });
  return out;
}

}  // namespace

web::Answer EditAnswers::file(const web::Ask& ask, const std::string& name) {
  const auto edited = EditedFile::find(site_, name);
  if (!edited) return no_such_file();
  const auto text = edited->text();
  if (!text) return refused(409, text.error());
  const auto values = toml::json_of(*text);
  Json out = Json::object({{"file", edited->path().string()}, {"tag", changes::tag_of(*text)}});
  out["languages"] = Json::list_of(language_codes(files::language_folder(site_.file())));
  out["fields"] = fields::json_of(edited->fields());
  Json gaps = Json::list();
  for (const ChangeFault& gap : edited->gaps(*text))
    gaps.push_back(Json::object({{"key", gap.key}, {"what", gap.what}}));
  out["gaps"] = gaps;
  std::string all = out.text(-1);
  all.insert(all.size() - 1, ",\"values\":" + values.value_or("{}"));
  return json(ask, all);
}

web::Answer EditAnswers::check(const std::string& name, const std::string& body) {
  const auto edited = EditedFile::find(site_, name);
  if (!edited) return no_such_file();
  const auto wanted = edited->changes_in(body);
  if (!wanted) return wrong_form();
  const auto text = edited->text();
  if (!text) return refused(409, text.error());
  std::vector<ChangeFault> faults;
  static_cast<void>(edited->checked(*text, *wanted, faults));
  return answer_of(faults);
}

web::Answer EditAnswers::save(const web::Ask& ask, const std::string& name, const std::string& who,
                              std::int64_t now) {
  const auto edited = EditedFile::find(site_, name);
  if (!edited) return no_such_file();
  const auto wanted = edited->changes_in(ask.body);
  const std::string tag = Words(ask.body)["tag"];
  if (!wanted || wanted->empty() || tag.empty()) return wrong_form();
  const auto text = edited->text();
  if (!text) return refused(409, text.error());
  if (tag != changes::tag_of(*text))
    return refused(412, "Somebody else has changed this file since you opened it.",
                   "Look at both, and save again.");
  std::vector<ChangeFault> faults;
  const changes::Draft draft = edited->checked(*text, *wanted, faults);
  if (!faults.empty()) return answer_of(faults, 409);
  if (auto busy = refused_while_trying()) return std::move(*busy);
  if (draft.values.empty())
    return refused(409, "It is so already.", "There is nothing to save: load this page again.");
  std::vector<std::string> arguments{"set", "--json", "-", "--if", tag};
  std::string note;
  for (const changes::ChangedValue& value : draft.values)
    note += (note.empty() ? "" : "; ") + changes::change_words(value);
  const ChangeWords words = words_of(draft);
  if (!words.without.empty()) arguments.insert(arguments.end(), {"--without", words.without});
  arguments.push_back(edited->path().string());
  arguments.insert(arguments.end(), words.pairs.begin(), words.pairs.end());
  if (note.size() > kMostOfANote) note = toml::shown(note, kMostOfANote);
  note = edited->path().filename().string() + ": " + note;
  const auto body = nlohmann::json::parse(ask.body, nullptr, false);
  const bool trying = body.contains("try") && body["try"] == true;
  // It is known before the file is changed, so that it ends even if this program is killed then.
  if (trying && !saver_.under_way())
    if (auto kept = trial_.set(
            {changes::Revisions(site_.file()).next_id(), now + ChangeOnTrial::kLasts, note});
        !kept)
      return refused(kept.error());
  web::Answer answer =
      begin(std::move(arguments), {now, who, ask.from, trying ? "tried" : "changed", note});
  trying_ = trying && answer.status == 202;
  return answer;
}

std::optional<web::Answer> EditAnswers::refused_while_trying() const {
  if (!trial_.now()) return std::nullopt;
  return refused(409, "A change is being tried on the kiosk.",
                 "Keep it or put it back first, at the top of this page.");
}

web::Answer EditAnswers::undo(const web::Ask& ask, const std::string& who, std::int64_t now) {
  const auto body = nlohmann::json::parse(ask.body, nullptr, false);
  const std::string id = Words(ask.body)["id"];
  if (id.empty()) return wrong_form();
  if (auto busy = refused_while_trying()) return std::move(*busy);
  const bool forget = body.contains("forget") && body["forget"] == true;
  std::vector<std::string> arguments{
      "undo", "--json", "-", "--if", id, "--config", site_.file().string()};
  if (forget) arguments.emplace_back("--forget");
  return begin(std::move(arguments), {now, who, ask.from, forget ? "forgot" : "took back", ""});
}

web::Answer EditAnswers::begin(std::vector<std::string> arguments, ChangeLog::Change note) {
  if (saver_.under_way() || !saver_.begin(std::move(arguments))) return another_change();
  note_ = std::move(note);
  web::Answer answer = json(Json::object({{"number", ++number_}}));
  answer.status = 202;
  return answer;
}

std::optional<ChangeLog::Change> EditAnswers::ended(std::int64_t now) {
  auto said = saver_.take();
  if (!said) {
    if (trial_.is_due(now) && !saver_.under_way() && !trying_)
      take_trial_back(now, "(by itself)", "");
    return std::nullopt;
  }
  const auto report = nlohmann::json::parse(*said, nullptr, false);
  said_[number_] = std::move(*said);
  if (said_.size() > kRemembered) said_.erase(said_.begin());
  const bool done = report.value("done", false);
  if (std::exchange(trying_, false)) {
    if (!done) trial_.end();
    // From now on, under the name that it really got.
    else if (const std::string id = report.value("revision", ""); !id.empty())
      static_cast<void>(trial_.set({id, now + ChangeOnTrial::kLasts, note_.what}));
  }
  if (std::exchange(ending_trial_, false)) {
    trial_.end();
    if (done) put_back_at_ = now;
    if (!done) trial_trouble_ = report.value("what", "") + ' ' + report.value("remedy", "");
  }
  if (!done) return std::nullopt;
  if (note_.what.empty() && report.contains("words"))
    for (const auto& words : report["words"])
      if (words.is_string())
        note_.what = toml::shown(note_.what + words.get<std::string>() + ' ', kMostOfANote);
  return note_;
}

web::Answer EditAnswers::take_trial_back(std::int64_t now, const std::string& who,
                                         const std::string& from) {
  web::Answer answer = begin(
      {"undo", "--json", "-", "--if", trial_.now()->revision, "--config", site_.file().string()},
      {now, who, from, "put back", ""});
  ending_trial_ = answer.status == 202;
  return answer;
}

Json EditAnswers::trial(std::int64_t now) const {
  if (trial_.now())
    return Json::object({{"left", std::max<std::int64_t>(trial_.now()->until - now, 0)},
                         {"what", trial_.now()->what}});
  if (!trial_trouble_.empty()) return Json::object({{"trouble", trial_trouble_}});
  constexpr std::int64_t kTold = 60;  // s
  return now - put_back_at_ < kTold ? Json::object({{"put_back", true}}) : Json();
}

web::Answer EditAnswers::end_trial(const web::Ask& ask, const std::string& act,
                                   const std::string& who, std::int64_t now) {
  const bool told = !std::exchange(trial_trouble_, {}).empty();
  if (act != "keep" && act != "back")
    return refused(404, "This cannot be done here.", "Use the page.");
  if (!trial_.now())
    return told ? json(Json::object())
                : refused(409, "Nothing is being tried any more.", "Load this page again.");
  if (saver_.under_way()) return another_change();
  if (act == "back") return take_trial_back(now, who, ask.from);
  trial_.end();
  put_back_at_ = kLongAgo;
  return json(Json::object());
}

web::Answer EditAnswers::saved(const web::Ask& ask) {
  const int number = std::atoi(query(ask, "number").c_str());
  const auto said = said_.find(number);
  // It may have ended since ended() was asked: the next question tells.
  const bool under_way = number > 0 && number == number_ && said == said_.end();
  if (!under_way && said == said_.end())
    return refused(404, "This change is not known any more.", "Load this page again.");
  return {.status = 200,
          .type = kJson,
          .body = std::string(R"({"under_way": )") + (under_way ? "true" : "false") +
                  R"(, "said": )" + (under_way ? "null" : said->second) + '}'};
}

web::Answer EditAnswers::revisions(const web::Ask& ask) {
  Json list = Json::list();
  for (const changes::Revision& revision : changes::Revisions(site_.file()).read()) {
    const fs::path site = site_.file().parent_path().parent_path();
    list.push_back(Json::object({{"id", revision.kept_in.stem().string()},
                                 {"when", revision.when},
                                 {"file", revision.file.lexically_relative(site).string()},
                                 {"words", changes::words_of(revision)}}));
  }
  return json(ask, list.text(-1));
}

/// True if outline() has one. That of a scan is drawn by and by.
bool EditAnswers::has_outline(const std::string& id, const content::Pack& pack) {
  return !pack.drawing.empty() || !sheets_.of(site_.exhibit().shelf / id).outline.empty();
}

web::Answer EditAnswers::shelf(const web::Ask& ask) {
  const settings::Exhibit& exhibit = site_.exhibit();
  Json list = Json::list();
  for (const OnShelf& one : shelf_of(exhibit)) {
    Json titles = Json::object();
    for (const auto& [language, label] : one.pack.labels) titles[language] = label.title;
    const bool hidden = std::ranges::find(exhibit.hidden, one.id) != exhibit.hidden.end();
    list.push_back(Json::object({{"id", one.id},
                                 {"titles", titles},
                                 {"hidden", hidden},
                                 {"outline", has_outline(one.id, one.pack)},
                                 {"unfinished", one.pack.unfinished}}));
  }
  return json(ask, list.text(-1));
}

web::Answer EditAnswers::sheet(const web::Ask& ask, const std::string& id) {
  const auto vessel = EditedFile::find(site_, "vessel/" + id);
  if (!vessel) return no_such_file();
  const VesselSheets::Sheet sheet = sheets_.of(vessel->path().parent_path());
  if (sheet.png.empty()) {
    if (!sheet.trouble.empty()) return refused(409, sheet.trouble, "Look at Files.");
    web::Answer answer = json(Json::object({{"drawing", true}}));
    answer.status = 202;
    return answer;
  }
  web::Answer answer = json(ask, sheet.png);
  if (answer.status == 200) answer.type = "image/png";
  return answer;
}

web::Answer EditAnswers::outline(const web::Ask& ask, const std::string& id) {
  const auto vessel = EditedFile::find(site_, "vessel/" + id);
  const std::string name = vessel ? content::read_pack(vessel->path()).pack.drawing : "";
  const bool beside = !name.empty() && name.find('/') == std::string::npos;
  std::string picture;
  if (beside)
    if (const auto drawing = content::read_drawing(vessel->path().parent_path() / name))
      picture = side_view(drawing->section);
  if (vessel && picture.empty()) picture = sheets_.of(vessel->path().parent_path()).outline;
  if (picture.empty()) return page_of(404, "There is no drawing of this vessel.");
  web::Answer answer = json(ask, picture);
  if (answer.status == 200) answer.type = "image/svg+xml";
  return answer;
}

}  // namespace onggi::console
