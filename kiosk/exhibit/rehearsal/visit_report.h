#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/exhibit/rehearsal/scripted_visitor.h"
#include "kiosk/ground/files/json.h"

namespace onggi::rehearsal {

/// JSON of a kept visit: {vessel, score, stars, measures, state_hash, ticks, screens[], files[]}.
/// Lengths in metres; state_hash as 16 hexadecimal digits. A naive visitor's also has {naive:
/// {roughness, ledge, handsome_at}}: metres, and seconds or null.
files::Json visit_report(const exhibit::KeptVisit& kept,
                         const std::vector<std::filesystem::path>& screens,
                         const std::optional<ScriptedVisitor::Looks>& looks = std::nullopt);

/// A summary for people: the score, and the place of the postcard.
std::string visit_summary(const exhibit::KeptVisit& kept);

/// All measures: lengths in metres, distances of the outlines as shares of the
/// target's height, angles in degrees.
files::Json json_of(const Measures& m);

/// 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

}  // namespace onggi::rehearsal
