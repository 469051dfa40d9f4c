#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/base/plain_text.h"
#include "engine/scene/lump.h"
#include "kiosk/collection/content/language.h"
#include "kiosk/collection/score/likeness.h"
#include "kiosk/collection/score/score.h"
#include "kiosk/collection/settings/rubric.h"
#include "kiosk/exhibit/rehearsal/visit_report.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/picture/drawing/put_report.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/program/commands/score_files.h"

namespace fs = std::filesystem;

namespace onggi::commands {

namespace {

using files::Json;

struct ScoreArguments {
  files::Output json{files::Output::Kind::json};
  std::string target, pot, target_node, pot_node, rubric, language = "en";
  bool size_counts = false;
};

/// The named rubric, else config/rubric.toml of the program, else the built-in one.
Result<settings::Rubric> rubric_for(const std::string& named) {
  fs::path file = named;
  if (named.empty()) {
    const auto root = files::program_root();
    std::error_code ignored;
    if (root) file = *root / "config" / "rubric.toml";
    if (!root || !fs::is_regular_file(file, ignored)) return settings::Rubric{};
  }
  const settings::RubricRead read = settings::read_rubric(file);
  if (!read.problems.empty()) return tl::unexpected(read.problems.front());
  return read.rubric;
}

Result<content::Language> words_for(const std::string& code) {
  const auto root = files::program_root();
  if (!root) return tl::unexpected(root.error());
  const fs::path file = *root / "content" / "languages" / (code + ".toml");
  std::error_code ignored;
  if (code.find('/') != std::string::npos || !fs::is_regular_file(file, ignored))
    return problem("--language " + code.substr(0, 20), "There are no words in this language.",
                   "Name a file of content/languages without its ending, such as en.");
  return content::Language::read(file);
}

double degrees(double radians) { return radians * 57.29577951308232; }

Json json_of(const score::Remark& remark, const content::Language& words) {
  Json out = Json::object({{"key", remark.key}});
  for (const auto& [place, value] : remark.places) out[place] = std::stol(value);
  out["words"] = words.say(remark.key, remark.places);
  return out;
}

Json json_of(const Shape& shape) {
  Json out = Json::object({{"file", shape.file}, {"kind", shape.kind}});
  if (!shape.node.empty()) out["node"] = shape.node;
  out["height_m"] = shape.profile.height();
  out["size_known"] = shape.true_size;
  return out;
}

Json report_of(const Shape& target, const Shape& pot, const score::Score& score, bool size_counts,
               const content::Language& words) {
  const auto list = [&words](const std::vector<score::Remark>& remarks) {
    Json out = Json::list();
    for (const score::Remark& r : remarks) out.push_back(json_of(r, words));
    return out;
  };
  return Json::object(
      {{"target", json_of(target)},
       {"pot", json_of(pot)},
       {"score", score.points},
       {"likeness", score::likeness(target.profile, pot.profile)},
       {"turning_apart_degrees", degrees(score::turning_apart(target.profile, pot.profile))},
       {"stars", score.stars},
       {"size_counts", size_counts},
       {"words", score.largest ? words.say(score.largest->key, score.largest->places) : ""},
       {"largest", score.largest ? json_of(*score.largest, words) : Json()},
       {"measures", rehearsal::json_of(score.measures)},
       {"alike", list(score.alike)},
       {"try_next", list(score.try_next)}});
}

/// Prints millimetres of the real vessel; a metre on the wheel is `true_scale` metres of it.
void print_summary(const Shape& target, const Shape& pot, const score::Score& score,
                   double true_scale, const content::Language& words) {
  const Measures& m = score.measures;
  // Without a known size, print shares of the height.
  const bool known = target.true_size;
  const double each = known ? 1000.0 * true_scale : 100.0 / m.target.height;
  const double high = each * m.target.height;
  const char* unit = known ? "mm" : "% of the height";
  std::printf("%s\n  as an answer to %s: %.1f of 100, %d of 5 stars\n",
              terminal::plain(pot.file).c_str(), terminal::plain(target.file).c_str(), score.points,
              score.stars);
  if (score.largest)
    std::printf("  %s\n", words.say(score.largest->key, score.largest->places).c_str());
  if (m.scale != 1.0) std::printf("  The pot is compared at %.3g of its size.\n", m.scale);
  std::printf("  likeness %.1f of 100: the outlines run %.1f degrees apart\n",
              score::likeness(target.profile, pot.profile),
              degrees(score::turning_apart(target.profile, pot.profile)));
  std::printf(
      "  outline: RMS %.1f %s, worst %.1f %s at %.0f %% of the height; %.1f %% of the volume is "
      "shared\n",
      m.outline_rms * high, unit, m.common_firm * high, unit, 100.0 * m.common_firm_at,
      100.0 * m.volume_overlap);
  const auto row = [each, unit](const char* name, double wanted, double made) {
    std::printf("  %-13s %7.1f %s, made %7.1f %s, %+.1f\n", name, each * wanted, unit, each * made,
                unit, each * (made - wanted));
  };
  row("height", m.target.height, m.made.height);
  row("belly", m.target.belly, m.made.belly);
  row("mouth", m.target.mouth, m.made.mouth);
  row("neck", m.target.neck, m.made.neck);
  row("foot", m.target.foot, m.made.foot);
  if (m.target.opening > 0.0)
    std::printf("  the way in is open by %.0f %% of the width, made %.0f %%\n",
                100.0 * m.target.opening, 100.0 * m.made.opening);
  std::printf("  wall evenness %.2f, made %.2f; turning %.1f degrees apart\n",
              m.target.wall_evenness, m.made.wall_evenness, degrees(m.turning_rms));
}

Result<int> compare_files(const ScoreArguments& arguments) {
  const auto target = read_shape(arguments.target, arguments.target_node);
  if (!target) return tl::unexpected(target.error());
  const auto pot = read_shape(arguments.pot, arguments.pot_node);
  if (!pot) return tl::unexpected(pot.error());
  const auto rubric = rubric_for(arguments.rubric);
  if (!rubric) return tl::unexpected(rubric.error());
  const auto words = words_for(arguments.language);
  if (!words) return tl::unexpected(words.error());

  const bool size_counts = arguments.size_counts || rubric->size_counts;
  // A kept pot was thrown and scored against the vessel at a size that hands can reach.
  const double scale = pot->kind == "replay" ? workspace_scale(target->profile) : 1.0;
  const score::Score score =
      score::judge(scaled(target->profile, scale), pot->profile, !size_counts,
                   target->true_size ? 1.0 / scale : 0.0, *rubric);
  const auto free =
      drawing::put_report(report_of(*target, *pot, score, size_counts, *words), arguments.json);
  if (!free) return tl::unexpected(free.error());
  if (*free) print_summary(*target, *pot, score, 1.0 / scale, *words);
  return 0;
}

}  // namespace

cli::Command score_command() {
  const auto a = std::make_shared<ScoreArguments>();
  return {
      .name = "score",
      .help = "Compare two vessels: how alike they are, and where they differ",
      .examples =
          "Example: onggi score content/vessels/moon_jar scan.glb --json -\n"
          "Each may be a GLB, a glTF, a vessel's folder, a drawing's TOML or a visit.onggi.\n"
          "config/rubric.toml sets the points; kiosk/docs/score.md explains the measures.",
      .options =
          {{.name = "target", .field = &a->target, .help = "The vessel to copy", .required = true},
           {.name = "pot", .field = &a->pot, .help = "The pot that was made", .required = true},
           {"--target-node", &a->target_node,
            "The node to use as target, if the file holds several"},
           {"--pot-node", &a->pot_node, "The node to use as pot, if the file holds several"},
           {"--size-counts", &a->size_counts, "Do not scale the pot to the target's height first"},
           {"--rubric", &a->rubric, "Another rubric [config/rubric.toml]"},
           {"--language", &a->language, "Language of the words [en]"},
           {"--json", &a->json, "Write everything as JSON (- for standard output)"}},
      .run = [a] { return compare_files(*a); }};
}

}  // namespace onggi::commands
