#include "kiosk/program/console/screen_answers.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <string_view>
#include <vector>

#include "kiosk/ground/files/json.h"
#include "kiosk/program/console/change_words.h"
#include "kiosk/program/console/edited_file.h"
#include "kiosk/program/console/said.h"
#include "kiosk/program/watch/kiosk_state.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;
using files::Json;

constexpr const char* kSizes = "1280x720,1080x1920";

std::int64_t steady_seconds() {
  using std::chrono::duration_cast, std::chrono::seconds, std::chrono::steady_clock;
  return duration_cast<seconds>(steady_clock::now().time_since_epoch()).count();
}

bool plays_at(const fs::path& keepsakes) {
  const watch::SeenKiosk kiosk = watch::look_at_kiosk(keepsakes);
  return kiosk.runs && kiosk.state && kiosk.state->visitor;
}

/// True of a name of ours: it can be no option.
bool is_name(const std::string& word) {
  return std::ranges::all_of(word,
                             [](char c) {
                               return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                                      (c >= '0' && c <= '9') || c == '_' || c == '-';
                             }) &&
         !word.starts_with('-');
}

/// True of a folder on the shelf, in any script.
bool is_folder(const std::string& word) {
  return !word.starts_with('-') && std::ranges::all_of(word, [](char c) {
    return static_cast<unsigned char>(c) >= ' ' && c != '/';
  });
}

/// A number of a drawing, or of a picture; -1: none.
int number_in(std::string_view text) {
  int number = -1;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  return read.ec == std::errc() && read.ptr == text.data() + text.size() ? number : -1;
}

web::Answer visitor_is_there() {
  web::Answer answer = json(Json::object({{"visitor", true},
                                          {"what", "A visitor is at the kiosk."},
                                          {"remedy", "It is drawn when they have gone."}}));
  answer.status = 409;
  return answer;
}

}  // namespace

bool ScreenAnswers::visitor_plays() const { return plays_at(site_.exhibit().keepsake.folder); }

web::Answer ScreenAnswers::draw(const web::Ask& ask) {
  take();
  const Words said(ask.body);
  std::vector<std::string> words{"--config", site_.file().string(), "--sizes", kSizes};
  for (const char* option : {"language", "vessel", "comfort"}) {
    const std::string value = said[option];
    if (option == std::string_view("vessel") ? !is_folder(value) : !is_name(value))
      return refused(409, "This is no choice.", "Load this page again.");
    if (!value.empty()) words.insert(words.end(), {std::string("--") + option, value});
  }
  const std::string screen = said["screen"], name = said["file"];
  if (screen.empty() || !is_name(screen))
    return refused(409, "This is no choice.", "Load this page again.");
  ChangeWords change;
  if (!name.empty()) {
    const auto edited = EditedFile::find(site_, name);
    if (!edited)
      return refused(404, "There is no such file here any more.", "Load this page again.");
    const auto wanted = edited->changes_in(ask.body);
    if (!wanted) return refused(409, "This is no change.", "Load this page again.");
    const auto text = edited->text();
    if (!text) return refused(409, text.error());
    std::vector<ChangeFault> faults;
    const changes::Draft draft = edited->checked(*text, *wanted, faults);
    if (!faults.empty()) return answer_of(faults, 409);
    change = words_of(draft);
    if (!draft.values.empty()) words.insert(words.end(), {"--of", edited->path().string()});
  }
  if (!change.without.empty()) words.insert(words.end(), {"--without", change.without});
  words.push_back(screen);
  words.insert(words.end(), change.pairs.begin(), change.pairs.end());

  if (visitor_plays()) return visitor_is_there();
  auto wanted = std::make_shared<Wanted>();
  wanted->asked_at = steady_seconds();
  const auto unwanted = [wanted, keepsakes = site_.exhibit().keepsake.folder] {
    return wanted->stopped || steady_seconds() > wanted->asked_at + kForgotten ||
           plays_at(keepsakes);
  };
  if (!drawer_.begin(std::move(words), unwanted))
    return refused(503, "Another screen is drawn at this moment.", "Try again in a moment.");
  wanted_ = std::move(wanted);
  web::Answer answer = json(Json::object({{"number", ++number_}}));
  answer.status = 202;
  return answer;
}

void ScreenAnswers::take() {
  auto drawn = drawer_.take();
  if (!drawn) return;
  kept_[number_] = std::move(*drawn);
  while (kept_.size() > kKept) kept_.erase(kept_.begin());
}

web::Answer ScreenAnswers::drawn(const web::Ask& ask) {
  take();
  const int number = number_in(query(ask, "number"));
  const auto of = kept_.find(number);
  const bool drawing = of == kept_.end() && number == number_ && drawer_.under_way();
  if (drawing && wanted_) wanted_->asked_at = steady_seconds();
  if (of == kept_.end() && !drawing)
    return refused(404, "This drawing is not kept any more.", "Draw it again.");
  Json out = Json::object({{"drawing", drawing}});
  if (drawing) return json(ask, out.text(-1));
  Json pictures = Json::list();
  for (std::size_t n = 0; n < of->second.pictures.size(); ++n)
    pictures.push_back(
        Json::object({{"at", "/screen/" + std::to_string(number) + '/' + std::to_string(n)},
                      {"width", of->second.pictures[n].width},
                      {"height", of->second.pictures[n].height}}));
  out["pictures"] = pictures;
  out["what"] = of->second.what;
  out["remedy"] = of->second.remedy;
  out["visitor"] = of->second.left;
  return json(ask, out.text(-1));
}

web::Answer ScreenAnswers::picture(const std::string& number, const std::string& part) const {
  const auto of = kept_.find(number_in(number));
  const int n = number_in(part);
  if (of == kept_.end() || n < 0 || static_cast<std::size_t>(n) >= of->second.pictures.size())
    return refused(404, "This drawing is not kept any more.", "Draw it again.");
  return {.status = 200,
          .type = "image/jpeg",
          .body = of->second.pictures[static_cast<std::size_t>(n)].jpeg};
}

web::Answer ScreenAnswers::stop() {
  if (wanted_) wanted_->stopped = true;
  return json(Json::object());
}

}  // namespace onggi::console
