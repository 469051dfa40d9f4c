#include "kiosk/picture/drawing/pen.h"

#include <cairo/cairo-svg.h>
#include <pango/pangocairo.h>
#include <algorithm>

#include <cstdint>
#include <span>
#include <utility>

namespace onggi::drawing {
namespace {

cairo_status_t keep(void* user, const unsigned char* data, unsigned length) {
  const auto bytes = std::as_bytes(std::span(data, length));
  auto* out = static_cast<std::vector<std::byte>*>(user);
  out->insert(out->end(), bytes.begin(), bytes.end());
  return CAIRO_STATUS_SUCCESS;
}

/// To be unreferenced.
PangoLayout* laid_out(cairo_t* c, const std::string& words, const Lettering& how) {
  PangoLayout* layout = pango_cairo_create_layout(c);
  PangoFontDescription* font = pango_font_description_from_string(
      how.serif ? "Noto Serif,Noto Serif CJK KR,serif" : "Noto Sans,Noto Sans CJK KR,sans-serif");
  pango_font_description_set_absolute_size(font, how.px * PANGO_SCALE);
  pango_layout_set_font_description(layout, font);
  pango_font_description_free(font);
  if (how.width > 0) {
    pango_layout_set_width(layout, static_cast<int>(how.width) * PANGO_SCALE);
    pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
    if (how.lines > 0) {
      pango_layout_set_height(layout, -how.lines);
      pango_layout_set_ellipsize(layout, PANGO_ELLIPSIZE_END);
    }
  }
  pango_layout_set_text(layout, words.c_str(), static_cast<int>(words.size()));
  return layout;
}

}  // namespace

Pen::~Pen() {
  if (c_ != nullptr) cairo_destroy(c_);
  if (surface_ != nullptr) cairo_surface_destroy(surface_);
}

void Pen::begin(int width, int height, bool vector) {
  vector_ = vector;
  surface_ = vector ? cairo_svg_surface_create_for_stream(keep, &written_, width, height)
                    : cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
  c_ = cairo_create(surface_);
  cairo_set_line_cap(c_, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(c_, CAIRO_LINE_JOIN_ROUND);
  ink(kPaper);
  cairo_paint(c_);
}

void Pen::ink(view::Color color, double alpha) {
  cairo_set_source_rgba(c_, static_cast<double>(color.r), static_cast<double>(color.g),
                        static_cast<double>(color.b), alpha);
}

void Pen::line(double x0, double y0, double x1, double y1, double width) {
  cairo_set_line_width(c_, width);
  cairo_move_to(c_, x0, y0);
  cairo_line_to(c_, x1, y1);
  cairo_stroke(c_);
}

double Pen::height_of(const std::string& words, const Lettering& how) {
  PangoLayout* layout = laid_out(c_, words, how);
  int h = 0;
  pango_layout_get_pixel_size(layout, nullptr, &h);
  g_object_unref(layout);
  return h;
}

double Pen::words(const std::string& words, double x, double y, const Lettering& how) {
  PangoLayout* layout = laid_out(c_, words, how);
  int w = 0, h = 0;
  pango_layout_get_pixel_size(layout, &w, &h);
  cairo_save(c_);
  cairo_translate(c_, x, y);
  cairo_rotate(c_, how.turn);
  const double start = how.side < 0 ? -w : how.side == 0 ? -0.5 * w : 0.0;
  cairo_move_to(c_, start, 0.0);
  if (how.halo > 0) {
    ink(kPaper);
    pango_cairo_layout_path(c_, layout);
    cairo_set_line_width(c_, 2 * how.halo);
    cairo_stroke(c_);
    cairo_move_to(c_, start, 0.0);
  }
  ink(how.color);
  pango_cairo_show_layout(c_, layout);
  cairo_restore(c_);
  g_object_unref(layout);
  return h;
}

double Pen::width_of(const std::string& words, const Lettering& how) {
  PangoLayout* layout = laid_out(c_, words, how);
  int w = 0;
  pango_layout_get_pixel_size(layout, &w, nullptr);
  g_object_unref(layout);
  return w;
}

void Pen::picture(const view::Image& image, double x, double y) {
  // Cairo needs premultiplied colours, blue first.
  const int stride = cairo_format_stride_for_width(CAIRO_FORMAT_ARGB32, image.width);
  std::vector<unsigned char> bytes(static_cast<std::size_t>(stride) *
                                   static_cast<std::size_t>(image.height));
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const std::uint8_t* from =
          &image.rgba[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(column))];
      unsigned char* to = &bytes[static_cast<std::size_t>(row) * static_cast<std::size_t>(stride) +
                                 4 * static_cast<std::size_t>(column)];
      const auto scaled = [&](std::uint8_t v) {
        return static_cast<unsigned char>((static_cast<unsigned>(v) * from[3] + 127u) / 255u);
      };
      to[0] = scaled(from[2]);
      to[1] = scaled(from[1]);
      to[2] = scaled(from[0]);
      to[3] = from[3];
    }
  // Cairo owns it, because a vector page reads it when it is finished.
  cairo_surface_t* laid =
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height);
  cairo_surface_flush(laid);
  if (unsigned char* const own = cairo_image_surface_get_data(laid); own != nullptr)
    std::ranges::copy(bytes, own);
  cairo_surface_mark_dirty(laid);
  cairo_set_source_surface(c_, laid, x, y);
  cairo_paint(c_);
  cairo_surface_destroy(laid);
}

view::Image Pen::image() const {
  cairo_surface_flush(surface_);
  view::Image out;
  out.width = cairo_image_surface_get_width(surface_);
  out.height = cairo_image_surface_get_height(surface_);
  const int stride = cairo_image_surface_get_stride(surface_);
  const unsigned char* from = cairo_image_surface_get_data(surface_);
  out.rgba.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) * 4);
  for (int row = 0; row < out.height && from != nullptr; ++row)
    for (int column = 0; column < out.width; ++column) {
      const unsigned char* p = from + static_cast<std::ptrdiff_t>(row) * stride + 4 * column;
      std::uint8_t* to =
          &out.rgba[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(out.width) +
                         static_cast<std::size_t>(column))];
      to[0] = p[2];
      to[1] = p[1];
      to[2] = p[0];
      to[3] = 255;
    }
  return out;
}

std::vector<std::byte> Pen::bytes() {
  if (vector_)
    cairo_surface_finish(surface_);
  else
    cairo_surface_write_to_png_stream(surface_, keep, &written_);
  return std::move(written_);
}

}  // namespace onggi::drawing
