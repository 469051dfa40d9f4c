#pragma once

#include <utility>

#include "engine/clay/clay.h"

/// The pot and the tool that the paper's equations are tried on (engine/docs/paper.md).
namespace onggi::papers_pot {

inline constexpr double kRadius = 0.008;  // of the tool
inline constexpr double kTau = 0.00949;   // c_eta = 10 at 1 kHz

/// The pot: one sheet, of 5 cm radius.
inline ClayDef sheet(double outer = 0.05) {
  ClayDef def;
  def.height = 0.072;
  def.outer_radius = outer;
  def.inner_radius = def.radius_min = 0.0001;
  def.floor_thickness = 0.0;
  def.wall_min = 0.0005;
  return def;
}

inline Clay made(const ClayDef& def) { return std::move(*Clay::create(def)); }

}  // namespace onggi::papers_pot
