#include "kiosk/lab/measure/bill_plot.h"

#include <cstdio>
#include <string>

namespace onggi::measure {

plots::BillSheet sheet_of(const tuning::SceneBill& bill) {
  plots::BillSheet sheet;
  char words[200];
  sheet.title = "What " + bill.scene + " pays for";
  std::snprintf(words, sizeof words,
                "A tick takes %.1f µs on %d × %d rows and sectors, both hands on the wall; contact "
                "alone would take %.1f.",
                bill.whole_us, bill.rows, bill.sectors, bill.contact_us);
  sheet.subtitle = words;
  sheet.foot = bill.machine + "; " + bill.command +
               "; the scene as it is against the scene without that effect; no chance in it";
  if (const std::string doubt = tuning::doubt_of(bill); !doubt.empty())
    sheet.subtitle += " " + doubt;
  sheet.columns = {"time, µs", "shape, mm (rms)", "force, N (rms)"};
  for (const tuning::BillLine& line : bill.lines)
    sheet.rows.push_back({(line.part_of.empty() ? "" : "   ") + line.effect,
                          {line.us, line.shape_mm, line.force_n}});
  return sheet;
}

}  // namespace onggi::measure
