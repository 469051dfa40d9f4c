#include "kiosk/picture/drawing/plot.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

#include "kiosk/picture/drawing/plot_scale.h"

namespace onggi::drawing::plot_test {
namespace {

using Kind = PlotSeries::Kind;

struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bgra;
  bool is(int x, int y, int r, int g, int b) const {
    const std::uint8_t* p = &bgra[4 * static_cast<std::size_t>(y * width + x)];
    return std::abs(p[2] - r) < 12 && std::abs(p[1] - g) < 12 && std::abs(p[0] - b) < 12;
  }
  bool paper(int x, int y) const { return is(x, y, 251, 248, 242); }
  int count(int r, int g, int b) const {
    int n = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) n += is(x, y, r, g, b);
    return n;
  }
  /// Uppermost row with this colour in columns from..to; height where there is none.
  int top_of(int r, int g, int b, int from, int to) const {
    for (int y = 0; y < height; ++y)
      for (int x = from; x < to; ++x)
        if (is(x, y, r, g, b)) return y;
    return height;
  }
};

Pixels drawn(const Plot& plot) {
  const std::vector<std::byte> png = draw_plot(plot, "a.png");
  std::span<const std::byte> rest = png;
  const auto read = [](void* user, unsigned char* to, unsigned n) {
    auto* from = static_cast<std::span<const std::byte>*>(user);
    if (from->size() < n) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(to, from->data(), n);
    *from = from->subspan(n);
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_t* surface = cairo_image_surface_create_from_png_stream(read, &rest);
  Pixels out{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  EXPECT_EQ(cairo_surface_status(surface), CAIRO_STATUS_SUCCESS);
  const unsigned char* data = cairo_image_surface_get_data(surface);
  out.bgra.assign(data, data + static_cast<std::ptrdiff_t>(4 * out.width) * out.height);
  cairo_surface_destroy(surface);
  return out;
}

std::vector<std::string> labels(const PlotScale& scale) {
  std::vector<std::string> out;
  for (const PlotTick& tick : scale.ticks())
    if (!tick.label.empty()) out.push_back(tick.label);
  return out;
}

Plot bars(std::vector<double> heights) {
  Plot plot;
  plot.x.names.assign(heights.size(), "one");
  plot.series = {{.kind = Kind::bars, .y = std::move(heights), .color = view::Color{1, 0, 0, 1}}};
  return plot;
}

TEST(PlotScale, ticks_are_round_and_the_axis_ends_on_them) {
  const PlotScale scale({}, 0.13, 4.1, 5);
  EXPECT_EQ(labels(scale), (std::vector<std::string>{"0", "1", "2", "3", "4", "5"}));
  EXPECT_EQ(labels(PlotScale({}, -0.031, 0.048, 5)),
            (std::vector<std::string>{"-0.04", "-0.02", "0.00", "0.02", "0.04", "0.06"}));
  EXPECT_EQ(scale.share(2.5), 0.5);
}

TEST(PlotScale, equal_ratios_are_equally_far_apart_on_a_logarithmic_axis) {
  const PlotScale scale({.log = true}, 1e-6, 1000, 12);
  EXPECT_EQ(labels(scale), (std::vector<std::string>{"10⁻⁶", "10⁻⁵", "10⁻⁴", "0.001", "0.01", "0.1",
                                                     "1", "10", "100", "1000"}));
  EXPECT_NEAR(scale.share(8) - scale.share(4), scale.share(2e-4) - scale.share(1e-4), 1e-12);
  EXPECT_FALSE(std::isfinite(scale.share(0.0)));
  EXPECT_LE(labels(PlotScale({.log = true}, 1e-30, 1e30, 6)).size(), 7u);
  const PlotScale near({.log = true}, 51, 1600, 12);
  EXPECT_EQ(labels(near), (std::vector<std::string>{"50", "100", "200", "500", "1000", "2000"}));
  EXPECT_EQ(near.high(), 2000);
}

TEST(PlotScale, limits_that_are_given_stand_and_data_that_is_none_or_one_still_has_an_axis) {
  const PlotScale given({.low = 0.5, .high = 1.0}, 0, 7, 5);
  EXPECT_EQ(given.low(), 0.5);
  EXPECT_EQ(given.high(), 1.0);
  const double inf = std::numeric_limits<double>::infinity();
  for (const auto& [low, high] : {std::pair{inf, -inf}, {3.0, 3.0}, {0.0, 0.0}, {-2.0, -2.0}}) {
    const PlotScale scale({}, low, high, 5);
    EXPECT_LT(scale.low(), scale.high());
    EXPECT_GE(scale.ticks().size(), 2u);
    EXPECT_TRUE(!std::isfinite(low) || (scale.share(low) >= 0.0 && scale.share(low) < 1.0));
  }
}

TEST(Plot, the_ending_of_its_file_says_what_it_becomes) {
  const auto text = [](const std::vector<std::byte>& bytes) {
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  const std::string svg = text(draw_plot(bars({1, 2}), "prices.svg"));
  EXPECT_EQ(svg.rfind("<?xml", 0), 0u);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  EXPECT_EQ(svg.find("<image"), std::string::npos) << "lines and letters stay such";
  EXPECT_EQ(text(draw_plot(bars({1, 2}), "prices.png")).substr(1, 3), "PNG");
}

TEST(Plot, a_bar_of_twice_the_value_covers_twice_the_paper) {
  const Pixels one = drawn(bars({1, 1, 10})), two = drawn(bars({2, 2, 10}));
  const int ten = drawn(bars({0, 0, 10})).count(255, 0, 0);
  EXPECT_GT(ten, 10000);
  EXPECT_NEAR(2.0 * (one.count(255, 0, 0) - ten), two.count(255, 0, 0) - ten, 0.02 * ten);
}

TEST(Plot, what_is_not_finite_is_a_gap_and_not_a_line_through_it) {
  Plot plot;
  plot.series = {{.y = {5, 5, 5, 5}, .color = view::Color{1, 0, 0, 1}}};
  const int whole = drawn(plot).count(255, 0, 0);
  plot.series[0].y = {5, 5, std::nan(""), 5, 5};
  const int gap = drawn(plot).count(255, 0, 0);
  EXPECT_GT(whole, 3000);
  EXPECT_NEAR(gap, whole / 2, whole / 20);
}

TEST(Plot, an_error_bar_reaches_as_far_as_the_error_and_the_axis_makes_room_for_it) {
  Plot plot = bars({4, 4});
  plot.series[0].error = {0, 5};
  plot.y.low = 0;
  plot.y.high = 10;
  const Pixels p = drawn(plot);
  const int ink_left = p.top_of(35, 32, 29, p.width / 5, p.width / 2 - 20);
  const int ink_right = p.top_of(35, 32, 29, p.width / 2 + 20, p.width - 60);
  const int red = p.top_of(255, 0, 0, 0, p.width);
  // From 4 up to 9, where the bar from 0 to 4 is 0.8 as high as that.
  EXPECT_GT(ink_left, red);
  EXPECT_LT(ink_right, red);
  EXPECT_NEAR(1.25 * (ink_left - red), red - ink_right, 6);
  plot.y = {};
  EXPECT_GT(drawn(plot).top_of(255, 0, 0, 0, p.width), p.height / 3) << "the axis ends above 9";
}

TEST(Plot, long_names_a_crowded_legend_and_notes_stay_on_the_paper) {
  Plot plot = bars(std::vector<double>(16, 1.0));
  for (std::string& name : plot.x.names) name = "+ slump (and volume), stiff";
  plot.title = std::string(90, 'T');
  plot.subtitle = "on 400 × 360, 달항아리";
  plot.y.label = "microseconds";
  for (int n = 0; n < 12; ++n)
    plot.series.push_back({.name = "a series with a long name", .kind = Kind::points, .y = {1, 2}});
  plot.notes = {{0, 2, "at the upper edge"}, {15, 1, "a note at the right edge of all of it"}};
  const Pixels p = drawn(plot);
  for (int x = 0; x < p.width; x += 3)
    for (const int y : {2, 12, p.height - 12, p.height - 3}) EXPECT_TRUE(p.paper(x, y)) << x;
  for (int y = 0; y < p.height; y += 3)
    for (const int x : {2, 12, p.width - 12, p.width - 3}) EXPECT_TRUE(p.paper(x, y)) << y;
}

}  // namespace
}  // namespace onggi::drawing::plot_test
