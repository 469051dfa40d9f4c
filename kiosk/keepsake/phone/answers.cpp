#include "kiosk/keepsake/phone/answers.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "kiosk/keepsake/phone/page_files.h"
#include "kiosk/keepsake/phone/probes.h"
#include "kiosk/keepsake/phone/sent_keepsake.h"
#include "kiosk/keepsake/phone/visitors_page.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"

namespace onggi::phone {

namespace {

constexpr std::string_view kBelow = "/k/";

struct File {
  const char* name;
  const char* type;
  bool saved;
};
constexpr File kFiles[] = {
    {souvenir::kPostcard, "image/jpeg", false},      {souvenir::kTurning, "image/gif", false},
    {souvenir::kRollout, "image/jpeg", false},       {souvenir::kSheet, "image/jpeg", false},
    {souvenir::kPotGlb, "model/gltf-binary", false}, {souvenir::kPotStl, "model/stl", true}};

struct PageFile {
  const char *name, *type, *text;
};
const PageFile kPageFiles[] = {{"/page.js", "text/javascript; charset=utf-8", k_page_js},
                               {"/page.css", "text/css; charset=utf-8", k_page_css},
                               {"/page.svg", "image/svg+xml", k_page_svg}};

}  // namespace

web::Answer Answers::nothing_here(const web::Ask& ask) const {
  const PhoneWords* own = languages_.liked(ask.languages);
  return {.body = sentence_page(own != nullptr ? *own : languages_.all().front(), "nothing")};
}

// A phone asks for a file in parts, and again. After so many files the disk is the trouble, and the
// log has told it.
void Answers::tell_once(const Problem& remark) {
  constexpr std::size_t kMostTold = 1000;
  if (told_.size() < kMostTold && told_.insert(to_text(remark)).second) tell_(remark);
}

web::Answer Answers::to(const web::Ask& ask) {
  const std::string_view target = ask.target;
  const bool get = ask.method == "GET" || ask.method == "HEAD";
  if (get)
    for (const auto& [name, type, text] : kPageFiles)
      if (target == name) return {.status = 200, .type = type, .body = text};
  if (const Probe* probe = get ? probe_of(target) : nullptr; probe != nullptr)
    return {.status = probe->status,
            .type = std::string(probe->type),
            .body = std::string(probe->body)};
  // Compare all passes for every request, so that the time of an answer tells nothing.
  const auto mark = std::min(target.find('?'), target.size());
  const std::string_view path = target.substr(0, mark);
  const std::string_view rest =
      path.starts_with(kBelow) ? path.substr(kBelow.size()) : std::string_view();
  const auto slash = rest.find('/');
  const std::string_view what =
      slash == std::string_view::npos ? std::string_view() : rest.substr(slash + 1);
  const std::int64_t now = clock_();
  const auto pass = passes_.find(rest.substr(0, slash), now);
  if (!pass) return nothing_here(ask);
  // Use the visit's language unless the request asks for another.
  const PhoneWords* own = languages_.liked(ask.languages);
  const PhoneWords* words = languages_.of(web::asked_for(target, "lang"));
  for (const PhoneWords* other : {languages_.of(pass->language), own, &languages_.all().front()})
    if (words == nullptr) words = other;
  if (ask.method == "POST" && what == "delete") {
    if (!passes_.remove_all_of(*pass))
      return {.status = 500, .body = sentence_page(*words, "not_deleted")};
    return {.status = 200, .body = sentence_page(*words, "deleted")};
  }
  if (!get || !pass->whole) return nothing_here(ask);
  if (slash == std::string_view::npos) {
    // Whoever asks for the head alone has not opened the page.
    if (ask.method == "GET") passes_.note_fetched(*pass, now);
    return {.status = 200,
            .body = visitors_page(pass->token, *words, own, languages_,
                                  {.turning = passes_.has_file(*pass, souvenir::kTurning),
                                   .rollout = passes_.has_file(*pass, souvenir::kRollout),
                                   .sheet = passes_.has_file(*pass, souvenir::kSheet)})};
  }
  for (const File& file : kFiles) {
    if (what != file.name) continue;
    auto opened = passes_.open_file(*pass, file.name);
    if (!opened) break;
    if (opened->remark) tell_once(*opened->remark);
    web::Answer answer = part_of(sent(std::move(*opened)), file.type, ask);
    if (file.saved && answer.status != 416) answer.file_name = file.name;
    return answer;
  }
  return nothing_here(ask);
}

}  // namespace onggi::phone
