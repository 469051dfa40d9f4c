#include "kiosk/picture/render/text.h"

#include <pango/pangocairo.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <vector>

#include "kiosk/collection/settings/visitor_text.h"
#include "kiosk/picture/render/font_coverage.h"

namespace onggi::render {
namespace {

constexpr std::size_t kMostSizes = 4096;

// Marks after which a Chinese or Japanese list may break: commas, full stop, colon, semicolon,
// three bytes each.
constexpr std::array<const char*, 5> kListStops{"\u3001", "\uFF0C", "\u3002", "\uFF1A", "\uFF1B"};

// Everything that affects the look of a paragraph except its colour, which the shader sets.
std::string key_of(const std::string& text, const view::TextStyle& s, float width) {
  char head[64];
  std::snprintf(head, sizeof head, "%d %.2f %d %d %d %.3f %.1f ", static_cast<int>(s.face),
                static_cast<double>(s.px), s.bold ? 1 : 0, s.right_to_left ? 1 : 0,
                static_cast<int>(s.align), static_cast<double>(s.line_height),
                static_cast<double>(std::max(width, 0.0f)));
  return head + s.language + '\n' + text;
}

// Units that stay on the line of their number.
constexpr std::array<const char*, 9> kUnits{"mm", "cm", "m", "l", "s", "%", "مم", "سم", "ل"};

// The families of one style, best script first. fontconfig finds other scripts itself.
std::string families(const view::TextStyle& s) {
  const bool serif = s.face == view::Face::serif;
  std::string out = serif ? "Noto Serif" : "Noto Sans";
  const std::string cjk = serif ? "Noto Serif CJK " : "Noto Sans CJK ";
  const std::string two = s.language.substr(0, 2);
  out += two == "ja"   ? "," + cjk + "JP"
         : two == "zh" ? "," + cjk + (s.language.find("Hant") != std::string::npos ? "TC" : "SC")
                       : "," + cjk + "KR";
  out += serif ? ",Noto Naskh Arabic,Noto Serif Hebrew,Noto Serif Devanagari,Noto Serif Thai"
               : ",Noto Sans Arabic,Noto Sans Hebrew,Noto Sans Devanagari,Noto Sans Thai";
  return out + (serif ? ",serif" : ",sans-serif");
}

// The part of a mask with ink: its bytes, and its place in `block`.
std::vector<std::uint8_t> ink_of(const unsigned char* from, std::size_t stride, int w, int h,
                                 Typesetter::Block& block) {
  int left = w, right = 0, top = h, bottom = 0;
  for (int y = 0; y < h && from != nullptr; ++y) {
    const unsigned char* row = from + static_cast<std::size_t>(y) * stride;
    for (int x = 0; x < w; ++x) {
      if (row[x] == 0) continue;
      left = std::min(left, x);
      right = std::max(right, x + 1);
      top = std::min(top, y);
      bottom = y + 1;
    }
  }
  std::vector<std::uint8_t> mask;
  if (right <= left) return mask;
  block.x = left;
  block.y = top;
  block.w = right - left;
  block.h = bottom - top;
  for (int y = top; y < bottom; ++y) {
    const unsigned char* row = from + static_cast<std::size_t>(y) * stride;
    mask.insert(mask.end(), row + left, row + right);
  }
  return mask;
}

/// The part of `text` that is shaped. A file may contain anything, but a frame must not wait for
/// it.
std::string shapeable(const std::string& text) {
  std::size_t end = text.size();
  if (end > Typesetter::kMostBytes) {
    end = Typesetter::kMostBytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
  }
  std::string out =
      FontCoverage::here().boxed(settings::with_breaks(std::string_view(text).substr(0, end)));
  return end < text.size() ? out + "…" : out;
}

void keep_together(std::size_t start, std::size_t end, PangoAttrList* attributes) {
  constexpr std::size_t kLongest = 36;  // bytes: twelve syllables
  if (end <= start + 1 || end - start > kLongest) return;
  PangoAttribute* keep = pango_attr_allow_breaks_new(FALSE);
  keep->start_index = static_cast<guint>(start);
  keep->end_index = static_cast<guint>(end);
  pango_attr_list_insert(attributes, keep);
}

void keep_units(const std::string& text, PangoAttrList* attributes) {
  const auto letter = [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0;
  };
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] != ' ' || std::isdigit(static_cast<unsigned char>(text[i - 1])) == 0) continue;
    for (const char* unit : kUnits) {
      const std::size_t end = i + 1 + std::strlen(unit);
      const bool same = text.compare(i + 1, end - i - 1, unit) == 0;
      if (same && (end >= text.size() || !letter(text[end]))) keep_together(i - 1, end, attributes);
    }
  }
}

// Korean may break inside a word. Museum labels avoid that, because it reads better.
void keep_korean_words(const std::string& text, PangoAttrList* attributes) {
  std::size_t start = 0;
  while (start < text.size()) {
    const std::size_t end = std::min(text.find_first_of(" \n\t", start), text.size());
    keep_together(start, end, attributes);
    start = end + 1;
  }
}

// Chinese and Japanese may break between any two letters, and running text does. A line of a label
// ("Japan, Edo period") is a list: it breaks only after its commas, at its spaces, and before
// brackets.
void keep_parts_of_a_list(const std::string& text, PangoAttrList* attributes) {
  constexpr std::size_t kLongestList = 90;  // bytes: thirty letters
  if (text.size() > kLongestList) return;
  std::size_t start = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool space = text[i] == ' ' || text[i] == '\n';
    const bool wide = std::any_of(kListStops.begin(), kListStops.end(), [&](const char* stop) {
      return text.compare(i, std::strlen(stop), stop) == 0;
    });
    const bool bracket = text.compare(i, 3, "\uFF08") == 0;
    if (!space && !wide && !bracket) continue;
    const std::size_t end = space || bracket ? i : i + 3;
    keep_together(start, end, attributes);
    start = space ? i + 1 : end;
    if (wide) i += 2;
  }
  keep_together(start, text.size(), attributes);
}

}  // namespace

struct Typesetter::Pango {
  PangoFontMap* map = pango_cairo_font_map_new();
  PangoContext* context = pango_font_map_create_context(map);

  Pango() {
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_SLIGHT);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_ON);
    pango_cairo_context_set_font_options(context, options);
    cairo_font_options_destroy(options);
  }
  ~Pango() {
    g_object_unref(context);
    g_object_unref(map);
  }

  PangoLayout* layout(const std::string& whole, const view::TextStyle& s, float width) const {
    const std::string text = shapeable(whole);
    PangoLayout* layout = pango_layout_new(context);
    PangoFontDescription* font = pango_font_description_from_string(families(s).c_str());
    pango_font_description_set_absolute_size(font, std::round(s.px * PANGO_SCALE));
    pango_font_description_set_weight(font, s.bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    pango_layout_set_font_description(layout, font);
    pango_font_description_free(font);
    PangoAttrList* attributes = pango_attr_list_new();
    pango_attr_list_insert(attributes, pango_attr_font_features_new("tnum=1"));
    pango_attr_list_insert(attributes,
                           pango_attr_language_new(pango_language_from_string(s.language.c_str())));
    pango_attr_list_insert(attributes, pango_attr_insert_hyphens_new(FALSE));
    // An absolute line height, so that a taller fallback font does not move lines.
    pango_attr_list_insert(attributes, pango_attr_line_height_new_absolute(static_cast<int>(
                                           std::round(s.px * s.line_height) * PANGO_SCALE)));
    keep_units(text, attributes);
    const std::string two = s.language.substr(0, 2);
    if (two == "ko") keep_korean_words(text, attributes);
    if (two == "ja" || two == "zh") keep_parts_of_a_list(text, attributes);
    pango_layout_set_attributes(layout, attributes);
    pango_attr_list_unref(attributes);
    pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
    // A hint that begins with a number or a Latin word is still a right-to-left paragraph.
    pango_layout_set_auto_dir(layout, s.right_to_left ? FALSE : TRUE);
    pango_context_set_base_dir(context,
                               s.right_to_left ? PANGO_DIRECTION_RTL : PANGO_DIRECTION_LTR);
    // In Pango, left means start if it takes the direction from the letters. Pango reverses that
    // itself.
    const auto start = s.right_to_left ? PANGO_ALIGN_RIGHT : PANGO_ALIGN_LEFT;
    const auto end = s.right_to_left ? PANGO_ALIGN_LEFT : PANGO_ALIGN_RIGHT;
    pango_layout_set_alignment(layout, s.align == view::Align::centre ? PANGO_ALIGN_CENTER
                                       : s.align == view::Align::end  ? end
                                                                      : start);
    if (width > 0) pango_layout_set_width(layout, static_cast<int>(std::ceil(width)) * PANGO_SCALE);
    pango_layout_set_text(layout, text.c_str(), static_cast<int>(text.size()));
    return layout;
  }
};

Typesetter::Typesetter() : pango_(std::make_unique<Pango>()) {}
Typesetter::~Typesetter() = default;

view::TextMeasure::Size Typesetter::measure(const std::string& text, const view::TextStyle& style,
                                            float width) const {
  const std::string key = key_of(text, style, width);
  const auto found = sizes_.find(key);
  if (found != sizes_.end()) return found->second;
  if (sizes_.size() >= kMostSizes) sizes_.clear();
  PangoLayout* layout = pango_->layout(text, style, width);
  PangoRectangle logical;
  pango_layout_get_pixel_extents(layout, nullptr, &logical);
  g_object_unref(layout);
  return sizes_[key] = {static_cast<float>(logical.width), static_cast<float>(logical.height)};
}

const Typesetter::Block& Typesetter::set(const std::string& text, const view::TextStyle& style,
                                         float width) {
  std::string key = key_of(text, style, width);
  if (const auto found = blocks_.find(key); found != blocks_.end()) {
    if (found->second.w > 0) masks_.use(found->second.mask.page);
    return found->second;
  }

  PangoLayout* layout = pango_->layout(text, style, width);
  PangoRectangle logical;
  pango_layout_get_pixel_extents(layout, nullptr, &logical);
  Block block;
  // Pixels around the layout's box, for overhanging ink.
  const int pad = static_cast<int>(std::ceil(0.4f * style.px));
  block.width = static_cast<float>(logical.width);
  block.height = static_cast<float>(logical.height);
  const int box = width > 0 ? static_cast<int>(std::ceil(width)) : 0;
  const int w = std::clamp(std::max(box, logical.x + logical.width) + 2 * pad, 1, 8192);
  const int h = std::clamp(logical.height + 2 * pad, 1, 8192);
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_A8, w, h);
  cairo_t* cairo = cairo_create(surface);
  cairo_set_source_rgba(cairo, 1, 1, 1, 1);
  cairo_move_to(cairo, pad, pad);
  pango_cairo_show_layout(cairo, layout);
  cairo_destroy(cairo);
  cairo_surface_flush(surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  const std::vector<std::uint8_t> mask =
      ink_of(cairo_image_surface_get_data(surface), stride, w, h, block);
  cairo_surface_destroy(surface);
  g_object_unref(layout);
  block.x -= pad;
  block.y -= pad;
  if (block.w > 0) {
    while (const std::uint32_t gone = masks_.drop_one())
      std::erase_if(blocks_, [gone](const auto& one) {
        return one.second.w > 0 && one.second.mask.page == gone;
      });
    block.mask = masks_.add(block.w, block.h, mask.data());
  }
  return blocks_[std::move(key)] = block;
}

}  // namespace onggi::render
