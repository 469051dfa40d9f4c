#include "kiosk/phone/visitors_page.h"

#include <algorithm>

namespace onggi::phone {

namespace {

struct Words {
  const char *code, *title, *picture, *print, *model, *erase, *sure, *until, *nothing, *erased,
      *not_erased;
};

constexpr Words kWords[] = {
    {"en", "Your pot", "Save the postcard", "For a 3-D printer (STL)", "The pot (GLB)",
     "Delete everything", "Delete your postcard and pot here for good?",
     "This page closes by itself. Save what you want to keep.",
     "There is nothing here, or not any more.",
     "Deleted. Nothing of yours is left at the museum's wheel.",
     "It could not be deleted. Please try again, or ask at the desk."},
    {"ko", "내가 빚은 도자기", "엽서 저장", "3D 프린터용 (STL)", "도자기 모형 (GLB)", "모두 지우기",
     "엽서와 도자기를 완전히 지울까요?", "이 페이지는 저절로 닫힙니다. 간직할 것은 저장하세요.",
     "여기에는 아무것도 없거나, 이제는 없습니다.",
     "지웠습니다. 박물관의 물레에는 아무것도 남아 있지 않습니다.",
     "지우지 못했습니다. 다시 해 보시거나 안내소에 말씀해 주세요."}};

const Words& words_for(const std::string& languages) {
  const Words* first = &kWords[0];
  std::size_t at = std::string::npos;
  for (const Words& words : kWords) {
    const std::size_t found = languages.find(words.code);
    if (found >= at) continue;
    at = found;
    first = &words;
  }
  return *first;
}

std::string page(const Words& words, const std::string& body) {
  return std::string("<!doctype html><html lang=\"") + words.code +
         "\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
         "content=\"width=device-width, initial-scale=1\"><meta name=\"robots\" "
         "content=\"noindex\"><title>" +
         words.title + "</title><link rel=\"stylesheet\" href=\"/page.css\"></head><body><main>" +
         body + "</main></body></html>";
}

std::string sentence(const Words& words, const char* what) {
  return page(words, std::string("<p>") + what + "</p>");
}

}  // namespace

std::string visitors_page(const std::string& token, const std::string& languages) {
  const Words& w = words_for(languages);
  const std::string at = "/k/" + token;
  const auto link = [&](const char* file, const char* words) {
    return "<a class=\"take\" download href=\"" + at + "/" + file + "\">" + words + "</a>";
  };
  return page(w, std::string("<h1>") + w.title + "</h1><canvas id=\"pot\" data-glb=\"" + at +
                     "/pot.glb\" hidden></canvas><img src=\"" + at + "/postcard.jpg\" alt=\"" +
                     w.title + "\">" + link("postcard.jpg", w.picture) + link("pot.stl", w.print) +
                     link("pot.glb", w.model) + "<p>" + w.until +
                     "</p><form method=\"post\" action=\"" + at + "/delete\" data-sure=\"" +
                     w.sure + "\"><button>" + w.erase +
                     "</button></form><script src=\"/page.js\"></script>");
}

std::string nothing_page(const std::string& languages) {
  const Words& w = words_for(languages);
  return sentence(w, w.nothing);
}
std::string deleted_page(const std::string& languages) {
  const Words& w = words_for(languages);
  return sentence(w, w.erased);
}
std::string not_deleted_page(const std::string& languages) {
  const Words& w = words_for(languages);
  return sentence(w, w.not_erased);
}

}  // namespace onggi::phone
