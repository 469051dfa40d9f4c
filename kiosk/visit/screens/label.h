#pragma once

#include <string>
#include <vector>

#include "kiosk/collection/content/language.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// "Korea, Joseon dynasty, 18th century": what of it is there, as `language` lists it.
std::string label_line(const content::Label& label, const content::Language& language);

/// Metres as centimetres with one decimal where it is not a whole number: "30.5", in German "30,5".
std::string centimetres(double metres, const content::Language& language);

/// "0.93" of 93, "0.9" of 90, "1" of 100; in German "0,93".
std::string hundredths(long number, const content::Language& language);

/// One sentence after the other; of two, with what the writing has between them.
std::string joined(const std::string& words, const std::string& sentence);

/// Paragraphs that go on one page.
using LabelPart = std::vector<std::string>;

/// Pixels between paragraphs of `style`.
float paragraph_gap(const view::TextStyle& style);

/// `paragraphs` (empty ones left out) broken between sentences into parts that each fit `box`. At
/// least one part; a single sentence that does not fit makes the page overflow.
std::vector<LabelPart> parts_that_fit(Page& page, const std::vector<std::string>& paragraphs,
                                      const view::TextStyle& style, const view::Rect& box);

/// Sentences of a text, each with the space after it left off.
std::vector<std::string> sentences(const std::string& text);

}  // namespace onggi::screens
