#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/settings/translations.h"

namespace onggi::content {

/// A colour as light: linear, 0..1 each. Files use sRGB, "#9DB5A0".
using LinearColor = std::array<float, 3>;

/// How a fired pot looks: its clay, the layers on it, and the glass over all. The defaults are a
/// celadon's.
struct GlazeLook {
  LinearColor body{0.402f, 0.181f, 0.0823f};  ///< The fired clay: foot and section.
  /// Light that a full coat lets through, down and back.
  LinearColor glass{0.3372f, 0.4621f, 0.3515f};
  LinearColor slip{0.80f, 0.78f, 0.72f};  ///< Clay of another colour under the glass.
  float slip_cover = 1.0f;  ///< 0 no slip .. 1 hides the body, except where the coat is thin.
  float brushed = 0.0f;     ///< 0 dipped .. 1 brushed on coarsely, so that the body shows between.
  float pooling = 0.75f;    ///< 0 even .. 1 runs deep into grooves and off ridges.
  float gloss = 0.9f;       ///< 0 matt .. 1 like a mirror.
  LinearColor band{0.0284f, 0.0704f, 0.2016f};  ///< Painted round the pot, under the glass.
  float band_height = 0.0f;                     ///< Its middle, share of the pot's height, 0..1.
  float band_width = 0.0f;                      ///< Share of the height, 0..0.2; 0: no band.
  friend bool operator==(const GlazeLook&, const GlazeLook&) = default;
};

/// A glaze that visitors can choose.
struct Glaze {
  std::string id;                            ///< Lower-case letters, digits and _; 1..40 of them.
  std::map<std::string, std::string> name;   ///< By language: "Celadon".
  std::map<std::string, std::string> about;  ///< By language: a sentence or two; may be empty.
  GlazeLook look;

  /// The name in `language`, else in English, else in the first language; empty if there is none.
  const std::string& name_in(const std::string& language) const;
  const std::string& about_in(const std::string& language) const;
};

inline constexpr std::size_t kMostGlazes = 8;

/// The glazes of a file, and everything wrong in it, with line and column.
struct GlazesRead {
  std::vector<Glaze> glazes;  ///< The good ones, in the file's order; at most kMostGlazes.
  std::vector<Problem> problems;
  int keys_checked = 0;
};

/// Reads content/glazes.toml, a [[glaze]] each (kiosk/docs/glazes.md). Each glaze needs a name in
/// all of `languages`. A glaze without id, name or colours is left out; an invalid number gets its
/// default. `translations` come before its own texts.
GlazesRead read_glazes(const std::filesystem::path& file,
                       const std::vector<std::string>& languages = {},
                       const settings::Translations& translations = {});

/// The colour on a wall in plain light, linear: for a swatch.
LinearColor swatch(const GlazeLook& look);

}  // namespace onggi::content
