#pragma once

#include <array>
#include <string>
#include <vector>

#include "kiosk/collection/content/language.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// "Korea, Joseon dynasty, 18th century": the available parts as a list in `language`.
std::string label_line(const content::Label& label, const content::Language& language);

/// What stands below a title where there is little room: what it is and whose it was. Of a vessel
/// that does not say what it is: whose it was, and when.
std::array<std::string, 2> under_title(const content::Label& label);

/// Metres as centimetres, with one decimal if it is not zero: "30.5", in German "30,5".
std::string centimetres(double metres, const content::Language& language);

/// "0.93" for 93, "0.9" for 90, "1" for 100; in German "0,93".
std::string hundredths(long number, const content::Language& language);

/// Joins sentences, with the separator of their script.
std::string joined(const std::string& words, const std::string& sentence);

using LabelPart = std::vector<std::string>;

/// Pixels between paragraphs of `style`.
float paragraph_gap(const view::TextStyle& style);

/// Breaks `paragraphs` (leaving out empty ones) between sentences into parts that each fit `box`.
/// At least one part. A single sentence that does not fit makes the page overflow.
std::vector<LabelPart> parts_that_fit(Page& page, const std::vector<std::string>& paragraphs,
                                      const view::TextStyle& style, const view::Rect& box);

/// Sentences of a text, without the space after each.
std::vector<std::string> sentences(const std::string& text);

}  // namespace onggi::screens
