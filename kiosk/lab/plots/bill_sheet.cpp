#include "kiosk/lab/plots/bill_sheet.h"

#include <algorithm>
#include <cstdio>

#include "kiosk/ground/files/output_kind.h"
#include "kiosk/picture/drawing/pen.h"
#include "kiosk/picture/view/palette.h"

namespace onggi::plots {
namespace {

constexpr int kBillWide = 1600, kBillTop = 250, kBillRow = 64;
constexpr double kBillMargin = 70, kNames = 220, kColumn = 410, kBar = 270, kFigureText = 24;
constexpr std::array<view::Color, 3> kBars{view::kCobalt, view::kDeepCeladon, view::kIron};

class BillPainter : private drawing::Pen {
 public:
  std::vector<std::byte> draw(const BillSheet& bill, bool vector);

 private:
  void draw_row(const BillSheet::Row& row, const std::array<double, 3>& most, double top);
};

void BillPainter::draw_row(const BillSheet::Row& row, const std::array<double, 3>& most,
                           double top) {
  words(row.name, kBillMargin, top + 10, {.px = kFigureText, .color = view::kInk});
  for (std::size_t n = 0; n < most.size(); ++n) {
    const double left = kBillMargin + kNames + kColumn * static_cast<double>(n);
    const double share = most[n] > 0.0 ? std::max(row.figures[n], 0.0) / most[n] : 0.0;
    ink(kBars[n]);
    cairo_rectangle(c_, left, top + 12, std::max(share * kBar, 1.5), 28);
    cairo_fill(c_);
    char figure[32];
    std::snprintf(figure, sizeof figure, n == 0 ? "%.1f" : "%.3f", row.figures[n]);
    words(figure, left + std::max(share * kBar, 1.5) + 12, top + 10,
          {.px = kFigureText, .color = view::kInk});
  }
  ink(view::kFaintInk, 0.2);
  line(kBillMargin, top + kBillRow - 6, kBillWide - kBillMargin, top + kBillRow - 6, 1.2);
}

std::vector<std::byte> BillPainter::draw(const BillSheet& bill, bool vector) {
  begin(kBillWide, kBillTop + kBillRow * static_cast<int>(bill.rows.size()) + 90, vector);
  double at = 40;
  at += words(bill.title, kBillMargin, at, {.px = 42, .color = view::kInk, .serif = true}) + 4;
  words(bill.subtitle, kBillMargin, at,
        {.px = kFigureText, .color = view::kFaintInk, .width = kBillWide - 2 * kBillMargin});
  std::array<double, 3> most{};
  for (std::size_t n = 0; n < most.size(); ++n) {
    words(bill.columns[n], kBillMargin + kNames + kColumn * static_cast<double>(n), kBillTop - 52,
          {.px = kFigureText, .color = kBars[n]});
    for (const BillSheet::Row& row : bill.rows) most[n] = std::max(most[n], row.figures[n]);
  }
  ink(view::kInk);
  line(kBillMargin, kBillTop - 12, kBillWide - kBillMargin, kBillTop - 12, 2);
  double top = kBillTop;
  for (const BillSheet::Row& row : bill.rows) {
    draw_row(row, most, top);
    top += kBillRow;
  }
  words(bill.foot, kBillMargin, top + 24, {.px = 17, .color = view::kFaintInk});
  return bytes();
}

}  // namespace

std::vector<std::byte> draw_bill(const BillSheet& bill, const std::string& file) {
  return BillPainter().draw(bill, files::is_svg(file));
}

}  // namespace onggi::plots
