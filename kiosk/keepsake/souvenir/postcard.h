#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/profile/profile.h"
#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/measure.h"

namespace onggi::souvenir {

/// The content of a postcard; words are already in the visitor's language.
struct PostcardWords {
  std::string title;        ///< "My pot, inspired by: Moon jar"
  std::string vessel;       ///< Culture and date of the vessel it answers.
  std::string credit;       ///< The museum's.
  std::string date;         ///< Already formatted.
  std::string decorated{};  ///< "Decorated: cut, flooded". May be empty.
  std::string glaze;        ///< And the size: "Celadon, 175 mm high". May be empty.
  std::string language = "en";
  bool right_to_left = false;  ///< Right-to-left language: words and drawing change sides.
  std::string address;         ///< The museum's page about the vessel, as a QR code; may be empty.
  std::string address_words;   ///< Words below it, if both codes are there.
  std::string phone;  ///< The visitor's own page, as a larger code; empty: no phone can fetch it.
  std::string phone_words;  ///< Words below it: what it is, and until when it is valid.
};

inline constexpr int kPostcardWidth = 1500, kPostcardHeight = 2100;

/// Composes the postcard, once for screen and file: the pot alone on plaster with its glaze
/// (absent: dry clay), title, vessel, credit, a hairline section of `made` (dark) over
/// `target` (pale) in one corner, and beside it the QR codes, dark on the plaster with their quiet
/// zones.
view::Frame compose_postcard(const PostcardWords& words, const Profile& made, const Profile& target,
                             const view::TextMeasure& measure,
                             const std::optional<view::Glazing>& glazing = view::Glazing{});

}  // namespace onggi::souvenir
