#include "kiosk/collection/settings/rubric.h"

#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::settings {

namespace {

void read_part(toml::TomlReader::Table table, Rubric::Part& part, double most, const char* unit) {
  table.number("share", part.share, 0.0, 1.0);
  table.number("half", part.half, 0.001 * most, most, unit);
  table.finish();
}

}  // namespace

RubricRead read_rubric(const std::filesystem::path& file) {
  RubricRead read;
  Rubric& r = read.rubric;
  toml::TomlReader reader(file);
  auto root = reader.root();
  root.boolean("size_counts", r.size_counts);
  std::vector<double> stars;
  if (root.numbers("stars", stars)) {
    bool rising = stars.size() == 4;
    for (std::size_t i = 0; i < stars.size() && rising; ++i)
      rising = stars[i] > 0.0 && stars[i] <= 100.0 && (i == 0 || stars[i] > stars[i - 1]);
    if (rising)
      for (std::size_t i = 0; i < 4; ++i) r.stars[i] = stars[i];
    else
      root.complain("stars", "stars is not four rising numbers up to 100.",
                    "Write the points for two, three, four and five stars: [40, 65, 88, 96].");
  }
  read_part(root.child("outline"), r.outline, 1.0, "");
  read_part(root.child("volume"), r.volume, 1.0, "");
  read_part(root.child("belly"), r.belly, 1.0, "");
  read_part(root.child("mouth"), r.mouth, 1.0, "");
  read_part(root.child("neck"), r.neck, 1.0, "");
  read_part(root.child("foot"), r.foot, 1.0, "");
  read_part(root.child("curvature"), r.curvature, 180.0, "degrees");
  read_part(root.child("opening"), r.opening, 1.0, "");
  read_part(root.child("wall"), r.wall, 1.0, "");
  read_part(root.child("round"), r.round, 0.1, "");
  read_part(root.child("height"), r.height, 1.0, "");
  auto worst = root.child("worst");
  worst.number("limit", r.worst.limit, 0.005, 1.0);
  worst.number("points", r.worst.points, 1.0, 99.9);
  worst.finish();
  root.finish();
  read.problems = reader.problems();
  read.keys_checked = reader.keys_checked();
  return read;
}

}  // namespace onggi::settings
