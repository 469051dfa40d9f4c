#include "kiosk/picture/drawing/put_report.h"

#include <iostream>

namespace onggi::drawing {

Result<bool> put_report(const files::Json& report, const files::Output& output) {
  if (!output.wanted()) return true;
  return output.write(report.text() + "\n").map([&output] { return !output.to_stdout(); });
}

Result<void> put_report(const files::Json& report, const std::string& words,
                        const drawing::Plot& plot, const files::Output& json,
                        const files::Output& picture) {
  const auto put = put_report(report, json);
  if (!put) return tl::unexpected(put.error());
  if (*put && !picture.to_stdout()) std::cout << words;
  if (!picture.wanted()) return {};
  return picture.write(drawing::draw_plot(plot, picture.where()));
}

}  // namespace onggi::drawing
