#include "kiosk/visit/screens/wall_section.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "kiosk/collection/settings/text_in.h"
#include "kiosk/visit/screens/light_color.h"

namespace onggi::screens {

namespace {

constexpr double kThinnest = 2e-6;    // m: less is not told
constexpr double kClay = 3e-4;        // m of clay that is drawn below the layers
constexpr double kFullCoat = 0.0005;  // m of glaze, a coat of 1
constexpr float kDense = 1.15f;       // of its glass, as in clay.glsl
constexpr float kLine = 1.9f;         // of body text: the height of a row

struct Part {
  std::string words;
  view::Color color;
  double thickness = 0;  // m
};

std::string microns(double metres) { return std::to_string(std::lround(1e6 * metres)); }

/// From outside to inside; the last is the clay.
std::vector<Part> parts_of(const Desk& desk, const decoration::Way& way,
                           const decorating::Layers& layers, const content::Glaze& glaze) {
  std::vector<Part> parts;
  const auto add = [&](const std::string& name, const content::LinearColor& color, double thick) {
    if (thick < kThinnest) return;
    parts.push_back(
        {desk.say("kiln.layer", {{"name", name}, {"um", microns(thick)}}), display(color), thick});
  };
  const bool on_slip = !layers.slips.empty();
  const content::LinearColor below =
      on_slip ? way.palette.pigments[static_cast<std::size_t>(layers.slips.back().pigment)].fired
              : glaze.look.body;
  add(glaze.name_in(desk.words().code()), seen_through(glaze.look, below, on_slip, layers.glaze),
      layers.glaze);
  for (auto slip = layers.slips.rbegin(); slip != layers.slips.rend(); ++slip) {
    const auto n = static_cast<std::size_t>(slip->pigment);
    add(settings::text_in(way.pigments[n].name, desk.words().code()), way.palette.pigments[n].fired,
        slip->thickness);
  }
  parts.push_back({layers.cut < kThinnest
                       ? desk.say("kiln.clay")
                       : desk.say("kiln.clay_cut", {{"um", microns(layers.cut)}}),
                   display(glaze.look.body), kClay});
  return parts;
}

}  // namespace

content::LinearColor seen_through(const content::GlazeLook& look, content::LinearColor below,
                                  bool on_slip, double thickness) {
  const auto coat = static_cast<float>(std::clamp(thickness / kFullCoat, 0.05, 1.8));
  const float cover = on_slip ? 0.0f : look.slip_cover * std::min((coat + 0.02f) * 1.9f, 1.0f);
  for (std::size_t k = 0; k < below.size(); ++k)
    below[k] = std::lerp(below[k], look.slip[k], cover) *
               std::pow(std::max(look.glass[k], 1e-4f), kDense * coat);
  return below;
}

void lay_out_wall_section(Column& column, const Desk& desk, const decoration::Way& way,
                          const decorating::Layers& layers, const content::Glaze& glaze) {
  Page& page = column.page();
  const TypeScale& t = page.type();
  const std::vector<Part> parts = parts_of(desk, way, layers, glaze);
  double whole = 0;
  for (const Part& part : parts) whole += part.thickness;
  const float line = kLine * t.body, high = line * static_cast<float>(parts.size());
  const double pixels = high / whole;  // a metre
  const settings::Exhibit::Screen& screen = desk.screen();
  const double pixels_of_glass =
      1000.0 * std::hypot(page.width(), page.height()) / screen.diagonal_mm;
  column.text(desk.say("kiln.section_title",
                       {{"times", std::to_string(std::lround(pixels / pixels_of_glass))}}),
              t.body);
  column.space(t.gap);

  const view::Rect rest = column.rest();
  const float wide = 2.0f * t.body, swatch = 0.8f * t.body, apart = 0.6f * t.body;
  const auto turned = [&](float x, float width) {
    return page.right_to_left() ? 2 * rest.x + rest.w - x - width : x;
  };
  float bar = rest.y, row = rest.y;
  const auto style = page.style(view::Face::sans, t.body);
  const float left = rest.x + wide + apart, text = left + swatch + 0.5f * apart;
  for (const Part& part : parts) {
    const auto thick = static_cast<float>(part.thickness * pixels);
    page.draw(view::Box{{turned(rest.x, wide), bar, wide, thick}, 0, part.color, 0, {}});
    page.draw(view::Box{{turned(left, swatch), row + (line - swatch) / 2, swatch, swatch},
                        0.2f * swatch,
                        part.color,
                        t.hairline,
                        view::kFaintInk});
    const float width = rest.x + rest.w - text;
    const auto size = page.size(part.words, style, width);
    if (size.width > width + 1 || size.height > line) page.overflowed();
    page.words({turned(text, width), row + (line - size.height) / 2, width, size.height},
               part.words, style, view::kInk);
    page.tell(row, part.words);
    bar += thick, row += line;
  }
  page.draw(view::Box{{turned(rest.x, wide), rest.y, wide, high},
                      0,
                      view::with_alpha(view::kInk, 0),
                      t.hairline,
                      view::kInk});
  column.space(high);
  column.check();
}

}  // namespace onggi::screens
