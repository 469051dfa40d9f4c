#include "kiosk/program/console/scan_answers.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "kiosk/ground/files/json.h"
#include "kiosk/ground/web/received_file.h"
#include "kiosk/program/console/said.h"

namespace onggi::console {

namespace {

using files::Json;

web::Answer busy() {
  return refused(503, "Something else is done with a scan at this moment.",
                 "Try again in a moment.");
}
web::Answer another_scan_came() {
  return refused(412, "Another scan has been sent meanwhile.",
                 "What is asked now is about that one.");
}
web::Answer begun() {
  web::Answer answer = json(Json::object());
  answer.status = 202;
  return answer;
}

}  // namespace

web::Answer ScanAnswers::took(const web::Ask& ask) {
  if (!ask.file) return refused(409, "No file came with this.", "Use the page itself.");
  const std::string name = query(ask, "name");
  const bool first = query(ask, "first") == "1";
  if (!first && query(ask, "scan") != std::to_string(inbox_.number())) return another_scan_came();
  if (auto taken = inbox_.take(*ask.file, name, first); !taken) return refused(taken.error());
  return json(Json::object({{"took", name}, {"scan", inbox_.number()}}));
}

web::Answer ScanAnswers::state(const web::Ask& ask) { return json(ask, inbox_.json()); }

web::Answer ScanAnswers::act(const std::string& act, const web::Ask& ask, const std::string& who,
                             std::int64_t now) {
  const auto body = nlohmann::json::parse(ask.body, nullptr, false);
  if (body.is_object() && body.contains("scan") && body["scan"] != inbox_.number())
    return another_scan_came();
  if (act == "look") return inbox_.look() ? begun() : busy();
  if (act == "forget") return inbox_.forget() ? json(Json::object()) : busy();
  if (act != "place") return refused(404, "This cannot be done here.", "Use the page.");
  web::Answer answer = place(ask);
  if (answer.status == 202) note_ = {now, who, ask.from, "added vessel", ""};
  return answer;
}

web::Answer ScanAnswers::place(const web::Ask& ask) {
  const auto body = nlohmann::json::parse(ask.body, nullptr, false);
  if (!body.is_object() || !body.contains("vessel") || !body["vessel"].is_number_unsigned() ||
      !body.contains("id") || !body["id"].is_string())
    return refused(409, "This is no choice.", "Load this page again.");
  if (std::ranges::any_of(body["id"].get<std::string>(), [](char c) { return c < ' '; }))
    return refused(409, "This is no name.", "Write small Latin letters, digits, _ and -.");
  ScanInbox::Choice choice;
  choice.vessel = body["vessel"].get<std::size_t>();
  choice.id = body["id"].get<std::string>();
  choice.turned_over = body.contains("turned_over") && body["turned_over"] == true;
  if (body.contains("height_mm") && body["height_mm"].is_number())
    choice.height_mm = body["height_mm"].get<double>();
  if (!std::isfinite(choice.height_mm) || choice.height_mm < 0.0)
    return refused(409, "This is no height.", "Write it in millimetres.");
  return inbox_.put_on_shelf(choice, site_.exhibit().shelf) ? begun() : busy();
}

std::optional<ChangeLog::Change> ScanAnswers::ended() {
  const auto id = inbox_.put();
  if (!id) return std::nullopt;
  note_.what = *id;
  return note_;
}

}  // namespace onggi::console
