#include "kiosk/exhibit/composition/words.h"

#include <algorithm>
#include <ctime>

#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/log.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/wall_clock.h"
#include "kiosk/picture/view/palette.h"

namespace onggi::exhibit {

Result<std::vector<content::Language>> read_languages(const settings::Exhibit& exhibit,
                                                      const std::string& first) {
  const auto folder = files::language_folder(exhibit.file);
  std::vector<content::Language> languages;
  for (const std::string& code : exhibit.languages) {
    auto read = content::check_language(folder / (code + ".toml"));
    files::log_problems(read.problems);
    files::log_problems(read.advice);
    if (read.problems.empty()) languages.push_back(std::move(read.language));
  }
  if (languages.empty())
    return problem(exhibit.file.string(), "None of the exhibit's languages could be read.",
                   "Name at least one of content/languages, for example languages = [\"en\"].");
  if (first.empty()) return languages;
  const auto wanted = std::find_if(languages.begin(), languages.end(),
                                   [&](const auto& l) { return l.code() == first; });
  if (wanted == languages.end())
    return problem("--language " + first, "The exhibit has no such language.",
                   "Add it to languages in " + exhibit.file.string() +
                       ", or name one of the exhibit's languages.");
  std::rotate(languages.begin(), wanted, wanted + 1);
  return languages;
}

const content::Language& language_of(const std::vector<content::Language>& languages,
                                     const std::string& code) {
  for (const content::Language& language : languages)
    if (language.code() == code) return language;
  return languages.front();
}

namespace {

std::string date_in(const content::Language& language, std::time_t at) {
  const files::LocalMoment day = files::local_moment(at);
  return language.say("postcard.date",
                      {{"day", std::to_string(day.day)},
                       {"month", language.say("month." + std::to_string(day.month))},
                       {"year", std::to_string(day.year)}});
}

}  // namespace

std::string phone_address(const settings::Exhibit& exhibit, const std::string& token) {
  return exhibit.phone.address + "/k/" + token;
}

souvenir::PostcardWords postcard_words(const content::Language& language,
                                       const content::Label& label,
                                       const settings::Exhibit& exhibit) {
  const std::time_t now = files::wall_now();
  souvenir::PostcardWords words;
  words.title = language.say("postcard.title", {{"vessel", label.title}});
  std::string where = label.culture.empty() ? label.date : label.culture;
  if (!label.culture.empty() && !label.date.empty())
    where = language.say("all.list", {{"first", label.culture}, {"second", label.date}});
  // Alone it would tell where the visitor's own pot was made.
  if (!where.empty()) words.vessel = language.say("postcard.vessel", {{"where", where}});
  words.credit = exhibit.credit;
  words.date = date_in(language, now);
  words.language = language.code();
  words.right_to_left = language.right_to_left();
  words.address = label.address;
  words.address_words = language.say("postcard.museum");
  const auto good_for = static_cast<std::time_t>(exhibit.phone.hours * 3600.0);
  words.phone_words = language.say("postcard.phone", {{"date", date_in(language, now + good_for)}});
  return words;
}

view::Frame make_opening_frame(const content::Language& language, int width, int height, int done,
                               int total) {
  const float px = static_cast<float>(std::min(width, height)) / 28;
  view::Text text;
  text.text = total == 0 ? language.say("opening.start")
                         : language.say("opening.progress", {{"done", std::to_string(done)},
                                                             {"total", std::to_string(total)}});
  text.style.px = px;
  text.style.align = view::Align::centre;
  text.style.language = language.code();
  text.color = view::kInk;
  text.box = {0, (static_cast<float>(height) - 2 * px) / 2, static_cast<float>(width), 2 * px};
  view::Frame frame;
  frame.width = width;
  frame.height = height;
  frame.items.emplace_back(std::move(text));
  return frame;
}

}  // namespace onggi::exhibit
