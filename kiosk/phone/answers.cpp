#include "kiosk/phone/answers.h"

#include <string_view>

#include "kiosk/phone/visitors_page.h"
#include "kiosk/souvenir/visit_folder.h"

namespace onggi::phone {

namespace {

constexpr std::string_view kBelow = "/k/";

struct File {
  const char* name;
  const char* type;
  bool saved;
};
constexpr File kFiles[] = {{souvenir::kPostcardJpeg, "image/jpeg", false},
                           {souvenir::kPotGlb, "model/gltf-binary", false},
                           {souvenir::kPotStl, "model/stl", true}};

Answer nothing_here(const Ask& ask) { return {.body = nothing_page(ask.languages)}; }

}  // namespace

Answer Answers::to(const Ask& ask) const {
  const std::string_view target = ask.target;
  if (ask.method == "GET" && target == "/page.js")
    return {.status = 200, .type = "text/javascript; charset=utf-8", .body = k_page_js};
  if (ask.method == "GET" && target == "/page.css")
    return {.status = 200, .type = "text/css; charset=utf-8", .body = k_page_css};
  // Whatever is asked, all passes are looked through: how long it takes tells nothing.
  const std::string_view rest =
      target.starts_with(kBelow) ? target.substr(kBelow.size()) : std::string_view();
  const auto slash = rest.find('/');
  const std::string_view what =
      slash == std::string_view::npos ? std::string_view() : rest.substr(slash + 1);
  const auto pass = passes_.find(rest.substr(0, slash), clock_());
  if (!pass) return nothing_here(ask);
  if (ask.method == "POST" && what == "delete") {
    if (!passes_.remove_all_of(*pass))
      return {.status = 500, .body = not_deleted_page(ask.languages)};
    return {.status = 200, .body = deleted_page(ask.languages)};
  }
  if (ask.method != "GET") return nothing_here(ask);
  if (slash == std::string_view::npos)
    return {.status = 200, .body = visitors_page(pass->token, ask.languages)};
  for (const File& file : kFiles) {
    if (what != file.name) continue;
    auto bytes = passes_.file_of(*pass, file.name);
    if (!bytes) break;
    return {.status = 200,
            .type = file.type,
            .body = std::move(*bytes),
            .file_name = file.saved ? file.name : ""};
  }
  return nothing_here(ask);
}

}  // namespace onggi::phone
