#include "kiosk/collection/content/content_fields.h"

#include "engine/effects/prints.h"
#include "kiosk/collection/content/lesson.h"
#include "kiosk/collection/settings/mission_fields.h"
#include "kiosk/collection/settings/visitor_text.h"

namespace onggi::content {
namespace {

namespace bounds = settings::bounds;
using fields::Field;
using fields::FieldKind;
using settings::letters_range;

constexpr double kShortestStep = 3, kLongestStep = 120;  // s

Field of_label(const char* key, settings::TextBound bound, const char* words) {
  return {.table = "label.LANGUAGE", .key = key, .words = words, .range = letters_range(bound)};
}

Field true_length(const char* key, const char* words) {
  return {.key = key,
          .kind = FieldKind::number,
          .words = words,
          .least = 5,
          .most = 5000,
          .unit = "mm"};
}

Field color(const char* key, const char* words, const char* usual = "") {
  return {.table = "glaze",
          .key = key,
          .words = words,
          .range = "`\"#RRGGBB\"`, a colour as designers write it",
          .usual = usual};
}

Field share(const char* key, double most, const char* usual, const char* words) {
  return {.table = "glaze",
          .key = key,
          .kind = FieldKind::number,
          .words = words,
          .most = most,
          .usual = usual};
}

Field id(const char* table) {
  return {.table = table,
          .key = "id",
          .words = "its name in files",
          .range = "1 to 40 lower-case letters, digits and _, each once"};
}

fields::FieldList all_vessel_fields() {
  return {
      "vessel.toml",
      {
          {.key = "unfinished",
           .kind = FieldKind::boolean,
           .words = "visitors do not see it yet",
           .usual = "false"},
          {.key = "drawing", .words = "its section drawing", .range = "a file in its folder"},
          {.key = "decoration", .words = "how it was decorated", .range = "a file in its folder"},
          {.key = "way",
           .words = "how visitors may decorate it",
           .range = "the name of a file of the exhibit's `ways`"},
          {.key = "built",
           .kind = FieldKind::boolean,
           .words = "it was built of coils",
           .usual = "false"},
          {.key = "paddle",
           .words = "the face of its makers' paddle",
           .usual = "the scene's",
           .choices = {paddle_faces().begin(), paddle_faces().end()}},
          {.key = "glazes",
           .kind = FieldKind::texts,
           .words = "the glazes that visitors may choose for it",
           .range = "ids of the exhibit's glazes",
           .usual = "all"},
          true_length("true_height_mm", "its true height"),
          true_length("true_diameter_mm", "its true greatest diameter"),
          {.key = "node", .words = "the object of the file that is the vessel"},
          {.key = "units",
           .words = "what one unit of the mesh is",
           .usual = "found",
           .choices = {"mm", "cm", "m", "in"}},
          {.key = "up",
           .words = "the axis of the mesh that points to the rim",
           .usual = "found",
           .choices = {"x", "y", "z", "-x", "-y", "-z"}},
          {.key = "institution",
           .words = "who keeps it",
           .range = letters_range(bounds::kInstitution)},
          {.key = "accession",
           .words = "its number there",
           .range = letters_range(bounds::kAccession)},
          {.key = "source",
           .words = "where its shape and figures are from",
           .range = letters_range(bounds::kSource)},
          {.key = "credit", .words = "whom to thank", .range = letters_range(bounds::kCredit)},
          {.key = "licence",
           .words = "under which licence the shape is shown",
           .range = letters_range(bounds::kLicence)},
          {.key = "address",
           .words = "the museum's page on it",
           .range = "a web address that a phone can open"},
          {.key = "color",
           .kind = FieldKind::list,
           .words = "red, green and blue, as on screen",
           .range = "three numbers, 0 to 1"},
          of_label("title", bounds::kTitle, "the vessel's name"),
          of_label("what", bounds::kWhat, "what it is, in a few words"),
          of_label("culture", bounds::kCulture, "who made it, and where"),
          of_label("date", bounds::kDate, "when"),
          of_label("made", bounds::kMade, "how it was made"),
          of_label("text", bounds::kText, "what visitors read of it"),
          of_label("credit", bounds::kLabelCredit, "whom to thank, in that language"),
          {.table = "label.LANGUAGE",
           .key = "address",
           .words = "the museum's page on it, in that language",
           .range = "a web address that a phone can open"},
      }};
}

fields::FieldList all_glaze_fields() {
  return {"glazes.toml",
          {
              id("glaze"),
              color("body", "the fired clay"),
              color("glass", "the glass over it"),
              color("slip", "clay of another colour under the glass", "no slip"),
              share("slip_cover", 1, "1 with a slip", "how well the slip hides the body"),
              share("brushed", 1, "0",
                    "0: dipped; 1: by a coarse brush, so that the body shows between"),
              share("pooling", 1, "0.75", "0: lies even; 1: runs deep into grooves and off ridges"),
              share("gloss", 1, "0.9", "0: matt; 1: like a mirror"),
              color("band", "a painted band round the pot, under the glass", "no band"),
              share("band_height", 1, "0.8", "the band's middle, as a share of the pot's height"),
              share("band_width", 0.2, "0.02", "its width, as a share of the pot's height"),
              settings::spoken_field("glaze.name", "its name", bounds::kGlazeName),
              settings::spoken_field("glaze.about", "what it looks like", bounds::kGlazeAbout),
          },
          {{.name = "glaze", .is_list = true, .words = "A glaze to choose in the kiln."}}};
}

fields::FieldList all_lesson_fields() {
  return {"lessons/*.toml",
          {
              id("step"),
              {.table = "step",
               .key = "hands",
               .words = "what the hands in its drawing do",
               .choices = {kHandsDrawn.begin(), kHandsDrawn.end()}},
              {.table = "step",
               .key = "until",
               .words = "what the visitor has done when it is over",
               .choices = {kDoneWhen.begin(), kDoneWhen.end()}},
              {.table = "step",
               .key = "after",
               .kind = FieldKind::number,
               .words = "it steps aside then, done or not",
               .least = kShortestStep,
               .most = kLongestStep,
               .unit = "s",
               .usual = "15"},
              settings::spoken_field("step.words", "what it says", bounds::kStepWords),
          },
          {{.name = "step", .is_list = true, .words = "A step of the lesson."}}};
}

}  // namespace

const fields::FieldList& vessel_fields() {
  static const fields::FieldList kList = all_vessel_fields();
  return kList;
}

const fields::FieldList& glaze_fields() {
  static const fields::FieldList kList = all_glaze_fields();
  return kList;
}

const fields::FieldList& lesson_fields() {
  static const fields::FieldList kList = all_lesson_fields();
  return kList;
}

}  // namespace onggi::content
