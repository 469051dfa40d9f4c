#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/picture/view/frame.h"

namespace onggi::plots {

/// The cost of accuracy in time, as plain values: microseconds across, millimetres up, both in
/// decades. To the right of `limit` a tick has no time left.
struct AccuracyChart {
  std::string title, subtitle;
  std::string says;  ///< The caption: the recommendation; then machine, date, commit and command.

  struct Mark {
    double us = 0.0, mm = 0.0;
    std::string name{};  ///< Beside it; empty: none.
    bool broke = false;  ///< Ringed: random hands broke this setting.
  };
  /// A group: a line through its marks, from left to right.
  struct Line {
    std::string name;
    view::Color color{};
    bool hollow = false;  ///< Marks are circles instead of discs.
    bool dashed = false;
    bool above = false;  ///< Names are above their marks; else below, to the left.
    std::vector<Mark> marks;
  };
  std::vector<Line> lines;
  std::vector<Mark> cloud;  ///< All other settings, small and faint.
  std::vector<Mark> edge;   ///< Settings that nothing beats: a bold step line, left to right.
  std::optional<Mark> chosen;

  /// The smallest error that a person or a device can notice, mm.
  struct Threshold {
    double mm = 0.0;
    std::string name;
  };
  std::vector<Threshold> thresholds;
  double limit = 1000.0;  ///< us: a tick's time.
  double unsure = 0.0;    ///< mm: below it the reference itself is uncertain.

  /// A pot seen from the side, each place coloured by its error.
  struct Pot {
    std::string name, below;  ///< Two lines under it.
    int columns = 0, rows = 0;
    double height = 0.1;        ///< From the lowest row to the highest, m.
    std::vector<float> radius;  ///< m, row by row, foot first.
    std::vector<float> off;     ///< m
    bool chosen = false;
    std::optional<Mark> at{};  ///< The mark of its setting, beside which it is also drawn small.
  };
  std::vector<Pot> pots;

  /// The force panel, by grid. Colours and marks are those of the lines.
  struct Force {
    view::Color color{};
    bool hollow = false;
    std::vector<double> elements;  ///< Rows times sectors, millions.
    std::vector<double> force;     ///< Felt force, as a multiple of the true one.
  };
  std::vector<Force> forces;
  double force_told = 0.07;  ///< Smallest change of force that a hand notices, as a share.
};

/// The picture's bytes: an SVG if the name of `file` ends in ".svg", else a PNG, 2000 x 1710.
/// Allocates; any thread.
std::vector<std::byte> draw_accuracy(const AccuracyChart& chart, const std::string& file);

}  // namespace onggi::plots
