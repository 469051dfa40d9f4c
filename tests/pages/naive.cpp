#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "kiosk/ground/files/paths.h"
#include "kiosk/picture/drawing/put_report.h"
#include "tests/pages/naive_text.h"
#include "tests/pages/page_program.h"

namespace onggi::pages {

namespace {

struct NaiveArguments {
  std::string config, seconds = "30,60,90,120", vessels, pointer = "mouse";
  files::Output json{files::Output::Kind::json};
  measure::NaivePlan plan;
};

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from < list.size();) {
    const std::size_t to = std::min(list.find(',', from), list.size());
    if (to > from) parts.push_back(list.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

Result<std::vector<double>> moments_of(const std::string& list) {
  std::vector<double> moments;
  for (const std::string& part : split(list)) {
    char* end = nullptr;
    const double value = std::strtod(part.c_str(), &end);
    const bool rising = moments.empty() || value > moments.back();
    if (*end != '\0' || !(value >= 5 && value <= 600) || !rising)
      return problem("--seconds " + list, "This is not a list of rising seconds, each 5 to 600.",
                     "Write 30,60,90,120.");
    moments.push_back(value);
  }
  if (moments.empty()) return problem("--seconds", "The list is empty.", "Write 30,60,90,120.");
  return moments;
}

Result<int> naive(NaiveArguments& arguments) {
  const auto moments = moments_of(arguments.seconds);
  if (!moments) return tl::unexpected(moments.error());
  if (arguments.pointer != "mouse" && arguments.pointer != "finger")
    return problem("--pointer " + arguments.pointer, "Unknown --pointer.",
                   "Use --pointer mouse or --pointer finger.");
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  measure::NaivePlan plan = arguments.plan;
  plan.exhibit_file = config->string();
  plan.moments = *moments;
  plan.vessels = split(arguments.vessels);
  if (arguments.pointer == "finger") plan.pointer = rehearsal::NaiveHands::Pointer::finger;
  const auto table = measure::measure_naive(plan, stderr);
  if (!table) return tl::unexpected(table.error());
  const auto free = drawing::put_report(json_of(*table), arguments.json);
  if (!free) return tl::unexpected(free.error());
  if (*free) std::fputs(text_of(*table).c_str(), stdout);
  return 0;
}

}  // namespace
}  // namespace onggi::pages

int main(int argc, char** argv) {
  onggi::pages::NaiveArguments a;
  return onggi::pages::run_page_program(
      {.name = "onggi_page_naive",
       .help = "Measure what beginners throw: points, roughness, and how soon it looks good",
       .examples =
           "Example: build/release/bin/onggi_page_naive --json naive.json\n"
           "         build/release/bin/onggi_page_naive --vessels moon_jar,tea_bowl --seeds 5 "
           "--pointer finger\n"
           "         build/release/bin/onggi_page_naive --scene config/scenes/studio.toml "
           "--seconds 90 --careful\n"
           "It uses the real screens and clay without drawing, 4 s a visit. onggi visit --script "
           "naive draws a visit.",
       .options = {{.name = "--seeds",
                    .field = &a.plan.seeds,
                    .help = "Visits for each vessel [20]",
                    .least = 1,
                    .most = 10000},
                   {.name = "--first",
                    .field = &a.plan.first,
                    .help = "Seed of the first [1]",
                    .least = 0},
                   {"--seconds", &a.seconds, "When pots are judged [30,60,90,120]"},
                   {"--pointer", &a.pointer, "mouse or finger [mouse]"},
                   {"--vessels", &a.vessels, "Some of the shelf, with commas [all]"},
                   {"--scene", &a.plan.scene, "A scene's TOML instead of the exhibit's"},
                   {"--careful", &a.plan.careful,
                    "Also run the script's hand, once for each vessel"},
                   {.name = "--threads",
                    .field = &a.plan.threads,
                    .help = "Visits at a time [1]",
                    .least = 1,
                    .most = 256},
                   {"--json", &a.json, "Write every visit as JSON (- for standard output)"},
                   {"--config", &a.config, "The exhibit's TOML [config/exhibit.toml]"}},
       .run = [&a] { return onggi::pages::naive(a); }},
      argc, argv);
}
