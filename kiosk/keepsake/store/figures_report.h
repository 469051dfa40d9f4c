#pragma once

#include <string>

#include "kiosk/ground/files/json.h"
#include "kiosk/keepsake/store/anonymised_statistics.h"

namespace onggi::store {

/// The statistics that may be published, as JSON: {from, to, least, visits, brief, keepsakes, pots,
/// active_minutes, median_minutes, throwing_minutes, likeness, tables: {vessel: [{name, visits,
/// keepsakes, active_minutes, likeness}], ...}}. null: left out, or not present; the same for a
/// table without lines. Minutes and likeness to the tenth.
files::Json json_of(const AnonymisedStatistics& statistics);

/// One line a cell: table,name,visits,keepsakes,active_minutes,likeness; the first is `all`.
/// Suppressed values are empty. Text that a spreadsheet would read as a formula gets an apostrophe
/// before it.
std::string csv_of(const AnonymisedStatistics& statistics);

/// The same for a report in words: a paragraph, then the tables that people ask for.
std::string words_of(const AnonymisedStatistics& statistics);

}  // namespace onggi::store
