#pragma once

#include <string>

#include "kiosk/ground/files/json.h"
#include "kiosk/keepsake/store/published.h"

namespace onggi::store {

/// What may be handed on, as JSON: {from, to, least, visits, brief, keepsakes, pots,
/// active_minutes, median_minutes, throwing_minutes, likeness, tables: {vessel: [{name, visits,
/// keepsakes, active_minutes, likeness}], ...}}. null: left out, or there is none; a table without
/// lines likewise. Minutes and likeness to the tenth.
files::Json json_of(const PublishedStatistics& statistics);

/// A line a cell: table,name,visits,keepsakes,active_minutes,likeness; the first is `all`. What is
/// left out is empty. What a spreadsheet would take for a formula gets an apostrophe before it.
std::string csv_of(const PublishedStatistics& statistics);

/// The same for a report in words: a paragraph, then the tables that people ask for.
std::string words_of(const PublishedStatistics& statistics);

}  // namespace onggi::store
