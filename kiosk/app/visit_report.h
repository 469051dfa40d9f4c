#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "kiosk/app/kiosk.h"

namespace onggi::app {

/// JSON of a kept visit: {vessel, score, stars, measures, state_hash, ticks, screens[], files[]}.
/// Lengths in metres; state_hash as 16 hexadecimal digits. Ends with a line feed.
std::string visit_report(const KeptVisit& kept, const std::vector<std::filesystem::path>& screens);

/// The same for a person: what it scored and where the postcard lies.
std::string visit_summary(const KeptVisit& kept);

/// A JSON object of all measures: lengths in metres, distances of the outlines as shares of the
/// target's height, angles in degrees.
std::string measures_json(const Measures& m);

/// 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

}  // namespace onggi::app
