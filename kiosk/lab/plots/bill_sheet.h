#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace onggi::plots {

/// A cost sheet as plain values: a line for each effect, with three figures, each drawn as a bar
/// relative to the largest of its column.
struct BillSheet {
  std::string title, subtitle;
  std::string foot;  ///< Machine and command.
  std::array<std::string, 3> columns;
  struct Row {
    std::string name;
    std::array<double, 3> figures{};  ///< A negative figure has no bar.
  };
  std::vector<Row> rows;
};

/// The picture's bytes: an SVG if the name of `file` ends in ".svg", else a PNG, 1600 pixels wide.
/// Allocates; any thread.
std::vector<std::byte> draw_bill(const BillSheet& bill, const std::string& file);

}  // namespace onggi::plots
