#include "kiosk/collection/content/pack_writer.h"

#include <cstdio>
#include <sstream>

#include "engine/profile/up.h"
#include "kiosk/collection/content/address.h"
#include "kiosk/collection/content/pack_advice.h"
#include "kiosk/collection/textures/srgb.h"

namespace onggi::content {

namespace {

/// A TOML basic string on one line.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    const auto byte = static_cast<unsigned char>(c);
    out += byte < 0x20 || byte == 0x7F ? ' ' : c;
  }
  return out + "\"";
}

/// `key = "value"`, or a comment line with an example if the value is not known.
std::string line(const char* key, const std::string& value, const char* example) {
  if (value.empty()) return std::string("# ") + key + " = " + quoted(example) + "\n";
  return std::string(key) + " = " + quoted(value) + "\n";
}

std::string first_words(const std::string& text, int most) {
  std::istringstream in(text);
  std::string out, word;
  for (int i = 0; i < most && in >> word; ++i) out += (i == 0 ? "" : " ") + word;
  return out;
}

double srgb(float linear) { return textures::srgb_of_light(static_cast<double>(linear)); }

/// The label in that language; the English one also gets the facts without a language.
std::string label_toml(const Vessel& vessel, const std::string& language) {
  const bool english = language == "en";
  const GltfCredit nothing;
  const GltfCredit& given = english ? vessel.given : nothing;
  std::string out = "[label." + language + "]\n";
  out += "title = " + quoted(vessel.label(language).title) + "\n";
  out += line("what", "", "A pharmacy jar");
  out += line("culture", given.culture, "Korea, Joseon dynasty");
  out += line("date", given.date, "18th century");
  out += line("made", "", "How it was made, in one sentence. If it was never thrown, say so.");
  out += line("text", first_words(given.description, kMostLabelWords),
              "At most 100 words. Short sentences: visitors stand while they read.");
  return out;
}

}  // namespace

std::string pack_toml(const Vessel& vessel) {
  std::string out =
      "# From " + vessel.file.filename().string() +
      ". Complete the lines that begin with # and remove the #.\n"
      "# Every key: kiosk/docs/add_a_vessel.md\n\n"
      "unfinished = true   # visitors do not see it; remove this line when all is written\n";
  char text[160];
  if (vessel.true_height > 0.0)
    std::snprintf(text, sizeof text, "true_height_mm = %.1f\n", 1000.0 * vessel.true_height);
  else
    std::snprintf(
        text, sizeof text,
        "# true_height_mm = %.0f         # of the real vessel: measure it. The file's own "
        "height is %.6g units.\n",
        1000.0 * vessel.extracted.profile.height(),
        vessel.extracted.profile.height() / vessel.unit);
  out += text;
  out += "# units = \"mm\"                 # of the mesh, where the height is not known\n";
  if (vessel.extracted.up_from == UpFrom::given)
    out += "up = " + quoted(extraction::axis_name(vessel.extracted.axis_direction)) + "\n";
  else if (vessel.extracted.up_sure < ExtractedProfile::kSureUp)
    out += "# up = " + quoted(extraction::axis_name(-vessel.extracted.axis_direction)) +
           "                    # if it is upside down now\n";
  out += line("institution", vessel.given.institution, "The museum that has it");
  out += line("accession", vessel.given.accession, "Its number there");
  out += line("source", vessel.source, "Where the figures are published");
  // A scan's address is seldom the museum's page, so it is only suggested in a comment.
  const bool page = fault_of_address(vessel.given.source).empty();
  out += line("address", vessel.address.empty() ? vessel.given.address : vessel.address,
              page ? vessel.given.source.c_str() : "https://the.museum/its-page-on-this-vessel");
  out += "credit = " + quoted(vessel.credit.empty() ? "not known" : vessel.credit) + "\n";
  out += "licence = " + quoted(vessel.licence.empty() ? kLicenceNotKnown : vessel.licence) + "\n";
  std::snprintf(text, sizeof text, "%scolor = [%.2f, %.2f, %.2f]      # as on a screen, 0 to 1%s\n",
                vessel.coloring.empty() ? "" : "# ", srgb(vessel.color[0]), srgb(vessel.color[1]),
                srgb(vessel.color[2]),
                vessel.coloring.empty() ? "" : "; instead of the scan's own colours");
  out += text;
  out += "\n# A label in each language of the exhibit.\n";
  out += label_toml(vessel, "en");
  for (const auto& [language, title] : vessel.given.titles)
    if (language != "en") out += "\n" + label_toml(vessel, language);
  return out;
}

}  // namespace onggi::content
