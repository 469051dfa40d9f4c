#include "kiosk/collection/settings/exhibit_fields.h"

#include "kiosk/collection/settings/exhibit_settings.h"

namespace onggi::settings {
namespace {

using fields::Field;

void add_hours(std::vector<Field>& out) {
  const std::string spans =
      "`\"10:00-18:00\"`, `\"10:00-12:30, 14:00-18:00\"`, `\"20:00-02:00\"`, `\"closed\"`";
  for (const char* day :
       {"monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday"}) {
    const bool first = std::string_view(day) == "monday";
    out.push_back({.table = "hours",
                   .key = day,
                   .words =
                       "a day's hours: up to four spans, until `24:00` at the latest; one that "
                       "ends before it begins goes on into the next day",
                   .range = spans,
                   .usual = "`every_day`",
                   .shown_key = "`monday` ... `sunday`",
                   .on_page = first});
  }
  out.push_back({.table = "hours",
                 .key = "every_day",
                 .words = "the hours of the other days",
                 .range = "as above",
                 .usual = "none: then every day needs its own"});
  out.push_back({.table = "hours",
                 .key = "screen_off",
                 .kind = fields::FieldKind::boolean,
                 .words = "the monitor sleeps (DPMS); false: a black picture, for a monitor that "
                          "would look for another source",
                 .usual = "true"});
  out.push_back({.table = "hours.exceptions",
                 .key = "DATE",
                 .words = "the hours of a date (`2026-12-24`), or of a day of every year (`12-24`)",
                 .range = spans,
                 .any_key = true,
                 .on_page = false});  // an example shows it
}

fields::FieldList all_fields() {
  fields::FieldList list{"exhibit.toml", {}};
  for (const Setting& setting : exhibit_settings()) list.fields.push_back(field_of(setting));
  list.fields.push_back({.table = "title",
                         .key = "LANGUAGE",
                         .words = "the exhibit's title in that language, else the English title, "
                                  "else the first language's",
                         .range = "1 to 120 letters, one line",
                         .usual = "en `\"Make a pot\"`, ko `\"도자기 빚기\"`",
                         .any_key = true,
                         .shown_key = "a language's code"});
  list.fields.push_back({.table = "vessel_scenes",
                         .key = "VESSEL",
                         .words = "another scene for this vessel",
                         .range = "an existing file",
                         .usual = "the exhibit's `scene`",
                         .any_key = true,
                         .shown_key = "a vessel's name, as its folder on the shelf is called"});
  add_hours(list.fields);
  return list;
}

}  // namespace

const fields::FieldList& exhibit_fields() {
  static const fields::FieldList kList = all_fields();
  return kList;
}

}  // namespace onggi::settings
