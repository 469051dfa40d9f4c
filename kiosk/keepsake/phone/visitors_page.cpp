#include "kiosk/keepsake/phone/visitors_page.h"

namespace onggi::phone {

namespace {

/// Escapes a museum's words, so that they are always text and never markup.
std::string safe(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string spoken(const PhoneWords& words) {
  return " lang=\"" + safe(words.code) + "\" dir=\"" + (words.right_to_left ? "rtl" : "ltr") + '"';
}

std::string page(const PhoneWords& words, const std::string& body) {
  return "<!doctype html><html" + spoken(words) +
         "><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
         "content=\"width=device-width, initial-scale=1\"><meta name=\"robots\" "
         "content=\"noindex\"><link rel=\"icon\" href=\"/page.svg\"><title>" +
         safe(words["title"]) +
         "</title><link rel=\"stylesheet\" href=\"/page.css\"></head><body>" + "<main>" + body +
         "</main></body></html>";
}

}  // namespace

std::string visitors_page(const std::string& token, const PhoneWords& w, const PhoneWords* own,
                          const PhoneLanguages& languages, Pictures pictures) {
  const std::string at = "/k/" + token;
  const auto link = [&](const char* file, const char* key) {
    return "<a class=\"take\" download href=\"" + at + '/' + file + "\">" + safe(w[key]) + "</a>";
  };
  const auto language = [&](const PhoneWords& other) {
    return "<a" + spoken(other) + " hreflang=\"" + safe(other.code) + "\" href=\"" + at +
           "?lang=" + safe(other.code) + "\">" + safe(other.name) + "</a>";
  };
  if (own == &w) own = nullptr;
  std::string body;
  if (own != nullptr) body += "<p class=\"own\">" + language(*own) + "</p>";
  body += "<h1>" + safe(w["title"]) + "</h1><figure id=\"turning\" hidden><canvas id=\"pot\" " +
          "role=\"img\" tabindex=\"0\" data-glb=\"" + at + "/pot.glb\" aria-label=\"" +
          safe(w["title"]) + "\"></canvas><figcaption>" + safe(w["turn"]) +
          "</figcaption></figure><img src=\"" + at + "/postcard.jpg\" alt=\"" + safe(w["title"]) +
          "\" width=\"1500\" height=\"2100\">" + link("postcard.jpg", "postcard") +
          (pictures.turning ? link("turning.gif", "turning") : "") +
          (pictures.rollout ? link("rollout.jpg", "rollout") : "") +
          (pictures.sheet ? link("sheet.jpg", "sheet") : "") + link("pot.glb", "model") +
          link("pot.stl", "print") + "<p>" + safe(w["until"]) +
          // The visitor must confirm, also without a script.
          "</p><details><summary>" + safe(w["delete"]) +
          "</summary><form method=\"post\" action=\"" + at + "/delete?lang=" + safe(w.code) +
          "\"><p>" + safe(w["sure"]) + "</p><button>" + safe(w["yes"]) +
          "</button></form></details>";
  std::string others;
  for (const PhoneWords& other : languages.all())
    if (&other != &w && &other != own) others += "<li>" + language(other) + "</li>";
  if (!others.empty())
    body += "<nav aria-label=\"" + safe(w["languages"]) + "\"><ul>" + others + "</ul></nav>";
  return page(w, body + "<script src=\"/page.js\"></script>");
}

std::string sentence_page(const PhoneWords& words, const char* key) {
  return page(words, "<p class=\"alone\">" + safe(words[key]) + "</p>");
}

}  // namespace onggi::phone
