#include "kiosk/collection/settings/mission_fields.h"

#include "kiosk/collection/settings/mission_file.h"

namespace onggi::settings {
namespace {

using fields::Field;
using fields::FieldKind;

/// Two numbers, the smaller first.
Field from_to(const char* key, double least, double most, const char* words) {
  Field out{.table = "mission",
            .key = key,
            .kind = FieldKind::list,
            .words = words,
            .least = least,
            .most = most,
            .unit = "mm"};
  out.range = "two of mm, " + fields::bounds_words(out) + ", the smaller first";
  return out;
}

fields::FieldList all_mission_fields() {
  fields::FieldList list{
      "missions.toml",
      {
          {.table = "mission",
           .key = "id",
           .words = "its name in counts and keepsakes",
           .range = "1 to 40 lower-case letters, digits and _, each once"},
          {.table = "mission",
           .key = "kind",
           .words = "what visitors do",
           .choices = {kMissionKinds.begin(), kMissionKinds.end()}},
          {.table = "mission",
           .key = "on",
           .kind = FieldKind::boolean,
           .words = "visitors see it",
           .usual = "true"},
          {.table = "mission",
           .key = "vessels",
           .kind = FieldKind::texts,
           .words = "of `today`: the vessels, day by day",
           .range = "names of folders on the shelf",
           .usual = "all"},
          {.table = "mission",
           .key = "litres",
           .kind = FieldKind::number,
           .words = "of `describe`: what the pot should hold",
           .least = kLeastLitres,
           .most = kMostLitres,
           .unit = "litres"},
          from_to("height_mm", 40, 200, "of `describe`: the pot's height"),
          from_to("mouth_mm", 40, 220, "of `describe`: the outer diameter at the rim"),
          {.table = "mission",
           .key = "vessel",
           .words = "of `eyes_closed` and `two_hands`: the vessel",
           .range = "the name of a folder on the shelf",
           .usual = "the first"},
          {.table = "mission",
           .key = "second",
           .words = "of `two_hands`: what the second visitor has",
           .usual = "\"finger\"",
           .choices = {kSecondHands.begin(), kSecondHands.end()}},
          spoken_field("mission.title", "the title of its card", bounds::kMissionTitle),
          spoken_field("mission.about", "the task", bounds::kMissionAbout),
      },
      {{.name = "mission", .is_list = true, .words = "A task for visitors."}}};
  return list;
}

}  // namespace

std::string letters_range(TextBound bound) {
  return "1 to " + std::to_string(bound.letters) + " letters" +
         (bound.lines ? ", also of several lines" : ", one line");
}

Field spoken_field(const std::string& table, const std::string& words, TextBound bound) {
  return {.table = table,
          .key = "LANGUAGE",
          .words = words + ", in that language",
          .range = letters_range(bound),
          .any_key = true};
}

const fields::FieldList& mission_fields() {
  static const fields::FieldList kList = all_mission_fields();
  return kList;
}

}  // namespace onggi::settings
